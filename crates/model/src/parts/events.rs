//! Events, and the state at time zero.

use crate::ScalarId;
use std::ops::Range;

/// The direction in which an expression passes through zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    Up,
    Down,
    Both,
}

/// An instant at which the expression `when` passes through zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// The name; empty if there is none.
    pub name: String,
    pub when: ScalarId,
    pub direction: Direction,
    /// Assignments to the state after the event.
    pub set: Vec<Assignment>,
    /// Whether the event ends the motion.
    pub ends: bool,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}

/// A coordinate or speed after an event, as a function of the state before it.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// The index of the coordinate.
    pub coordinate: usize,
    /// 0 for the coordinate, 1 for its speed.
    pub order: usize,
    /// The value after the event in SI units, a function of the state before it.
    pub is: ScalarId,
}

/// A coordinate or speed at time zero.
#[derive(Clone, Debug, PartialEq)]
pub struct StartValue {
    /// The index of the coordinate.
    pub coordinate: usize,
    /// 0 for the coordinate, 1 for its speed.
    pub order: usize,
    /// The value in SI units.
    pub value: f64,
    /// Whether the value may be changed to satisfy the constraints.
    pub is_guess: bool,
}

/// A quasi-velocity at time zero.
#[derive(Clone, Debug, PartialEq)]
pub struct StartSpeed {
    /// The index of the quasi-velocity.
    pub of: usize,
    /// The value in SI units.
    pub value: f64,
    /// The range of bytes in the file.
    pub at: Range<usize>,
}
