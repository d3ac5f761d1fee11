//! The fields over which every law of the workbench is evaluated.
//!
//! # Overview
//! A law is a function generic over [`Scalar`]: field operations and exact constants, *no comparison*, so that no law
//! can branch on a value. Angles enter as points ([`Circle`]) of the unit circle, so that laws stay algebraic.
//!
//! | field | gives |
//! |---|---|
//! | `f64` | the simulation |
//! | [`Tangent`] over any field, num-dual's duals over `f64` | derivatives, forward mode |
//! | [`Rational`] | exact points and counterexamples |
//! | [`DoubleDouble`] | reference solutions |
//! | [`Batch`] | as many systems at once as a register is wide |
//! | `Sym` (crate `symbolic`) | proofs, printing, straight-line code |
//!
//! Key results: one suite of field laws ([`laws`]) that every field passes.
//!
//! # Example
//! ```
//! use dalembert_field::{Rational, Scalar, Tangent};
//!
//! /// x^3, over whatever x is.
//! fn cube<S: Scalar>(x: S) -> S {
//!     x * x * x
//! }
//!
//! // over exact numbers, and with the derivative 3 x^2 beside the value
//! let third = Rational::new(1, 3);
//! assert_eq!(cube(third), Rational::new(1, 27));
//! assert_eq!(cube(Tangent::variable(third)).slope, third);
//! ```

pub mod laws;

mod batch;
mod circle;
mod decimal;
mod duals;
mod elementary;
mod interval;
mod rational;
mod scalar;
mod sincos_double_double;
mod sincos_f64;
mod tangent;

pub use batch::Batch;
pub use circle::Circle;
pub use decimal::{decimal, from_decimal};
pub use elementary::Elementary;
pub use interval::Interval;
pub use rational::Rational;
pub use scalar::{Analytic, Base, Divisor, Over, Scalar};
pub use tangent::{SlopeKnowledge, Tangent};

/// Twice the precision of `f64`: an unevaluated sum of two, 106 bits, relative error about 4e-32.
pub type DoubleDouble = xprec::Df64;
