//! Units of measurement, and a reader of quantities with units such as `"0.02 kg m^2"` and `"90 deg"`.
//!
//! The crate is for programs that read files with units. [`quantity`] returns a quantity in SI units; [`quantity::parse_any`] also returns its dimension.
//!
//! # Example
//! ```
//! use dalembert_units::{Unit, quantity};
//!
//! let (inertia, dimension) = quantity::parse_any("20 g m^2").expect("a number with its unit");
//! assert!((inertia - 0.02).abs() < 1e-15);
//! assert_eq!(dimension.coherent(), "kg m^2");
//! assert!(Unit::parse("parsec").is_err());
//! ```

pub mod quantity;
mod spelling;
mod unit;

pub use quantity::NoQuantity;
pub use spelling::nearest;
pub use unit::{Dimension, NoUnit, Unit};
