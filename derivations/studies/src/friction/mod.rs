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
//! * [`held`]: one regime held without a look at its conditions, and by how much they hold; [`smoothed`]: contacts made smooth;
//! * [`run`](mod@run): stretch after stretch; [`log`]: what happened and why;
//! * [`rough`], [`scene`]: systems with contacts and their files; [`course`]: runs as names and numbers;
//! * [`across`]: every method on a scene, for its atlas;
//! * [`exact`]: the motion to all digits that two methods share;
//! * [`closed`]: motions in closed form, beside which runs are checked.

pub mod across;
pub mod choose;
pub mod closed;
pub mod course;
pub mod exact;
pub mod held;
pub mod log;
pub mod rough;
pub mod run;
pub mod scene;
pub mod settle;
pub mod smoothed;
pub mod stretch;

pub use closed::Check;
pub use course::Course;
pub use log::{Cause, Ending, Entry};
pub use rough::Rough;
pub use run::{Run, run};
pub use scene::{ForRough, RoughScene};
