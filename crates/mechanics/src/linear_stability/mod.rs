//! Exact linear stability of y' = A y: characteristic polynomial, roots in each half-plane, inertia of a quadratic
//! form.
//!
//! # Overview
//! * [`characteristic`]: det(mu - A) without a division, for any size;
//! * [`HalfPlanes`]: the numbers of roots in the left half-plane, on the imaginary axis and in the right half-plane, by
//!   Routh's array as the remainders of Euclid's algorithm, including the singular cases of rows that vanish or begin
//!   with zero;
//! * [`growth`]: bounds of the largest real part of a root;
//! * [`real_roots`]: the number of distinct real roots, by Sturm's theorem;
//! * [`Inertia`]: the signs of a quadratic form, also on a subspace;
//! * [`resultant`]: decides whether polynomials over a ring have a common root.
//!
//! # Key results
//! Numbers implement [`Ordered`](algebra::real::Ordered): fractions have known signs, enclosures have them unless they
//! contain zero. A result is returned only if every sign that it depends on is known; with enclosures it is proved for
//! all numbers in them. Otherwise the result is `None`. Finer enclosures may then succeed, unless a deciding quantity
//! is exactly zero.
//!
//! # References
//! Berkowitz 1984 (characteristic polynomial); Routh 1877, Gantmacher 1959 chapter XV (number of roots, including
//! singular cases).

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
