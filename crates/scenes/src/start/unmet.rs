//! Reasons for which a start is refused, with the constraint's place in the file.

use crate::compiled_system::NotCompiled;
use crate::row_units::measured;
use model::equations::Level;
use std::fmt;
use std::ops::Range;

/// The reason for which a start is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Unmet {
    /// A constraint does not hold after adjusting the values that may change.
    Open(Box<Open>),
    /// A constraint depends on others at this position only, so that its reaction is not determined.
    Redundant { at: Range<usize>, name: String },
    /// A constraint has a zero gradient: no coordinate and no speed changes it.
    Idle { at: Range<usize>, name: String },
    /// The gradient of a constraint vanishes wherever the constraint holds (multiple root).
    Multiple { at: Range<usize>, name: String },
    /// The gradient of a constraint is discontinuous where the constraint holds.
    Jumping { at: Range<usize>, name: String },
    /// A quasi-velocity of the start is impossible at this position, though possible at neighbouring ones (gimbal lock).
    Locked { at: Range<usize>, name: String },
    /// A constraint contains no coordinate and no speed.
    Fixed { at: Range<usize> },
    /// Two constraints contradict each other; `residual` is the value of the second where the first holds.
    Contradiction { at: [Range<usize>; 2], residual: f64, unit: String },
    /// A stabilised constraint has a wrong number of gains, `found`; `at` is the place of the gains.
    Gains { at: Range<usize>, level: Level, found: usize },
    /// A constraint changes at a condition, which is not supported.
    Piecewise(Range<usize>),
    /// The constraints cannot be evaluated.
    NotCompiled(NotCompiled),
}

/// A constraint that the start violates.
#[derive(Clone, Debug, PartialEq)]
pub struct Open {
    /// The place of the constraint in the file, in bytes.
    pub at: Range<usize>,
    /// The name of the constraint in messages.
    pub name: String,
    /// The residual in the unit `unit`; `None` where it is not finite.
    pub residual: Option<f64>,
    /// The unit of the residual.
    pub unit: String,
    /// Whether the residual is that of the rate of a position constraint.
    pub is_rate: bool,
    /// Names of the coordinates or speeds that were adjusted without success.
    pub moved: Vec<String>,
    /// Names of the values fixed in `[start]` that would change the residual.
    pub given: Vec<String>,
    /// Names of other constraints on the positions that the adjusted coordinates move.
    pub others: Vec<String>,
    /// Whether positions or speeds were solved for.
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
