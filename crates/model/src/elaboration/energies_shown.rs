//! Energies and momenta of the whole system in outputs.

use super::loads::joule;
use super::value::Value;
use super::{Elaborator, Sound};
use crate::arena::Scalar;
use crate::expression::usage;
use crate::{Fault, ScalarId};
use std::ops::Range;

impl Elaborator<'_> {
    /// Reads `kinetic_energy` or `potential_energy` in an output; `None` for other names. A name of the file takes precedence.
    pub(super) fn energy_shown(&mut self, span: &Range<usize>, name: &str) -> Sound<Option<ScalarId>> {
        let energy = match name {
            "kinetic_energy" => Scalar::KineticEnergy,
            "potential_energy" => Scalar::PotentialEnergy,
            _ => return Ok(None),
        };
        self.must_be_output(span, name)?;
        Ok(Some(self.scalar(energy, Some(joule()))))
    }

    /// Reads `momentum(theta)` = dT/d(theta'), or `momentum(F.wx)` = dT/d(F.wx) for a free frame F.
    pub(super) fn momentum(&mut self, span: &Range<usize>, of: Value) -> Sound<Value> {
        let ordinary = self.model.coordinates.len();
        let part = match of {
            Value::Scalar(id) => self.model.arena.scalar_at(id),
            _ => None,
        };
        let speed = match part {
            Some(Scalar::Coordinate(place)) => *place,
            Some(Scalar::Rate { coordinate, order: 1 }) if *coordinate >= ordinary => *coordinate,
            _ => {
                let title = "a coordinate has a momentum, and a component of a free frame's angular velocity";
                return Err(Box::new(Fault::at(span.clone(), title, "neither", usage("momentum"))));
            }
        };
        let dimension = joule() / self.dimension_of_state(speed, 1);
        Ok(Value::Scalar(self.scalar(Scalar::Momentum { speed }, Some(dimension))))
    }
}
