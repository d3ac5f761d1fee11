//! Scalar types over which laws of motion are evaluated: floating-point, exact, with derivatives, and others.
//!
//! # Overview
//! For authors of laws and methods. A law is a function generic over [`Scalar`], which has field operations and exact
//! constants, but *no comparison*: a law cannot branch on a value. An angle is a point ([`Circle`]) of the unit circle,
//! so that laws are algebraic.
//!
//! | type | use |
//! |---|---|
//! | `f64` | simulation |
//! | [`Tangent`] over any field, the dual numbers of `num-dual` over `f64` | derivatives in forward mode |
//! | [`Rational`] | exact points and counterexamples |
//! | [`DoubleDouble`] | reference solutions |
//! | [`Batch`] | several systems at once, one in each lane of a SIMD register |
//! | `Sym` (crate `symbolic`) | proofs, printing, straight-line code |
//!
//! Every type passes the checks of the field axioms ([`laws`]).
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
pub use tangent::{DerivativeKnowledge, Tangent};

/// A double-double number: an unevaluated sum of two `f64`, 106 bits, relative error about 4e-32.
pub type DoubleDouble = xprec::Df64;
