//! Linear stability of y' = A y, exactly: characteristic polynomial, roots in either half-plane, signs of a quadratic form.
//!
//! # Overview
//! * [`characteristic`]: det(mu - A) without a division, for any size;
//! * [`HalfPlanes`]: the numbers of roots to the left of the imaginary axis, on it and to the right of it, by Routh's array
//!   as the remainders of Euclid's algorithm: rows that vanish or begin with zero are no exception;
//! * [`growth`]: the largest real part of a root, between two numbers;
//! * [`real_roots`]: the number of different real roots, by Sturm's theorem over the same numbers;
//! * [`Inertia`]: the signs of a quadratic form, also on the subspace where given linear forms vanish;
//! * [`resultant`]: decides whether polynomials over a ring have a common root.
//!
//! # Key results
//! Numbers are [`Ordered`](algebra::real::Ordered): fractions know their signs, enclosures know them unless zero lies among their values. A number of
//! roots or of signs is returned only if every sign that it depends on is known; with enclosures it is proved for all numbers in them. Otherwise the
//! answer is `None`. Finer enclosures may then succeed, unless a deciding quantity is exactly zero.
//!
//! # References
//! Berkowitz 1984 (the polynomial); Routh 1877, Gantmacher 1959 chapter XV (the count, singular cases included).

mod characteristic;
mod growth;
mod half_planes;
mod inertia;
mod resultant;

pub use characteristic::characteristic;
pub use growth::growth;
pub use half_planes::{HalfPlanes, real_roots};
pub use inertia::Inertia;
pub use resultant::{derivative, resultant};
