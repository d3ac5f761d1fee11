//! Exact linear stability of a one-step method at a steady motion, for every step size.
//!
//! Near a steady motion x' = A x. A Runge-Kutta method with the step size h has the matrix R(h A), where R = P/Q is its
//! stability function. An eigenvalue mu of A becomes the multiplier R(h mu): under the method the mode
//!
//! decays, keeps its amplitude or grows as |P(h mu)|^2 - |Q(h mu)|^2 is negative, zero or positive:
//!
//! one real polynomial in h for each mode, whose positive roots are the thresholds of the step size. Between two
//! thresholds a mode decays, is constant or grows throughout. The method is correct if this agrees with the sign of Re
//! mu. (The Schur-Cohn conditions on R(h A) state this for all modes at once.)
//!
//! # Overview
//! * [`Spectrum`]: the eigenvalues of a matrix, in disjoint enclosures, from its characteristic polynomial;
//! * [`StabilityFunction`]: R, with rational coefficients;
//! * [`Fates`]: the step sizes for which one mode decays or grows;
//! * [`Steps`]: the result for all modes and every step size.
//!
//! # Key results
//! Roots are enclosed and counted, so that no interval of step sizes is missed. Imaginary eigenvalues follow from a
//! theorem named by the caller (conservation of energy), never from a small real part; their thresholds depend on the
//! method alone.

mod fates;
mod function;
mod spectrum;
mod steps;

pub use fates::{Fates, UndecidedFate};
pub use function::StabilityFunction;
pub use spectrum::{HalfPlane, Mode, Spectrum};
pub use steps::{Judgement, StepInterval, Steps};
