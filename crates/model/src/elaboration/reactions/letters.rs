//! Reactions in loads and events: the symbols that represent them, and the laws of these symbols.
//!
//! A load that depends on a reaction lambda makes the law implicit. The reaction is represented as the rate r' of an additional coordinate r, its impulse.
//! This coordinate has no inertia, and the force lambda(q, u, r', t) - r' along it: a law without accelerations. The system is elaborated twice. At first
//! each such reaction is an input without a value, and the equations of motion give lambda; the second time the reaction is that rate.

use super::transcription::transcribed;
use crate::arena::{Scalar, Vector};
use crate::elaboration::expressions::Meaning;
use crate::elaboration::{Elaborator, Sound, Value};
use crate::equations::{Level, independent, solved};
use crate::{
    Along, ConstraintSource, Coordinate, Fault, FrameId, GeneralisedForce, Input, Model, ScalarId, Source, Text, Trace,
};
use std::ops::Range;
use symbolic::{Dimension, Sym, apart};

/// A component of a reaction on which a load or an event depends.
#[derive(Clone, Debug)]
pub(in crate::elaboration) struct ReactionLetter {
    /// The name of the constraint, and the index of the equation in its list.
    constraint: String,
    entry: usize,
    /// For a vector constraint: the axis of the component, and the index among the components that do not vanish identically.
    axis: Option<(FrameId, usize)>,
    component: usize,
    /// The name of the impulse's coordinate.
    impulse: String,
    /// The dimension of the reaction.
    dimension: Dimension,
    /// The position of the first occurrence in the file.
    pub(super) at: Range<usize>,
    /// The symbol in the expressions of the model that is being elaborated.
    pub(super) letter: Option<ScalarId>,
}

impl Elaborator<'_> {
    /// Adds a coordinate for the impulse of each such reaction, after the coordinates of the file and the charges.
    pub(in crate::elaboration) fn impulses(&mut self) {
        for place in 0..self.reaction_letters.len() {
            let ReactionLetter { impulse, dimension, at, .. } = self.reaction_letters[place].clone();
            let of_impulse = dimension * Dimension::time();
            let unit = units::Dimension::of(&of_impulse.to_string()).coherent();
            self.model.coordinates.push(Coordinate { name: impulse, dimension: of_impulse, unit, at });
            let coordinate = self.model.coordinates.len() - 1;
            let letter = self.scalar(Scalar::Rate { coordinate, order: 1 }, Some(dimension));
            self.reaction_letters[place].letter = Some(letter);
        }
    }

    /// Reads `reaction(pin)` in a load, a definition or an event.
    pub(super) fn held_reaction(&mut self, text: &Text, span: &Range<usize>, arguments: &[Meaning]) -> Sound<Value> {
        let (name, place) = super::named(text, span, arguments)?;
        if self.source.constraints.iter().all(|one| one.name.as_ref().is_none_or(|own| own.text != name)) {
            return Err(self.unknown_constraint(span, &name, true));
        }
        let entries: Vec<&Text> = entries(self.source, &name).collect();
        let entry = super::entry_of(span, &name, place, entries.len())?;
        let known = |one: &ReactionLetter| one.constraint == name && one.entry == entry;
        if !self.reaction_letters.iter().any(known) {
            let several = entries.len() > 1;
            let zero = entries[entry].clone();
            self.add_letters(&name, (entry, several), &zero, span)?;
        }
        let own: Vec<ReactionLetter> = self.reaction_letters.iter().filter(|one| known(one)).cloned().collect();
        let mut sum = Value::Vector(self.vector(Vector::Zero, None));
        for ReactionLetter { axis, letter, dimension, .. } in own {
            let Some(letter) = letter else { continue };
            let Some((frame, axis)) = axis else { return Ok(Value::Scalar(letter)) };
            let unit = self.vector(Vector::Axis { frame, axis }, Some(Dimension::none()));
            let part = Value::Vector(self.vector(Vector::Scaled(letter, unit), Some(dimension)));
            sum = self.sum(span, sum, part)?;
        }
        Ok(sum)
    }

    /// Adds an input for each component of a reaction.
    fn add_letters(
        &mut self,
        name: &str,
        (entry, several): (usize, bool),
        zero: &Text,
        span: &Range<usize>,
    ) -> Sound<()> {
        if self.constraints_read.iter().any(|known| known == name) {
            let fault = super::confinement::fault("a constraint", span.clone());
            if !self.faults.contains(&fault) {
                self.faults.push(fault);
            }
            return Err(Box::new(Fault::consequence(span.clone())));
        }
        self.constraints_read.push(name.to_owned());
        let value = self.value(zero);
        self.constraints_read.pop();
        // a wrong constraint is reported where it is defined
        let value = value.map_err(|_| Box::new(Fault::consequence(span.clone())))?;
        let (Value::Scalar(ScalarId(part)) | Value::Vector(crate::VectorId(part))) = value else {
            return Err(Box::new(Fault::consequence(span.clone())));
        };
        let model = &self.model;
        let (axes, level) = apart(|| {
            let trace = Trace::of(model);
            let held = match value {
                Value::Vector(vector) => independent(&trace, trace.vector(vector)),
                _ => Vec::new(),
            };
            let zeros = held.iter().map(|held| held.zero).chain(match value {
                Value::Scalar(zero) => Some(trace.scalar(zero)),
                _ => None,
            });
            let is_of_speeds = zeros.into_iter().any(|zero| trace.level_of(zero) == Level::Speed);
            let axes: Vec<Option<(FrameId, usize)>> = match value {
                Value::Vector(_) => held.iter().map(|held| held.place).collect(),
                _ => vec![None],
            };
            (axes, if is_of_speeds { Level::Speed } else { Level::Position })
        });
        let of_zero = self.dimension_of(part).unwrap_or_else(Dimension::none);
        let dimension = super::of_multiplier(level, of_zero);
        let entry_name = if several { format!(".{}", entry + 1) } else { String::new() };
        for (component, axis) in axes.into_iter().enumerate() {
            let along = axis.map_or_else(String::new, |(_, axis)| format!(".{}", ["x", "y", "z"][axis]));
            let impulse = format!("{name}.impulse{entry_name}{along}");
            let unit = units::Dimension::of(&dimension.to_string()).coherent();
            let input = Input { name: format!("{impulse}'"), dimension, unit, value: None, at: span.clone() };
            self.model.inputs.push(input);
            let letter = self.scalar(Scalar::Input(self.model.inputs.len() - 1), Some(dimension));
            self.reaction_letters.push(ReactionLetter {
                constraint: name.to_owned(),
                entry,
                axis,
                component,
                impulse,
                dimension,
                at: span.clone(),
                letter: Some(letter),
            });
        }
        Ok(())
    }
}

/// Returns the expressions of all constraints with a name.
fn entries<'s>(source: &'s Source, name: &'s str) -> impl Iterator<Item = &'s Text> {
    let own = move |one: &&ConstraintSource| one.name.as_ref().is_some_and(|own| own.text == name);
    source.constraints.iter().filter(own).flat_map(|one| &one.zero)
}

/// Adds the law of each impulse, from the multipliers of the model `open`, in which the reactions are inputs.
///
/// # Errors
/// A reaction is not determined, or the system has contacts.
pub(in crate::elaboration) fn with_laws(
    model: &mut Model,
    open: &Model,
    letters: &[ReactionLetter],
) -> Result<(), Vec<Fault>> {
    let fault = |title: String, label: &str, accepted: &str| {
        Err(vec![Fault::at(letters[0].at.clone(), title, label, accepted)])
    };
    if let Some(contact) = open.contacts.iter().find(|contact| contact.one_way.is_none()) {
        let title = format!("reactions in loads are not supported together with the contact `{}` yet", contact.name);
        let accepted =
            "a system without [[contact]], or a friction that the loads write out: mu*abs(reaction(pin))*sign(w)";
        return fault(title, "this reaction", accepted);
    }
    let found = apart(|| {
        let before = Trace::of(open);
        let Ok((_, multipliers)) = solved(&before) else { return None };
        let equations = crate::equations::constraints_of(&before);
        let of = |letter: &ReactionLetter| -> Option<Sym> {
            let named = |place: &usize| open.constraints[*place].name.as_deref() == Some(letter.constraint.as_str());
            let constraint = (0..open.constraints.len()).filter(named).nth(letter.entry)?;
            let row = equations.iter().position(|one| one.of == [constraint, letter.component]);
            // a redundant constraint has the multiplier zero
            Some(row.map_or(Sym::ZERO, |row| multipliers[row]))
        };
        let multipliers = letters.iter().map(of).collect::<Option<Vec<Sym>>>()?;
        let trace = Trace::of(model);
        let first = impulse_place(model, &letters[0])?;
        let rest: Vec<Sym> =
            multipliers.into_iter().zip(&trace.speeds[first..]).map(|(lambda, rate)| lambda - *rate).collect();
        transcribed(&trace, &rest)
    });
    let Some((arena, laws)) = found else {
        let title = format!("the reaction of `{}` is not determined", letters[0].constraint);
        let accepted = "constraints none of which follows from others, and masses that the motion moves";
        return fault(title, "a load or an event holds it", accepted);
    };
    let first = impulse_place(model, &letters[0]).unwrap_or_default();
    model.arena = arena;
    let laws = laws.into_iter().zip(first..);
    model.generalised.extend(laws.map(|(is, place)| GeneralisedForce { along: Along::Speed(place), is }));
    model.impulses = (first..first + letters.len()).collect();
    Ok(())
}

fn impulse_place(model: &Model, letter: &ReactionLetter) -> Option<usize> {
    model.coordinates.iter().position(|coordinate| coordinate.name == letter.impulse)
}
