//! The values of comparisons at equality of their sides.

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
}
