//! Motors given by text in a scene file: the symbols of their expressions, with reasons for the rejection of others.
//!
//! Their laws become a [`Motor`](super::Motor) like those of the catalogue.

mod letters;

pub use letters::{ANGLE, INDUCED, KnownMotion, Letters, SLIP, SPEED, is_taken};

use reader::Quantity;

/// The name of the model in scene files.
pub const NAME: &str = "text";

/// The frame speed W, a datum of every motor given by text.
pub const FIELD_SPEED: Quantity = Quantity::any("field_speed", "rad/s", "speed of the stator's field");
