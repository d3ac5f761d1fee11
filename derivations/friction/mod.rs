//! Motion with friction across its events.
//!
//! # Overview
//! A run is a sequence of stretches, each in one regime of the contacts. A stretch ends where a condition of its regime
//! fails, where sliding stops, where an open gap closes, or where the regime is no longer the only motion; there the
//! regimes are decided anew. What cannot be decided is not guessed: the run stops with that diagnosis.
//!
//! * [`stretch`]: the right-hand side of a regime, and the signals that end it;
//! * [`settle`]: the state of an event made to satisfy the constraints and the contacts that stay closed;
//! * [`choose`]: the regime that goes on from a state, ties decided by the rates of their margins;
//! * [`run`](mod@run): stretch after stretch; [`log`]: what happened and why;
//! * [`scene`]: systems with contacts from files.

pub mod choose;
pub mod log;
pub mod run;
pub mod scene;
pub mod settle;
pub mod stretch;

pub use log::{Cause, Ending, Entry};
pub use run::{Run, run};
pub use scene::{ForRough, Rough, RoughScene};
