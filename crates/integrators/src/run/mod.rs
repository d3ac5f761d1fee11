//! A run around the steps of any method: how far it goes, how it is watched, how it ends.
//!
//! # Overview
//! * asked for: [`Span`], [`Budget`], [`Tolerance`];
//! * while it lasts: the law with its budget (`budgeted_rhs`), the loop around the steps (`stepping`), what happens at each of
//!   them (`watch`), states between two (`within`), the [`clock`];
//! * told: to an [`Observer`] on the way, as an [`Outcome`] or a [`Failure`] at the end.

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
