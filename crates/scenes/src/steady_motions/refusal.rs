//! The reasons for which a search for steady motions is not possible.

use crate::compiled_system::NotCompiled;
use std::ops;

/// The reason for which a search for steady motions of a model is not possible.
#[derive(Clone, Debug, PartialEq)]
pub enum NoSteadyMotions {
    NotCompiled(NotCompiled),
    /// The law changes at conditions or with contacts.
    Changes,
    /// Contacts of this kind are not supported; `at` is the place of the first in the file.
    Contacts {
        at: ops::Range<usize>,
    },
    /// The number of combinations of conditions exceeds `most`.
    ManyConditions {
        conditions: usize,
        most: usize,
    },
    /// A free frame cannot be described by angles, for the reason `why`.
    FreeFrame {
        why: String,
    },
    /// The law depends explicitly on time.
    OfTime,
    /// A constraint of speeds is not linear in the speeds, or is a programmed constraint.
    OfSpeeds {
        at: ops::Range<usize>,
    },
    /// A coordinate has no inertia.
    Singular,
    /// A coordinate has neither inertia nor a force.
    Empty {
        coordinate: String,
    },
    /// The reason holds for these values of parameters or speeds, by name.
    At {
        values: Vec<(String, f64)>,
        why: Box<NoSteadyMotions>,
    },
    /// A name with a range is neither that of a coordinate that occurs in the equations nor that of a cyclic speed.
    Unknown {
        name: String,
        nearest: Option<String>,
        accepted: Vec<String>,
    },
    /// A fixed value is given for an unknown that an equation determines.
    Sought {
        name: String,
        value: f64,
    },
    /// Unknowns other than angles over a whole turn have no range.
    WithoutRange {
        names: Vec<String>,
    },
    /// There are more equations than unknowns (`counts`), and no force acts along the coordinates `idle`.
    Unequal {
        counts: [usize; 2],
        idle: Vec<String>,
    },
    /// An expression cannot be evaluated.
    Undefined {
        why: String,
    },
}
