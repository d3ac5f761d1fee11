//! Integrators of ordinary differential equations y' = f(t, y).
//!
//! # Overview
//! A law is written once ([`Ode`], [`System`]) and run by any [`Method`] through one entry, [`integrate`]: adaptors to
//! well-kept crates, and the methods that no crate has, over `f64` and double-double alike. A run has a budget, is shown
//! to an [`Observer`], and ends in an [`Outcome`] that either reached its end or names one of a closed set of failures,
//! with the last good state.

mod adaptors;
mod classical;
mod collocation;
mod drive;
mod failure;
mod gragg;
mod implicit;
mod jacobian;
mod lu;
mod meter;
mod method;
mod observer;
mod ode;
mod outcome;
mod real;
mod reference;
mod span;
mod taylor;
mod tolerance;
mod watch;
mod work_precision;

pub use collocation::{Collocation, Family};
pub use failure::{Failure, Refusal};
pub use jacobian::Jacobian;
pub use method::{MOST_STAGES, Method, Traits, integrate, integrate_in};
pub use observer::{Observer, Progress, Record, Samples};
pub use ode::{DIRECTIONS, Directions, Ode, System, Working};
pub use outcome::{Deviation, End, Outcome, Work};
pub use real::Real;
pub use reference::{ENOUGH_DIGITS, Reference, reference};
pub use span::{Budget, Monitor, Span};
pub use taylor::TaylorSeries;
pub use tolerance::{Absolute, Tolerance};
pub use work_precision::{Point, work_precision};
