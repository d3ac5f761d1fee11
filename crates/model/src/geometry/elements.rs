//! Forces between two places.

use crate::arena::{Scalar, Vector as Form};
use crate::{Force, FrameId, Material, ScalarId, Trace, VectorId};
use symbolic::Sym;

/// What the force of an element depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Action {
    /// The positions: a spring.
    Elastic,
    /// The speeds: a dashpot.
    Viscous,
    /// Neither: a force that is given.
    Given,
}

/// A force along the line of two places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    /// By their numbers.
    pub ends: [usize; 2],
    pub action: Action,
}

/// Forces at places, along the axes of the ground.
type PlacedForces = Vec<(usize, [Sym; 3])>;

/// The elements among the forces of a model, and the other forces.
pub(super) fn of_forces(trace: &Trace<'_>) -> (Vec<Element>, PlacedForces) {
    let (mut elements, mut others) = (Vec::new(), Vec::new());
    for force in &trace.model.forces {
        let (ends, size) = match force {
            Force::Between { points, is } => (points.map(|material| material.point.0), *is),
            Force::On { at, is } => match from_ground(trace, at, *is) {
                Some((from, size)) => ([from, at.point.0], size),
                None => {
                    others.push((at.point.0, trace.express(trace.vector(*is), FrameId::GROUND)));
                    continue;
                }
            },
        };
        elements.extend(actions(trace, trace.scalar(size)).into_iter().map(|action| Element { ends, action }));
    }
    (elements, others)
}

/// The ground's end of a force between a place of the ground and a point, with its size.
fn from_ground(trace: &Trace<'_>, at: &Material, is: VectorId) -> Option<(usize, ScalarId)> {
    let arena = &trace.model.arena;
    let Form::Scaled(share, line) = arena.vector_at(is)? else { return None };
    let Form::Between { from, to } = arena.vector_at(*line)? else { return None };
    let Scalar::Quotient(size, length) = arena.scalar_at(*share)? else { return None };
    let is_length = matches!(arena.scalar_at(*length)?, Scalar::Norm(of) if of == line);
    (is_length && *to == at.point).then_some((from.0, *size))
}

/// The actions of a force by its size: what it is at rest, and what speeds add.
fn actions(trace: &Trace<'_>, size: Sym) -> Vec<Action> {
    let rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    let at_rest = size.substitute(&rest);
    let has = |letters: &[Sym], of: Sym| of.symbols_of().iter().any(|letter| letters.contains(letter));
    let mut found = Vec::new();
    if has(&trace.coordinates, at_rest) {
        found.push(Action::Elastic);
    }
    if has(&trace.speeds, size) {
        found.push(Action::Viscous);
    }
    if found.is_empty() {
        found.push(Action::Given);
    }
    found
}
