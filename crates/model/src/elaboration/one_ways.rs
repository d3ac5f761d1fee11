//! Diodes and freewheels: a speed u that does not become negative, u >= 0, N >= 0, N u = 0.
//!
//! N is the blocking voltage of a diode, or the torque by which a freewheel blocks its shaft. The voltage drop or torque of the
//! conducting state acts always; at zero speed it is included in N.

use super::loads::joule;
use super::orders::{ACCELERATIONS, SPEEDS};
use super::windings::ampere;
use super::{Elaborator, Sound};
use crate::arena::{Scalar, Vector};
use crate::{Along, Contact, Fault, GeneralisedForce, OneWay, OneWaySource, PointId, Restitution, Sides};
use symbolic::Dimension;

impl Elaborator<'_> {
    pub(super) fn one_way(&mut self, place: usize, source: &OneWaySource) -> Sound<Contact> {
        let kind = source.is;
        if let Some(name) = &source.name {
            self.contact_name_is_free(name)?;
        }
        let what = format!("the {} of a {}", if kind == OneWay::Diode { "current" } else { "speed" }, kind.name());
        let needed = (kind == OneWay::Diode).then(ampere);
        let speed = self.scalar_value(&source.speed, &what, needed)?;
        if !self.orders.of(speed.0).is_some_and(|order| (SPEEDS..ACCELERATIONS).contains(&order)) {
            let accepted = match kind {
                OneWay::Diode => "the current of a charge, current = \"q'\", or a sum of such",
                OneWay::Freewheel => "the speed of a shaft, speed = \"a'\", or relative to another one, \"a' - n*b'\"",
            };
            let title = format!("{what} is linear in rates of coordinates");
            return Err(Box::new(Fault::at(source.speed.span(), title, "this is not", accepted)));
        }
        let own = self.dimension_of(speed.0).unwrap_or_else(Dimension::none);
        let across = joule() / Dimension::time() / own;
        let reaction = self.scalar(Scalar::Contact { contact: place, component: 0 }, Some(across));
        let along = Along::Expression(speed);
        self.model.generalised.push(GeneralisedForce { along, is: reaction });
        let drop = source.drop.as_ref().map(|drop| self.law(drop, &format!("the drop of a {}", kind.name()), across));
        let drop = drop.transpose()?;
        if let Some(drop) = drop {
            let is = self.scalar(Scalar::Negation(drop), Some(across));
            self.model.generalised.push(GeneralisedForce { along, is });
        }
        let none = self.vector(Vector::Zero, None);
        let still = self.scalar(Scalar::Difference(speed, speed), Some(own));
        Ok(Contact {
            name: source.name.as_ref().map_or_else(String::new, |name| name.text.clone()),
            gap: speed,
            one_way: Some(kind),
            drop,
            normal: none,
            velocity: none,
            slides: vec![still],
            tangents: vec![none],
            sides: Sides::One,
            reactions: vec![reaction],
            reaction_unit: units::Dimension::of(&across.to_string()).coherent(),
            friction: None,
            friction_at: source.at.clone(),
            restitution: None,
            restitution_at: source.at.clone(),
            law: Restitution::default(),
            with: None,
            point: PointId::ORIGIN,
            through: None,
            is_line: false,
            guide: None,
            is_touching: false,
            at: source.at.clone(),
        })
    }
}
