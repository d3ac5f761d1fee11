//! Complex zeros of polynomials, each in a rectangle that contains no other zero.
//!
//! # Overview
//! * [`Rectangle`]: an enclosure of a complex number, with ends that are multiples of a power of two;
//! * [`zeros()`]: all zeros of a polynomial with enclosed coefficients, each in a rectangle, proved for every
//!   polynomial in the enclosures.
//!
//! ```
//! use dalembert_algebra::complex::zeros;
//! use dalembert_algebra::real::Enclosure;
//!
//! // z^3 - 2
//! let coefficients = [-2, 0, 0, 1].map(|n| Enclosure::integer(n, 128));
//! let found = zeros(&coefficients).unwrap();
//! assert_eq!(found.iter().filter(|zero| zero.real).count(), 1);
//! ```

mod rectangle;
mod zeros;

pub use rectangle::Rectangle;
pub use zeros::{Zero, zeros};
