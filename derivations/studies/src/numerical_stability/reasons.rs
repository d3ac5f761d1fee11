//! Reasons why nothing is proved about a splitting near a motion.

use std::fmt;

/// The largest number of unknowns of a step that are enclosed.
pub(super) const MOST_UNKNOWNS: usize = 12;

/// The reason why nothing is proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unproved {
    /// On a bench: the motor has no steady angle, or no known flows.
    Bench,
    /// The motion is a member of a family: with other members nearby Krawczyk's operator is no contraction.
    Family,
    /// The flow of the kick is unknown: there is no splitting either.
    Fed,
    /// No fixed point of the splitting was found, or a step failed.
    Motion,
    /// The equilibrium of the law is degenerate and not enclosed.
    Rest,
    /// There are more unknowns than `MOST_UNKNOWNS`.
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
