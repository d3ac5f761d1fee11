//! Coordinates, and names for combinations of their rates.

use crate::ScalarId;
use std::ops::Range;
use symbolic::Dimension;

/// A coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    pub name: String,
    pub dimension: Dimension,
    /// The coherent unit, in which values are.
    pub unit: String,
    /// The position of the name in the file, in bytes.
    pub at: Range<usize>,
}

impl Coordinate {
    /// Whether values that differ by whole turns are one position; a number without dimension is no angle.
    pub fn is_angle(&self) -> bool {
        self.unit == "rad"
    }
}

/// A quasi-velocity: a name for an expression that is linear in the speeds u.
#[derive(Clone, Debug, PartialEq)]
pub struct QuasiVelocity {
    pub name: String,
    pub is: ScalarId,
    pub dimension: Dimension,
    /// The position of the name in the file, in bytes.
    pub at: Range<usize>,
}

impl QuasiVelocity {
    /// The coherent unit.
    pub fn unit(&self) -> String {
        let written = self.dimension.to_string();
        units::Unit::parse(&written).map_or(written, |unit| unit.dimension().coherent())
    }
}

impl Coordinate {
    /// The coherent unit of its rate.
    pub fn unit_of_rate(&self) -> String {
        let of_rate = (self.dimension / Dimension::time()).to_string();
        units::Dimension::of(&of_rate).coherent()
    }
}
