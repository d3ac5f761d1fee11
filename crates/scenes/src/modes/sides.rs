//! Sides of zero for the events of a model: an event occurs when its expression crosses zero after the start.
//!
//! An expression that is zero at the start is on the side to which the motion moves it, by the first nonzero rate.

use super::decision::TERMS;
use super::jet::Jet;

/// The side of zero on which the expression of an event is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Side {
    /// 1 above zero, -1 below.
    pub sign: f64,
    /// True if no rate decides the sign; the first nonzero value of the expression then does.
    pub is_open: bool,
}

/// The history of the expression of an event.
#[derive(Clone, Copy, Debug)]
pub(super) enum Past {
    /// No history: the state was given, or set to a zero of the expression.
    None,
    /// The run continues from the side `from`; the expression may be about to cross zero.
    Side {
        from: f64,
        /// The distance beyond zero at which the expression counts as having crossed.
        near: f64,
    },
    /// The run continues from the side `from` with algebraic speeds: if the expression jumped across zero with one of these, it crosses
    /// at this instant.
    Jumping { from: f64, near: f64 },
    /// The event has just set the state, coming from the side `from`.
    Set { from: f64, near: f64 },
    /// The expression has just crossed zero, coming from this side.
    Passed(f64),
}

/// The side of an expression just after an instant.
pub(super) fn side(jet: &Jet<TERMS>, past: Past, slack: f64) -> Side {
    let (value, way) = (jet.sign_of(0, slack), jet.way(slack * jet.doubts[0], slack));
    let known = match past {
        Past::None => [value, way, 0.0],
        Past::Side { from, .. } => [value, from, 0.0],
        Past::Jumping { from, .. } => [from, 0.0, 0.0],
        // a body that an event sets to rest on a floor is still above it
        Past::Set { from, .. } => [value, jet.sign_of(1, slack), from],
        Past::Passed(from) => [way, -from, 0.0],
    };
    let sign = known.into_iter().find(|sign| sign.abs() == 1.0);
    Side { sign: sign.unwrap_or(1.0), is_open: sign.is_none() }
}
