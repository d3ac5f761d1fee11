//! Systems as text: a TOML file becomes a model, and the model a run.
//!
//! # Overview
//! * [`ModelScene`]: a file with `[coordinates]`, read and checked; every command that runs a scene runs it;
//! * [`text`]: the tables of a file as a [`model::Source`];
//! * [`CompiledSystem`]: the equations of motion as machine code, as series, and over every field that runs.

mod admissible;
mod compiled_system;
mod first_motion;
mod implicit;
mod modes;
mod quoted_keys;
mod readiness;
mod scene;
mod start;
pub mod text;

pub use compiled_system::{CompiledSystem, NotCompiled};
pub use modes::Case;
pub use scene::{ModelScene, read_model, register};
pub use start::{Open, Unmet, consistent};
