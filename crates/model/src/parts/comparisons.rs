//! The comparisons behind conditions: their values at equality of their sides, and their expressions.

use super::Model;
use crate::arena::{AtZero, Part, Scalar};

impl Model {
    /// The value of a condition where its expression is zero: true for `a <= b`, false for `a < b`, `None` where the model has both, or neither, as for `sign`.
    pub fn value_at_zero(&self, switch: usize) -> Option<bool> {
        let is = |case: AtZero| self.arena.parts.contains(&Part::Scalar(Scalar::Switch(switch, case)));
        match (is(AtZero::On), is(AtZero::Off), is(AtZero::Half)) {
            (true, false, false) => Some(true),
            (false, true, false) => Some(false),
            _ => None,
        }
    }

    /// Returns the name of the coordinate if the expression of a switch is a single coordinate.
    pub fn coordinate_of_switch(&self, switch: usize) -> Option<&str> {
        match self.arena.scalar_at(*self.switches.get(switch)?)? {
            Scalar::Coordinate(place) => Some(&self.coordinates[*place].name),
            _ => None,
        }
    }
}
