//! Reasons why a scene has no answer on its steady motions.

use crate::stationary::motor::NoMotor;
use std::fmt;

/// The reason why there is no answer.
#[derive(Clone, Debug, PartialEq)]
pub enum NoAnswer {
    /// A motor on a bench has no carrier.
    Bench,
    Motor(NoMotor),
    /// A number is infinite or not a number.
    NotFinite(f64),
    /// The motions cannot be separated with the precisions tried.
    TooFine,
}

impl fmt::Display for NoAnswer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bench => {
                write!(
                    f,
                    "a motor on a bench has no carrier that could turn; a scene with system = \"gyrostat\" is accepted"
                )
            }
            Self::Motor(reason) => reason.fmt(f),
            Self::NotFinite(value) => write!(f, "{value} is not finite; a finite number is accepted"),
            Self::TooFine => write!(f, "motions lie too close together to be separated with 4096 bits"),
        }
    }
}

impl std::error::Error for NoAnswer {}
