//! A run around the steps of any method: its input, its observation, its outcome.
//!
//! # Overview
//! * input: [`Span`], [`Budget`], [`Tolerance`];
//! * during the run: the right-hand side with its budget (`budgeted_rhs`), the loop around the steps (`stepping`), the work
//!   after each of them (`watch`), states between two (`within`), the [`clock`];
//! * output: to an [`Observer`] on the way, as an [`Outcome`] or a [`Failure`] at the end.

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
