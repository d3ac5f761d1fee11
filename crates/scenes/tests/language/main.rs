//! The language of scene files: its schema for editors and its reference in the book have the keys that the reader knows, and every
//! example in them is read.

mod examples;
mod expressions;
mod gyrostat;
mod motors;
mod page;
mod schema;
mod sections;
mod values;

// motors that drives name, and systems of which more is known
use machines as _;
