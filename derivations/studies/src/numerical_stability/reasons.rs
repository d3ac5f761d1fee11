//! Why of a splitting nothing is proved near a motion.

use std::fmt;

/// More unknowns of a step are not enclosed.
pub(super) const MOST_UNKNOWNS: usize = 12;

/// Why nothing is proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unproved {
    /// On a bench, for a motor without an angle that it keeps, or one whose flow is not written down.
    Bench,
    /// A member of a family: others are its neighbours, and no operator contracts.
    Family,
    /// The flow of the push is not known: there is no splitting either.
    Fed,
    /// No stationary motion of the splitting's own is found, or no step is taken.
    Motion,
    /// The law's rest is not enclosed: it is degenerate.
    Rest,
    /// More unknowns than are enclosed.
    Many(usize),
}

impl fmt::Display for Unproved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bench => write!(f, "the motor keeps no angle, or its flow is not written down"),
            Self::Family => write!(f, "the motion is one of a family"),
            Self::Fed => write!(f, "the flow of the motor's piece is not known"),
            Self::Motion => write!(f, "no stationary motion of its own is found"),
            Self::Rest => write!(f, "the rest is not enclosed"),
            Self::Many(unknowns) => write!(f, "{unknowns} unknowns are more than {MOST_UNKNOWNS}"),
        }
    }
}
