//! Continuation: curves of solutions of n equations in n + 1 unknowns.
//!
//! # Overview
//! * [`Curve`]: the equations, with their derivatives;
//! * [`continue_branch`]: pseudo-arclength continuation (Keller 1977) through folds (saddle-node bifurcations of
//!   equilibria), each located to rounding;
//! * [`Equilibria`]: states where the rates of a law vanish;
//! * [`PeriodicMotions`]: motions that are periodic up to a shift, such as a whole turn, by shooting;
//! * [`spectrum`]: eigenvalues and Floquet multipliers, which decide linear stability.
//!
//! The parameter is the last state of the law, with the rate zero. The derivatives with respect to the parameter are
//! then part of the Jacobian of the law. (The crate `russell_nonlin` also continues curves, but it needs sparse solvers
//! in C, locates folds only to within a step, and has no periodic motions.)

mod continuation;
mod corrector;
mod equilibria;
mod periodic_motions;
mod spectrum;

pub use continuation::{Branch, BranchEnd, ContinuationSettings, CurvePoint, continue_branch};
pub use equilibria::Equilibria;
pub use periodic_motions::PeriodicMotions;
pub use spectrum::{eigenvalues, spectrum};

use crate::Failure;

/// A system of n equations in n + 1 unknowns, whose solutions form a curve.
pub trait Curve {
    /// The number of unknowns, n + 1.
    fn unknowns(&self) -> usize;

    /// Writes the n residuals at x, and the Jacobian: `matrix[i * (n + 1) + j]` is the derivative of equation i with
    /// respect to unknown j.
    ///
    /// # Errors
    /// [`Failure`] where the equations are undefined at x.
    fn evaluate(&mut self, x: &[f64], residual: &mut [f64], matrix: &mut [f64]) -> Result<(), Failure>;
}
