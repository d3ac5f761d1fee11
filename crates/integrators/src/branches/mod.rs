//! Curves of solutions: where n equations in n + 1 unknowns hold.
//!
//! # Overview
//! * [`Curve`]: the equations, with their derivatives;
//! * [`follow`]: along the curve by arclength (Keller 1977), through folds, each of which is located to rounding;
//! * [`Equilibria`]: where the rates of a law vanish;
//! * [`Repeating`]: motions that come again but for a shift, such as a whole turn, by shooting;
//! * [`spectrum`]: eigenvalues and multipliers, which tell stability.
//!
//! A parameter is a state that rests: a law whose last rate is zero has its last state for parameter, and the derivatives
//! by it come with those by the states. (`russell_nonlin` follows curves too; it brings sparse solvers in C, stops on
//! folds no nearer than a step, and knows no motions.)

mod corrector;
mod equilibria;
mod follow;
mod repeating;
mod spectrum;

pub use equilibria::Equilibria;
pub use follow::{Branch, CurvePoint, Last, Walk, follow};
pub use repeating::Repeating;
pub use spectrum::{eigenvalues, spectrum};

use crate::Failure;

/// n equations in n + 1 unknowns.
pub trait Curve {
    /// n + 1.
    fn unknowns(&self) -> usize;

    /// What is left of each equation at x, and `matrix[i * (n + 1) + j]`, its derivative by unknown j.
    ///
    /// # Errors
    /// [`Failure`] where the equations have no value.
    fn evaluate(&mut self, x: &[f64], residual: &mut [f64], matrix: &mut [f64]) -> Result<(), Failure>;
}
