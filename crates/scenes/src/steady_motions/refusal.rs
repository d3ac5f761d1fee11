//! The reasons for which steady motions are not searched for.

use crate::compiled_system::NotCompiled;
use std::ops;

/// The reason for which steady motions of a model are not searched for.
#[derive(Clone, Debug, PartialEq)]
pub enum NoSteadyMotions {
    NotCompiled(NotCompiled),
    /// The law changes at conditions or with contacts.
    Changes,
    /// Contacts, the first of them at its place.
    Contacts {
        at: ops::Range<usize>,
    },
    /// More combinations of conditions than are tried.
    ManyConditions {
        conditions: usize,
        most: usize,
    },
    /// A frame turns freely, and is not described by angles.
    FreeFrame {
        why: String,
    },
    /// The law depends on time.
    OfTime,
    /// A constraint of speeds that is not linear in the speeds, or a programmed constraint.
    OfSpeeds {
        at: ops::Range<usize>,
    },
    /// No inertia resists a coordinate.
    Singular,
    /// Neither inertia nor a force belongs to a coordinate, by its name.
    Empty {
        coordinate: String,
    },
    /// At values of parameters or speeds.
    At {
        values: Vec<(String, f64)>,
        why: Box<NoSteadyMotions>,
    },
    /// Not the name of a coordinate that occurs, nor of the speed of a cyclic coordinate.
    Unknown {
        name: String,
        nearest: Option<String>,
        accepted: Vec<String>,
    },
    /// A single value is given for an unknown that an equation determines; it would hold only by chance.
    Sought {
        name: String,
        value: f64,
    },
    /// Unknowns that are no angles of a circle, and have no range.
    WithoutRange {
        names: Vec<String>,
    },
    /// More equations than unknowns, and coordinates along which no force acts.
    Unequal {
        counts: [usize; 2],
        idle: Vec<String>,
    },
    /// An expression has no values.
    Undefined {
        why: String,
    },
}
