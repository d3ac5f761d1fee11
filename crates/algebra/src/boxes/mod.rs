//! All zeros of nonlinear equations in a box, none missing: branch and prune with Newton's method over intervals.
//!
//! A box in which an equation has no zero is left out, by propagation through each equation alone where there is one. In the other boxes Newton's
//! method over intervals (Hansen and Sengupta 1981) keeps the part where zeros may be; Krawczyk's operator K shows that there is one and no other,
//!
//!   K(X) = m - C f(m) + (1 - C f'(X)) (X - m) inside X ,    C about f'(m)^-1 .
//!
//! A box that can neither be left out nor shown to hold one zero is halved; boxes at the smallest size are reported as
//! undecided.

mod existence;
mod halves;
mod newton;
mod search;
mod signs;
mod subsystem;

pub use halves::halves;
pub use search::{Found, Limits, Zero, zeros};

use field::Interval;

/// Equations over intervals, as many as unknowns.
pub trait Equations {
    /// The number of unknowns along which boxes are halved; they stand first.
    fn divided(&self) -> usize;

    /// The number of unknowns that the others determine.
    fn determined(&self) -> usize {
        0
    }

    /// Narrows a box of all unknowns to the part in which zeros may be, the determined ones from everything; false where
    /// there are none.
    fn narrow(&mut self, _at: &mut [Interval]) -> bool {
        true
    }

    /// Bounds for the determined unknowns of a box, which stand behind the others; false where these do not bound them.
    fn bound(&mut self, _at: &mut [Interval]) -> bool {
        true
    }

    /// The ranges of all equations over a box.
    fn values(&mut self, at: &[Interval], values: &mut [Interval]);

    /// The ranges of their derivatives, row after row.
    fn slopes(&mut self, at: &[Interval], slopes: &mut [Interval]);
}
