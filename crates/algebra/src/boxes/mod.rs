//! All zeros of nonlinear equations in a box, with a proof of completeness: branch and prune with interval Newton
//! methods.
//!
//! A box in which an equation has no zero is discarded; propagation through single equations narrows boxes. The
//! interval Newton method (Hansen and Sengupta 1981) then keeps the part that may contain zeros. Krawczyk's operator K
//! proves that a box contains exactly one zero:
//!
//!   K(X) = m - C f(m) + (1 - C f'(X)) (X - m) inside X ,    C about f'(m)^-1 .
//!
//! A box that can be neither discarded nor proved to contain one zero is bisected. Boxes of the smallest size are
//! reported as undecided.

mod existence;
mod halves;
mod newton;
mod search;
mod signs;
mod subsystem;

pub use halves::halves;
pub use search::{Found, Limits, Zero, zeros};

use field::Interval;

/// A system of as many equations as unknowns, over intervals.
pub trait Equations {
    /// The number of unknowns along which boxes are bisected; they come first.
    fn divided(&self) -> usize;

    /// The number of unknowns that are functions of the others.
    fn determined(&self) -> usize {
        0
    }

    /// Narrows a box of all unknowns to a part that contains all zeros; the determined unknowns begin unbounded.
    /// Returns false where there is no zero.
    fn narrow(&mut self, _at: &mut [Interval]) -> bool {
        true
    }

    /// Bounds the determined unknowns of a box, which come last. Returns false where there are no bounds.
    fn bound(&mut self, _at: &mut [Interval]) -> bool {
        true
    }

    /// Writes the ranges of all equations over a box.
    fn values(&mut self, at: &[Interval], values: &mut [Interval]);

    /// Writes the ranges of the derivatives, row by row.
    fn slopes(&mut self, at: &[Interval], slopes: &mut [Interval]);
}
