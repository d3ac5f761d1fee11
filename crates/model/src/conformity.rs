//! What the loads of every system should do, whoever wrote it: act in pairs, ask for no observer, and take energy where speeds bring
//! them in.

use crate::equations::vanishes;
use crate::principles::loads::generalised;
use crate::{Force, Material, Model, Torque, Trace, Vector};
use symbolic::Sym;

/// Loads of a system by where they come from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pairs {
    /// Loads between two bodies, or two points: equal and opposite.
    pub between: usize,
    /// Loads that act on one body alone, by what they act on.
    pub from_outside: Vec<String>,
    /// Loads between two bodies that change for an observer who moves and turns steadily.
    pub observed: Vec<String>,
}

impl Pairs {
    /// Of all loads of a model.
    pub fn of(model: &Model) -> Self {
        let (rests, moves) = (Trace::of(model), Trace::observed(model));
        let mut found = Pairs::default();
        let is_contact = |vector: Vector| {
            let held: Vec<Sym> = vector.components.iter().flat_map(|component| component.symbols_of()).collect();
            let mut letters =
                (0..model.contacts.len()).flat_map(|contact| [0, 1].map(|part| rests.reaction(contact, part)));
            letters.any(|letter| held.contains(&letter))
        };
        for force in &model.forces {
            match force {
                // a contact is a pair of its own
                Force::On { is, .. } if is_contact(rests.vector(*is)) => {}
                Force::On { at, .. } => found.from_outside.push(format!("a force on {}", place(model, *at))),
                Force::Between { points: [first, second], is } => {
                    found.between += 1;
                    if !vanishes(rests.scalar(*is) - moves.scalar(*is)) {
                        found.observed.push(format!(
                            "the force between {} and {}",
                            place(model, *first),
                            place(model, *second)
                        ));
                    }
                }
            }
        }
        for torque in &model.torques {
            let frame = |frame: crate::FrameId| format!("`{}`", model.frames[frame.0].name);
            match torque {
                Torque::On { is, .. } if is_contact(rests.vector(*is)) => {}
                Torque::On { frame: on, .. } => found.from_outside.push(format!("a torque on {}", frame(*on))),
                Torque::Between { frames: [first, second], is } => {
                    found.between += 1;
                    let (one, other) = (rests.vector(*is), moves.vector(*is));
                    let other = moves.express(other, one.frame);
                    let differs = one.components.iter().zip(other).any(|(one, other)| !vanishes(*one - other));
                    if differs {
                        found.observed.push(format!("the torque between {} and {}", frame(*first), frame(*second)));
                    }
                }
            }
        }
        found
    }
}

fn place(model: &Model, Material { body, point }: Material) -> String {
    match body {
        Some(body) => format!("`{}`", model.bodies[body.0].name),
        None => format!("the point `{}`", model.points[point.0].name),
    }
}

/// The forces without a potential along each speed, masses that vary by their values.
pub fn forces_without_potential(trace: &Trace<'_>) -> Vec<Sym> {
    trace.with_masses(&generalised(trace, false))
}
