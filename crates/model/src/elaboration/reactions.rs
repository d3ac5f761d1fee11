//! Reactions of constraints and loads of joints, in outputs.

use super::expressions::Meaning;
use super::loads::joule;
use super::{Elaborator, Sound, unknown};
use crate::arena::{Scalar, Vector};
use crate::equations::Level;
use crate::{BodyId, Constraint, Fault, Text, Trace, Zero};
use std::ops::Range;
use symbolic::{Dimension, apart};

/// A fault at the place of a call.
fn refused(span: &Range<usize>, title: String, label: &str, accepted: &str) -> Box<Fault> {
    Box::new(Fault::at(span.clone(), title, label, accepted))
}

impl Elaborator<'_> {
    /// Loads are known once the motion is: in outputs, and nowhere else.
    pub(super) fn must_be_output(&self, span: &Range<usize>, function: &str) -> Sound<()> {
        match self.shows_loads {
            true => Ok(()),
            false => Err(refused(
                span,
                format!("`{function}` stands in [outputs] only"),
                "here the motion is not known yet",
                "an output, such as load = \"reaction(floor)\" or total = \"kinetic_energy + potential_energy\"",
            )),
        }
    }

    /// `reaction(pin)`, `reaction(rolling, 2)`: the multiplier of a scalar constraint, the vector of those of a vector.
    pub(super) fn reaction(&mut self, text: &Text, span: &Range<usize>, arguments: &[Meaning]) -> Sound<super::Value> {
        let accepted = "reaction(name) of a named [[constraint]]; reaction(name, 2) where its `zero` is a list";
        let written: Vec<&str> = arguments
            .iter()
            .filter_map(|argument| match argument {
                Meaning::Literal { start, end } => Some(text.text[*start..*end].trim_matches('"')),
                _ => None,
            })
            .collect();
        let (name, place) = match written.as_slice() {
            [name] if arguments.len() == 1 => (*name, None),
            [name, place] if arguments.len() == 2 => (*name, place.parse::<usize>().ok()),
            _ => return Err(refused(span, "`reaction` has the name of a constraint".to_owned(), "here", accepted)),
        };
        let contact = self.model.contacts.iter().position(|contact| contact.name == name && place.is_none());
        if let Some(contact) = contact.filter(|_| !name.is_empty()) {
            let crate::Contact { reactions, drop, .. } = &self.model.contacts[contact];
            let (normal, drop) = (reactions[0], *drop);
            let dimension = self.dimension_of(normal.0);
            // the voltage across a diode: what holds its current, less what it takes
            let across = drop.map(|drop| self.scalar(Scalar::Difference(normal, drop), dimension));
            return Ok(super::Value::Scalar(across.unwrap_or(normal)));
        }
        let named = |constraint: &Constraint| {
            let own = &constraint.name;
            own.as_deref() == Some(name)
        };
        let constraints = &self.model.constraints;
        let all: Vec<usize> = (0..constraints.len()).filter(|&place| named(&constraints[place])).collect();
        let constraint = match (all.as_slice(), place, written.len()) {
            ([], ..) => {
                let contacts = self.source.contacts.iter().map(|one| &one.name);
                let contacts = contacts.chain(self.source.one_ways.iter().map(|one| &one.name)).flatten();
                let names = self.source.constraints.iter().filter_map(|one| one.name.as_ref()).chain(contacts);
                let names = names.map(|name| name.text.as_str());
                // it is there, and what is wrong with it is told
                if names.clone().any(|known| known == name) {
                    return Err(Box::new(Fault::consequence(span.clone())));
                }
                return Err(Box::new(unknown(&self.broken, span.clone(), name, "constraint", names)));
            }
            ([only], None, 1) => *only,
            (some, Some(place), _) if (1..=some.len()).contains(&place) => some[place - 1],
            (some, ..) => {
                let count = some.len();
                let title = format!("`{name}` holds {count} {}", if count == 1 { "equation" } else { "equations" });
                return Err(refused(span, title, "which one is meant?", accepted));
            }
        };
        Ok(match self.model.constraints[constraint].zero {
            Zero::Scalar(zero) => {
                let dimension = self.multiplier_dimension(constraint, zero.0);
                super::Value::Scalar(self.scalar(Scalar::Reaction { constraint }, dimension))
            }
            Zero::Vector(zero) => {
                let dimension = self.multiplier_dimension(constraint, zero.0);
                super::Value::Vector(self.vector(Vector::Reaction { constraint }, dimension))
            }
        })
    }

    /// `friction(floor)`, `gap(floor)`, `sliding(floor)`: the tangential reaction of a contact, its gap, its sliding velocity; where it
    /// slides in space the first and the last are vectors.
    pub(super) fn of_contact(
        &mut self,
        text: &Text,
        span: &Range<usize>,
        function: &str,
        arguments: &[Meaning],
    ) -> Sound<super::Value> {
        let accepted = format!("{function}(name) of a named [[contact]]");
        let [Meaning::Literal { start, end }] = arguments else {
            return Err(refused(span, format!("`{function}` has the name of a contact"), "here", &accepted));
        };
        let name = text.text[*start..*end].trim_matches('"');
        let Some(contact) = self.model.contacts.iter().find(|contact| contact.name == name) else {
            let names = self.source.contacts.iter().filter_map(|one| one.name.as_ref()).map(|name| name.text.as_str());
            if names.clone().any(|known| known == name) {
                return Err(Box::new(Fault::consequence(span.clone())));
            }
            return Err(Box::new(unknown(&self.broken, span.clone(), name, "contact", names)));
        };
        if let Some(one_way) = contact.one_way {
            let title = format!("`{name}` is a {}, which has a `reaction` alone", one_way.name());
            return Err(refused(span, title, "here", &format!("reaction({name})")));
        }
        let parts = match function {
            "friction" => contact.reactions[1..].to_vec(),
            "gap" => vec![contact.gap],
            _ => contact.slides.clone(),
        };
        let tangents = contact.tangents.clone();
        Ok(match parts.as_slice() {
            [one] => super::Value::Scalar(*one),
            in_space => {
                let dimension = self.dimension_of(in_space[0].0);
                super::Value::Vector(self.along_axes(in_space, &tangents, dimension))
            }
        })
    }

    /// Power per rate of the constraint: f' of one of positions, f itself of one of speeds.
    fn multiplier_dimension(&self, constraint: usize, zero: usize) -> Option<Dimension> {
        let of_zero = self.dimension_of(zero)?;
        if !self.faults.is_empty() {
            return None;
        }
        let model = &self.model;
        let level = apart(|| {
            let trace = Trace::of(model);
            let held = crate::equations::held_of(&trace, constraint);
            held.first().map_or(Level::Position, |held| trace.level_of(held.zero))
        });
        Some(match level {
            Level::Position => joule() / of_zero,
            Level::Speed => joule() / Dimension::time() / of_zero,
        })
    }

    /// `joint_force(disc)`, `joint_torque(disc)`: from the body, or the ground, that a body is joined to.
    pub(super) fn joint_load(&mut self, span: &Range<usize>, force: bool, body: BodyId) -> Sound<super::Value> {
        let name = self.model.bodies[body.0].name.clone();
        let energies = &self.model.energies;
        let given = [energies.kinetic, energies.potential, energies.dissipation, energies.coenergy];
        let given = given.iter().any(Option::is_some);
        if given {
            return Err(refused(
                span,
                format!("the joint of `{name}` has no load that is known"),
                "[energies] does not say on which bodies it acts",
                "forces and torques on bodies in the place of [energies]",
            ));
        }
        if force && self.model.bodies[body.0].centre.is_none() {
            let accepted = format!("`centre` in [bodies.{name}], or joint_torque({name})");
            let title = format!("the force on the joint of `{name}` is not known");
            return Err(refused(span, title, "the body has no centre of mass", &accepted));
        }
        let model = &self.model;
        let unplaced = match self.faults.is_empty() {
            true => apart(|| Trace::of(model).joints().unplaced()),
            false => None,
        };
        if let Some(coordinate) = unplaced {
            let coordinate = &self.model.coordinates[coordinate].name;
            return Err(refused(
                span,
                format!("the joint of `{name}` has no load that is known"),
                &format!("a constraint speaks of `{coordinate}`, which moves more than one joint"),
                "constraints of points, frames and bodies: then it is known where their reactions act",
            ));
        }
        let metre = Dimension::length();
        let vector = if force { Vector::JointForce(body) } else { Vector::JointTorque(body) };
        let dimension = if force { joule() / metre } else { joule() };
        Ok(super::Value::Vector(self.vector(vector, Some(dimension))))
    }
}
