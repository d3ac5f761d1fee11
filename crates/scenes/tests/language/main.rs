//! The language of scene files: the JSON schema for editors and the reference in the book have exactly the keys of the reader, and every
//! example in them is read.

mod examples;
mod expressions;
mod gyrostat;
mod motors;
mod page;
mod schema;
mod sections;
mod values;

// registers the motors of the catalogue and the systems with additional knowledge
use machines as _;
