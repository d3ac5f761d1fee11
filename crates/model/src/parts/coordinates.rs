//! Coordinates and quasi-velocities.

use crate::ScalarId;
use std::ops::Range;
use symbolic::Dimension;

/// A coordinate of the system.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    pub name: String,
    pub dimension: Dimension,
    /// The coherent SI unit of its values.
    pub unit: String,
    /// The range of bytes of the name in the file.
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
    /// The expression, linear in the speeds.
    pub is: ScalarId,
    pub dimension: Dimension,
    /// The range of bytes of the name in the file.
    pub at: Range<usize>,
}

impl QuasiVelocity {
    /// Returns the coherent SI unit.
    pub fn unit(&self) -> String {
        let written = self.dimension.to_string();
        units::Unit::parse(&written).map_or(written, |unit| unit.dimension().coherent())
    }
}

impl Coordinate {
    /// Returns the coherent SI unit of the coordinate's rate.
    pub fn unit_of_rate(&self) -> String {
        let of_rate = (self.dimension / Dimension::time()).to_string();
        units::Dimension::of(&of_rate).coherent()
    }
}
