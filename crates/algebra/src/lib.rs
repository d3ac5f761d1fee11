//! Exact and enclosed algebra over numbers: polynomials, their roots, enclosures, linear equations.
//!
//! # Overview
//! For programs that must decide a question instead of rounding a number: the number of roots, the sign of a value, the
//! box that contains a solution. The crate contains neither symbolic expressions nor mechanics. The example isolates
//! the roots of a polynomial.
//!
//! * [`multivariate`]: sparse polynomials with integer coefficients, the basis of proofs;
//! * [`real`]: exact real roots of polynomials; enclosures, Taylor models, Krawczyk's operator;
//! * [`complex`]: complex zeros, each in a rectangle that contains no other zero;
//! * [`boxes`]: all zeros of nonlinear equations in a box, with a proof of completeness;
//! * [`linear`]: determinants, and elimination with pivoting over any scalar type, including enclosures.
//!
//! ```
//! use dalembert_algebra::real::Polynomial;
//!
//! // (x^2 - 2) (x - 1)
//! let product = Polynomial::from_integers([2, -2, -1, 1]);
//! let roots = product.real_roots();
//! assert_eq!(roots.len(), 3);
//! assert_eq!(roots[2].enclosure(60).to_f64(), 2f64.sqrt());
//! ```

pub mod boxes;
pub mod complex;
pub mod linear;
pub mod multivariate;
pub mod real;
