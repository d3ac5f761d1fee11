//! The parts of a run that do not depend on the method: input, observation, outcome.
//!
//! # Overview
//! * input: [`Span`], [`Budget`], [`Tolerance`];
//! * during the run: the right-hand side with its budget (`budgeted_rhs`), the loop over steps (`stepping`), the
//!   actions after each step (`watch`), states within a step (`within`), the [`clock`];
//! * output: to an [`Observer`] during the run, and as an [`Outcome`] with an [`End`](crate::End) afterwards.

pub(crate) mod brink;
pub(crate) mod budgeted_rhs;
pub mod clock;
pub(crate) mod failure;
mod observer;
pub(crate) mod outcome;
mod span;
pub(crate) mod stepping;
mod tolerance;
pub(crate) mod watch;
pub(crate) mod within;

pub use failure::{Failure, Refusal};
pub use observer::{Observer, Progress, Record, Samples, Sizes};
pub use outcome::{Deviation, End, LOST, Lost, Outcome, Work};
pub use span::{Budget, Monitor, Quantity, Span};
pub use tolerance::{Absolute, Tolerance};
