//! Classification of the loads of a system into action-reaction pairs and external loads, and the loads without a potential along each
//! speed.

use crate::principles::loads::generalised;
use crate::{Along, Force, Material, Model, Torque, Trace, Vector};
use symbolic::{Dimension, Sym};

/// The loads of a system by their origin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pairs {
    /// The number of loads between two bodies or points, which act on both with opposite signs.
    pub between: usize,
    /// Descriptions of loads that act on one body only.
    pub from_outside: Vec<String>,
    /// Descriptions of generalised forces along coordinates other than electric charges.
    pub along: Vec<String>,
}

impl Pairs {
    /// Classifies the loads of a model.
    pub fn of(model: &Model) -> Self {
        let trace = Trace::of(model);
        // the reactions of a contact form a pair
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
        // a coordinate of a reaction's impulse is internal to the program
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

/// Returns the generalised forces without a potential, one for each speed, with variable masses replaced by their expressions.
pub fn forces_without_potential(trace: &Trace<'_>) -> Vec<Sym> {
    trace.with_masses(&generalised(trace, false))
}
