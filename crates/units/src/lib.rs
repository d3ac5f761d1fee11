//! Units of measurement and quantities as texts: `"0.02 kg m^2"`, `"90 deg"`.

pub mod quantity;
mod spelling;
mod unit;

pub use quantity::NoQuantity;
pub use spelling::nearest;
pub use unit::{Dimension, NoUnit, Unit};
