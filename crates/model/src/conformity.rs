//! The loads of a system: those that act in pairs, and those without a partner; loads without a potential along each
//! speed.

use crate::principles::loads::generalised;
use crate::{Along, Force, Material, Model, Torque, Trace, Vector};
use symbolic::{Dimension, Sym};

/// The loads of a system by their origin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pairs {
    /// Loads between two bodies, or two points: equal and opposite.
    pub between: usize,
    /// Loads that act on one body alone, by their receivers.
    pub from_outside: Vec<String>,
    /// Loads along coordinates that are no charges.
    pub along: Vec<String>,
}

impl Pairs {
    /// Sorts the loads of a model.
    pub fn of(model: &Model) -> Self {
        let trace = Trace::of(model);
        // a contact is a pair of its own
        let letters: Vec<Sym> = trace.reactions();
        let is_contact = |vector: Vector| {
            vector.components.iter().flat_map(|component| component.symbols_of()).any(|held| letters.contains(&held))
        };
        let mut found = Pairs::default();
        for force in &model.forces {
            match force {
                Force::Between { .. } => found.between += 1,
                Force::On { is, .. } if is_contact(trace.vector(*is)) => {}
                Force::On { at, .. } => found.from_outside.push(format!("a force acts on {}", place(model, *at))),
            }
        }
        for torque in &model.torques {
            match torque {
                Torque::Between { .. } => found.between += 1,
                Torque::On { is, .. } if is_contact(trace.vector(*is)) => {}
                Torque::On { frame, .. } => {
                    found.from_outside.push(format!("a torque acts on `{}`", model.frames[frame.0].name))
                }
            }
        }
        let charge = Dimension::current() * Dimension::time();
        // an impulse of a reaction is a coordinate of the program's own
        let is_impulse = |along: &Along| matches!(along, Along::Speed(place) if model.impulses.contains(place));
        for force in model.generalised.iter().filter(|force| !is_impulse(&force.along)) {
            let coordinate = match force.along {
                Along::Speed(place) => model.coordinates.get(place),
                _ => None,
            };
            match coordinate {
                Some(coordinate) if coordinate.dimension == charge => {}
                Some(coordinate) => found.along.push(format!("a force acts along `{}`", coordinate.name)),
                None => found.along.push("a force acts along a speed".to_owned()),
            }
        }
        found.from_outside.dedup();
        found.along.dedup();
        found
    }
}

fn place(model: &Model, Material { body, point }: Material) -> String {
    match body {
        Some(body) => format!("`{}`", model.bodies[body.0].name),
        None => format!("the point `{}`", model.points[point.0].name),
    }
}

/// The forces without a potential along each speed, with the values of varying masses.
pub fn forces_without_potential(trace: &Trace<'_>) -> Vec<Sym> {
    trace.with_masses(&generalised(trace, false))
}
