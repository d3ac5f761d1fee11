//! Motors as text in a scene file: the letters of their expressions, and the reasons for refusing others.
//!
//! Its laws become a [`Motor`](super::Motor) as those of the catalogue do.

mod letters;

pub use letters::{ANGLE, INDUCED, KnownMotion, Letters, SLIP, SPEED, is_taken};

use reader::Quantity;

/// The name of the model in scene files.
pub const NAME: &str = "text";

/// W, which every motor as text has.
pub const FIELD_SPEED: Quantity = Quantity::any("field_speed", "rad/s", "speed of the stator's field");
