//! The friction governors: the programme that keeps the speed of the second shaft, and what is known of the governor released, which is
//! text.

mod gear;
mod programme;
pub mod reductions;
mod released;

pub use gear::{Discs, Drum, Gear, Shafts};
pub use programme::Programme;

/// The share of its first lever at which a wheel counts as come to the axis.
const NEAR: f64 = 1e-2;
