//! Reactions of constraints, and joint loads; both are shown in outputs.

mod confinement;
mod letters;
mod transcription;

pub(super) use letters::{ReactionLetter, with_laws};
pub(super) use transcription::transcribed;

use super::expressions::Meaning;
use super::loads::joule;
use super::{Elaborator, Sound, unknown};
use crate::arena::{Scalar, Vector};
use crate::equations::Level;
use crate::expression::{Form, read};
use crate::{BodyId, Constraint, ConstraintSource, Fault, Source, Text, Trace, Zero};
use std::ops::Range;
use symbolic::{Dimension, apart};

/// Returns a fault at the position of a call.
fn refused(span: &Range<usize>, title: String, label: &str, accepted: &str) -> Box<Fault> {
    Box::new(Fault::at(span.clone(), title, label, accepted))
}

const ACCEPTED: &str = "reaction(name) of a named [[constraint]]; reaction(name, 2) where its `zero` is a list";

/// Returns the name of a constraint, and the number in its list if one is given.
fn named(text: &Text, span: &Range<usize>, arguments: &[Meaning]) -> Sound<(String, Option<Option<usize>>)> {
    let written: Vec<&str> = arguments
        .iter()
        .filter_map(|argument| match argument {
            Meaning::Literal { start, end } => Some(text.text[*start..*end].trim_matches('"')),
            _ => None,
        })
        .collect();
    match written.as_slice() {
        [name] if arguments.len() == 1 => Ok(((*name).to_owned(), None)),
        [name, place] if arguments.len() == 2 => Ok(((*name).to_owned(), Some(place.parse().ok()))),
        _ => Err(refused(span, "`reaction` has the name of a constraint".to_owned(), "here", ACCEPTED)),
    }
}

/// Returns the index of an equation among the `count` equations of a name.
fn entry_of(span: &Range<usize>, name: &str, place: Option<Option<usize>>, count: usize) -> Sound<usize> {
    match (place, count) {
        (None, 1) => Ok(0),
        (Some(Some(place)), _) if (1..=count).contains(&place) => Ok(place - 1),
        _ => {
            let title = format!("`{name}` holds {count} {}", if count == 1 { "equation" } else { "equations" });
            Err(refused(span, title, "which one is meant?", ACCEPTED))
        }
    }
}

/// Returns the constraints whose reactions occur in a text.
pub(super) fn constraints_in<'s>(source: &'s Source, text: &str) -> Vec<&'s ConstraintSource> {
    let Ok(expression) = read(text) else { return Vec::new() };
    let argument = |form: &Form| match form {
        Form::Call { function, arguments } if function == "reaction" => Some(arguments.first()?.value),
        _ => None,
    };
    let names: Vec<&str> = expression
        .parts
        .iter()
        .filter_map(argument)
        .map(|part| text[expression.spans[part].clone()].trim_matches('"'))
        .collect();
    let held = |one: &&ConstraintSource| one.name.as_ref().is_some_and(|name| names.contains(&name.text.as_str()));
    source.constraints.iter().filter(held).collect()
}

/// Returns the dimension of a multiplier: power per f' for a constraint f = 0 of positions, power per f for one of speeds.
fn of_multiplier(level: Level, of_zero: Dimension) -> Dimension {
    match level {
        Level::Position => joule() / of_zero,
        Level::Speed => joule() / Dimension::time() / of_zero,
    }
}

impl Elaborator<'_> {
    /// Checks that a reaction or joint load occurs in an output, since it is known only after the motion.
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

    /// Reads `reaction(pin)` or `reaction(rolling, 2)`: the multiplier of a scalar constraint, or the multipliers of a vector constraint as a vector.
    pub(super) fn reaction(&mut self, text: &Text, span: &Range<usize>, arguments: &[Meaning]) -> Sound<super::Value> {
        if !self.shows_loads {
            return self.held_reaction(text, span, arguments);
        }
        let (name, place) = named(text, span, arguments)?;
        let name = name.as_str();
        let contact = self.model.contacts.iter().position(|contact| contact.name == name && place.is_none());
        if let Some(contact) = contact.filter(|_| !name.is_empty()) {
            let crate::Contact { reactions, drop, .. } = &self.model.contacts[contact];
            let (normal, drop) = (reactions[0], *drop);
            let dimension = self.dimension_of(normal.0);
            // the voltage across a diode is its blocking voltage minus its conducting voltage
            let across = drop.map(|drop| self.scalar(Scalar::Difference(normal, drop), dimension));
            return Ok(super::Value::Scalar(across.unwrap_or(normal)));
        }
        let named = |constraint: &Constraint| {
            let own = &constraint.name;
            own.as_deref() == Some(name)
        };
        let constraints = &self.model.constraints;
        let all: Vec<usize> = (0..constraints.len()).filter(|&place| named(&constraints[place])).collect();
        if all.is_empty() {
            return Err(self.unknown_constraint(span, name, false));
        }
        let constraint = all[entry_of(span, name, place, all.len())?];
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

    /// Returns the fault of a name that no constraint has. With `in_load`, names of contacts are not accepted.
    fn unknown_constraint(&self, span: &Range<usize>, name: &str, in_load: bool) -> Box<Fault> {
        let contacts = self.source.contacts.iter().map(|one| &one.name);
        let contacts = contacts.chain(self.source.one_ways.iter().map(|one| &one.name)).flatten();
        let contacts: Vec<&str> = contacts.map(|name| name.text.as_str()).collect();
        if in_load && contacts.contains(&name) {
            let title = format!("the reaction of the contact `{name}` stands in [outputs] only");
            let accepted = "a reaction of a [[constraint]] here; friction of a contact is its key `friction`";
            return refused(span, title, "a contact", accepted);
        }
        let own = self.source.constraints.iter().filter_map(|one| one.name.as_ref()).map(|name| name.text.as_str());
        let names: Vec<&str> = if in_load { own.collect() } else { own.chain(contacts).collect() };
        // the name exists, and its fault is reported elsewhere
        if names.contains(&name) {
            return Box::new(Fault::consequence(span.clone()));
        }
        Box::new(unknown(&self.broken, span.clone(), name, "constraint", names.into_iter()))
    }

    /// Reads `friction(floor)`, `gap(floor)` or `sliding(floor)`: the tangential reaction, the gap or the sliding velocity of a contact. Reaction and velocity are
    /// vectors for contacts in space.
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

    /// Returns the dimension of the multiplier of a constraint; see [`of_multiplier`].
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
        Some(of_multiplier(level, of_zero))
    }

    /// Reads `joint_force(disc)` or `joint_torque(disc)`: the load on a body from the body, or the ground, to which it is joined.
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
