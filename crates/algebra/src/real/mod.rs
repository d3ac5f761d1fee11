//! Exact real roots of polynomials: their number, isolation, and the signs of expressions at them.
//!
//! # Overview
//! * [`Number`]: an integer, or an integer polynomial in one real algebraic number ([`Field`]);
//! * [`Polynomial`]: univariate polynomials with such coefficients; greatest common divisors, remainders, subresultants
//!   (`resultant`);
//! * [`Root`]: one real root, as a polynomial with an isolating interval;
//! * [`Nested`]: one real root of a polynomial whose coefficients are polynomials in another root;
//! * `isolate`: all real roots, by Descartes' rule of signs; `sturm`: their number, independently by Sturm's theorem;
//! * [`Enclosure`]: an interval with ends that are multiples of a power of two, rounded outwards;
//! * [`TaylorModel`]: a function of a parameter as a polynomial with a bound of the remainder, in floats rounded
//!   outwards; [`Ball`]: one number in this form, to thirty digits;
//! * [`FixedPoint`]: the fixed point of a map with a parameter, enclosed for every value of a range;
//! * [`Surd`]: a fraction plus a multiple of one square root;
//! * [`Tower`]: the same with two square roots;
//! * [`Conic`]: functions on a conic, and their zeros;
//! * [`Ordered`]: the common trait of enclosures and fractions: operations, and a sign that may be unknown.
//!
//! # Key results
//! No decision depends on rounding. A sign is determined by an enclosure that excludes zero, or by a common divisor
//! that proves zero. Polynomials are represented up to a positive factor: only their roots and signs are used.
//!
//! ```
//! use dalembert_algebra::real::Polynomial;
//!
//! // (x^2 - 2) (x - 1)
//! let roots = Polynomial::from_integers([2, -2, -1, 1]).real_roots();
//! assert_eq!(roots.len(), 3);
//! assert_eq!(roots[2].enclosure(60).to_f64(), 2f64.sqrt());
//! ```
//!
//! # References
//! Collins, Akritas 1976 (isolation by Descartes' rule); Krawczyk 1969 (enclosed fixed points); Makino, Berz 2003 (Taylor models); von zur Gathen, Gerhard 2013 (remainders, subresultants).

mod conic;
mod enclosure;
mod isolate;
mod krawczyk;
mod nested;
mod number;
mod ordered;
mod polynomial;
mod resultant;
mod root;
mod sturm;
mod surd;
mod taylor_model;
mod tower;

pub use conic::{Conic, ConicPoint};
pub use enclosure::Enclosure;
pub use krawczyk::{FixedPoint, Mapped};
pub use nested::Nested;
pub use number::{Field, Number};
pub use ordered::Ordered;
pub use polynomial::Polynomial;
pub use resultant::subresultant;
pub use root::Root;
pub use surd::Surd;
pub use taylor_model::{Ball, Model, Rounded, TaylorModel};
pub use tower::Tower;
