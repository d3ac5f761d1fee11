//! Exact and enclosed algebra over numbers: polynomials, their roots, enclosures, linear equations.
//!
//! # Overview
//! The results are signs, counts and places, not rounded values: which motions are stationary, whether one is stable, for
//! which steps. The crate has neither expressions nor mechanics.
//!
//! * [`multivariate`]: sparse polynomials with integer coefficients, on which proofs rest;
//! * [`real`]: real roots of polynomials, exactly; enclosures, Taylor models, fixed points;
//! * [`complex`]: zeros in the complex plane, each in a rectangle that holds it and no other;
//! * [`boxes`]: all zeros of nonlinear equations in a box, none missing;
//! * [`linear`]: determinants, and elimination with pivots over any field, enclosures too.
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
