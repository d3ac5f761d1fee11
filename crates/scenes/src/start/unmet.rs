//! Reasons for which a start is refused.

use crate::compiled_system::NotCompiled;
use crate::row_units::measured;
use model::equations::Level;
use std::fmt;
use std::ops::Range;

/// The reason for which a start is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Unmet {
    /// A constraint does not hold, and values that may be moved do not change that.
    Open(Box<Open>),
    /// A constraint that is redundant with those before it.
    Redundant { at: Range<usize>, name: String },
    /// A constraint that no coordinate and no speed moves.
    Idle { at: Range<usize>, name: String },
    /// A constraint whose gradient vanishes wherever it holds.
    Multiple { at: Range<usize>, name: String },
    /// A constraint whose gradient jumps where it holds.
    Jumping { at: Range<usize>, name: String },
    /// A quasi-velocity of the start that no speeds give in its position, and that speeds give beside it.
    Locked { at: Range<usize>, name: String },
    /// A constraint that holds no coordinate and no speed.
    Fixed { at: Range<usize> },
    /// Two constraints that no position meets together, by their places, and what the second leaves where the first holds.
    Contradiction { at: [Range<usize>; 2], residual: f64, unit: String },
    /// A stabilised constraint with a wrong number of gains; `at` is their place.
    Gains { at: Range<usize>, level: Level, found: usize },
    /// A constraint that is another one in another case of a condition.
    Piecewise(Range<usize>),
    /// The constraints have no values.
    NotCompiled(NotCompiled),
}

/// A constraint that the start does not meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Open {
    /// Where the model has the constraint.
    pub at: Range<usize>,
    pub name: String,
    /// The residual; `None` where it is not finite.
    pub residual: Option<f64>,
    pub unit: String,
    /// Whether the residual is that of the rate of a constraint of positions.
    pub is_rate: bool,
    /// Coordinates, or speeds, that were moved to meet it, without success.
    pub moved: Vec<String>,
    /// Those that `[start]` gives and that would move it.
    pub given: Vec<String>,
    /// Whether it is the constraint of positions, or that of speeds.
    pub level: Level,
}

impl fmt::Display for Open {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rate = if self.is_rate { "the rate of " } else { "" };
        match self.residual {
            Some(residual) => write!(f, "{rate}{} is {}, and not zero", self.name, measured(residual, &self.unit)),
            None => write!(f, "{rate}{} has no value", self.name),
        }
    }
}
