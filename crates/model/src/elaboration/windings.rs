//! Windings of a motor. The coordinate of a winding is a charge; its rate is the current i, with v the supply voltage, k the motional constant and w the motor's speed:
//!
//!   (dW'/di)' = v - R i - k w,    W' = L i^2/2,    torque k i .

use super::loads::joule;
use super::orders::ACCELERATIONS;
use super::{Elaborator, Sound};
use crate::arena::{Number, Scalar};
use crate::{Along, Fault, GeneralisedForce, ScalarId, Text, WindingSource};
use symbolic::Dimension;

pub(super) fn ampere() -> Dimension {
    Dimension::current()
}

fn volt() -> Dimension {
    joule() / Dimension::time() / ampere()
}

fn ohm() -> Dimension {
    volt() / ampere()
}

impl Elaborator<'_> {
    /// Reads a law that depends on positions, speeds and currents.
    pub(super) fn law(&mut self, text: &Text, what: &str, dimension: Dimension) -> Sound<ScalarId> {
        let found = self.scalar_value(text, what, Some(dimension))?;
        if self.orders.of(found.0).is_some_and(|order| order >= ACCELERATIONS) {
            let title = format!("{what} holds accelerations, or rates of currents");
            let accepted =
                "positions, speeds, currents and the time; a voltage M i' of another winding is a co-energy M i1 i2";
            return Err(Box::new(Fault::at(text.span(), title, "not supported yet", accepted)));
        }
        Ok(found)
    }

    /// Adds the law of a winding. Returns its torque, if it has one.
    pub(super) fn winding(&mut self, drive: usize, charge: usize, source: &WindingSource) -> Sound<Option<ScalarId>> {
        let henry = ohm() * Dimension::time();
        let inductance = self.scalar_value(&source.inductance, "the inductance of a winding", Some(henry))?;
        if self.orders.of(inductance.0).is_some_and(|order| order > 0) {
            let title = "the inductance of a winding depends on positions alone";
            let accepted = "an inductance that saturates is a co-energy W'(i, q): coenergy = \"...\" in [energies]";
            return Err(Box::new(Fault::at(source.inductance.span(), title, "a rate stands in it", accepted)));
        }
        let current = self.currents[&charge];
        let two = Number { value: 2.0, times: 1.0, per: 1.0 };
        let two = self.scalar(Scalar::Number(two), Some(Dimension::none()));
        let flux = self.scalar(Scalar::Product(inductance, current), Some(henry * ampere()));
        let twice = self.scalar(Scalar::Product(flux, current), Some(joule()));
        let own = self.scalar(Scalar::Quotient(twice, two), Some(joule()));
        self.model.energies.coenergy = Some(match self.model.energies.coenergy {
            None => own,
            Some(sum) => self.scalar(Scalar::Sum(sum, own), Some(joule())),
        });
        let mut drops = Vec::new();
        if let Some(resistance) = &source.resistance {
            let resistance = self.law(resistance, "the resistance of a winding", ohm())?;
            drops.push(self.scalar(Scalar::Product(resistance, current), Some(volt())));
        }
        let mut torque = None;
        if let Some(motional) = &source.motional {
            let per_speed = volt() * Dimension::time();
            let motional = self.law(motional, "the motional voltage per speed", per_speed)?;
            if let Some(speed) = self.drives[drive].speed {
                drops.push(self.scalar(Scalar::Product(motional, speed), Some(volt())));
            }
            torque = Some(self.scalar(Scalar::Product(motional, current), Some(joule())));
        }
        let mut voltage = match &source.supply {
            None => None,
            Some(supply) => Some(self.law(supply, "the supply of a winding", volt())?),
        };
        for drop in drops {
            voltage = Some(match voltage {
                None => self.scalar(Scalar::Negation(drop), Some(volt())),
                Some(voltage) => self.scalar(Scalar::Difference(voltage, drop), Some(volt())),
            });
        }
        if let Some(is) = voltage {
            self.driving.1.push(GeneralisedForce { along: Along::Speed(charge), is });
        }
        Ok(torque)
    }
}
