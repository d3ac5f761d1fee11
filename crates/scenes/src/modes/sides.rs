//! The sides of a model's own events: an event counts when its expression passes zero after the start.
//!
//! An expression that is zero at the start is on the side to which the motion moves it, given by the first nonzero rate.

use super::decision::TERMS;
use super::jet::Jet;

/// The side of an event's expression on which a run is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Side {
    /// 1 above zero, -1 below.
    pub sign: f64,
    /// Whether no rate decides the sign: then the first nonzero value of the expression does.
    pub is_open: bool,
}

/// The past of an event's side.
#[derive(Clone, Copy, Debug)]
pub(super) enum Past {
    /// None: the state was given, or set to where the expression is zero.
    None,
    /// The run goes on from a side; the expression may be about to pass zero.
    Side {
        from: f64,
        /// The distance beyond zero at which it counts as passed.
        near: f64,
    },
    /// As `Side`, with algebraic speeds: the expression may have jumped across zero with one of them, and then passes zero at this instant.
    Jumping { from: f64, near: f64 },
    /// The event has just set the state, coming from a side.
    Set { from: f64, near: f64 },
    /// The expression has just passed zero, coming from a side.
    Passed(f64),
}

/// The side of an expression next after an instant.
pub(super) fn side(jet: &Jet<TERMS>, past: Past, slack: f64) -> Side {
    let (value, way) = (jet.sign_of(0, slack), jet.way(slack * jet.doubts[0], slack));
    let known = match past {
        Past::None => [value, way, 0.0],
        Past::Side { from, .. } => [value, from, 0.0],
        Past::Jumping { from, .. } => [from, 0.0, 0.0],
        // a body that is set to rest on a floor is still above it
        Past::Set { from, .. } => [value, jet.sign_of(1, slack), from],
        Past::Passed(from) => [way, -from, 0.0],
    };
    let sign = known.into_iter().find(|sign| sign.abs() == 1.0);
    Side { sign: sign.unwrap_or(1.0), is_open: sign.is_none() }
}
