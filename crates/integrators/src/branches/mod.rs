//! Continuation: curves of solutions of n equations in n + 1 unknowns.
//!
//! # Overview
//! * [`Curve`]: the equations, with their derivatives;
//! * [`follow`]: pseudo-arclength continuation (Keller 1977), through folds, each located to rounding: saddle-node
//!   bifurcations of equilibria;
//! * [`Equilibria`]: states where the rates of a law vanish, its steady states;
//! * [`PeriodicMotions`]: motions that are periodic up to a shift, such as a whole turn, by shooting;
//! * [`spectrum`]: eigenvalues and Floquet multipliers, which decide linear stability.
//!
//! A parameter is a state that is constant: a law whose last rate is zero has its last state for parameter, and the
//! derivatives by it come with those by the states. (`russell_nonlin` follows curves too; it brings sparse solvers in C,
//! stops on folds no nearer than a step, and has no periodic motions.)

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

/// n equations in n + 1 unknowns.
pub trait Curve {
    /// n + 1.
    fn unknowns(&self) -> usize;

    /// The residual of each equation at x, and the Jacobian: `matrix[i * (n + 1) + j]` is the derivative of equation i
    /// by unknown j.
    ///
    /// # Errors
    /// [`Failure`] where the equations have no value.
    fn evaluate(&mut self, x: &[f64], residual: &mut [f64], matrix: &mut [f64]) -> Result<(), Failure>;
}
