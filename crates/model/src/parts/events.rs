//! Events, and the state at time zero.

use crate::ScalarId;
use std::ops::Range;

/// The direction in which an expression passes zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    Up,
    Down,
    Both,
}

/// An instant at which an expression passes zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// Empty where it has none.
    pub name: String,
    pub when: ScalarId,
    pub direction: Direction,
    /// The state after it.
    pub set: Vec<Assignment>,
    /// Whether the motion ends.
    pub ends: bool,
    pub at: Range<usize>,
}

/// A coordinate, or its speed, after an event: an expression of the state before it.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    pub coordinate: usize,
    /// Zero for the coordinate, one for its speed.
    pub order: usize,
    pub is: ScalarId,
}

/// A coordinate, or its speed, at time zero.
#[derive(Clone, Debug, PartialEq)]
pub struct StartValue {
    pub coordinate: usize,
    /// Zero for the coordinate, one for its speed.
    pub order: usize,
    /// In SI units.
    pub value: f64,
    /// Whether it may be moved to meet the constraints.
    pub is_guess: bool,
}

/// The value of a quasi-velocity at time zero.
#[derive(Clone, Debug, PartialEq)]
pub struct StartSpeed {
    /// The place among the quasi-velocities.
    pub of: usize,
    /// In SI units.
    pub value: f64,
    /// The position in the file, in bytes.
    pub at: Range<usize>,
}
