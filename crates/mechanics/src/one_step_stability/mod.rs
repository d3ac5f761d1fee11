//! Linear stability of a one-step method on a steady motion: for every step size, exactly.
//!
//! Near a steady motion x' = A x, and a Runge-Kutta method with the step size h has the matrix R(h A), R = P/Q its
//! stability function. An eigenvalue mu of A becomes the multiplier R(h mu), and the map lets the mode
//!
//! decay, stay or grow as |P(h mu)|^2 - |Q(h mu)|^2 is negative, zero or positive:
//!
//! one real polynomial in h for each mode. Its positive roots, all of them, are where the map changes. Between two
//! roots a mode decays, stays or grows throughout; the map is right about it if the motion does likewise, by the
//! sign of Re mu. (Schur and Cohn's conditions on R(h A) say this of all modes at once.)
//!
//! # Overview
//! * [`Spectrum`]: the eigenvalues of a matrix, each enclosed and apart from the others, from its characteristic polynomial;
//! * [`StabilityFunction`]: R, with rational coefficients;
//! * [`Fates`]: the step sizes at which one mode decays and those at which it grows;
//! * [`Steps`]: all modes together, for every step size.
//!
//! # Key results
//! Roots are enclosed and counted: no window of step sizes is missed. Modes are imaginary by a theorem that the caller names
//! (energy is kept), never because a real part is small: their thresholds are numbers of the method alone.

mod fates;
mod function;
mod spectrum;
mod steps;

pub use fates::{Fates, UndecidedFate};
pub use function::StabilityFunction;
pub use spectrum::{HalfPlane, Mode, Spectrum};
pub use steps::{Judgement, StepInterval, Steps};
