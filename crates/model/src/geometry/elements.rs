//! Forces between two points, and the remaining forces at single points.

use super::samples::{POINTS, value};
use super::terms;
use crate::arena::{Scalar, Vector as Form};
use crate::{Force, Material, PointId, ScalarId, Trace, Vector, VectorId};
use symbolic::Sym;

/// The kind of a force, by the quantities that it depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Action {
    /// A spring: depends on positions, and increases against displacements of its ends.
    Elastic,
    /// A dashpot: depends on speeds.
    Viscous,
    /// A field, such as gravitational attraction: depends on positions, and decreases with displacements of its ends.
    Field,
    /// A given force, which depends on neither positions nor speeds.
    Given,
}

/// A force along the line between two points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    /// The indices of the two points.
    pub ends: [usize; 2],
    pub action: Action,
}

/// A force at a point, split into terms.
#[derive(Clone, Debug)]
pub(super) struct Load {
    /// The index of the point.
    pub place: usize,
    /// The terms of the force, in N.
    pub terms: Vec<Vector>,
}

/// Returns the elements among the forces of a model, and the other forces.
pub(super) fn of_forces(trace: &Trace<'_>) -> (Vec<Element>, Vec<Load>) {
    let (mut elements, mut others) = (Vec::new(), Vec::new());
    for force in &trace.model.forces {
        let (ends, size) = match force {
            Force::Between { points, is } => (points.map(|material| material.point.0), *is),
            Force::On { at, is } => match from_ground(trace, at, *is) {
                Some((from, size)) => ([from, at.point.0], size),
                None => {
                    others.push(Load { place: at.point.0, terms: vector_terms(trace, *is) });
                    continue;
                }
            },
        };
        elements.extend(actions(trace, ends, trace.scalar(size)).into_iter().map(|action| Element { ends, action }));
    }
    (elements, others)
}

/// Splits a vector into terms. A vector scaled by a sum is split by the terms of the sum.
pub(super) fn vector_terms(trace: &Trace<'_>, vector: VectorId) -> Vec<Vector> {
    let (mut open, mut found) = (vec![(vector, false)], Vec::new());
    let signed = |is_negative: bool, of: Sym| if is_negative { -of } else { of };
    while let Some((id, is_negative)) = open.pop() {
        match trace.model.arena.vector_at(id) {
            Some(Form::Sum(a, b)) => open.extend([(*b, is_negative), (*a, is_negative)]),
            Some(Form::Difference(a, b)) => open.extend([(*b, !is_negative), (*a, is_negative)]),
            Some(Form::Negation(a)) => open.push((*a, !is_negative)),
            Some(Form::Scaled(scale, a)) => {
                let one = |(term, is_less): (ScalarId, bool)| {
                    let scale = signed(is_less != is_negative, trace.scalar(term));
                    trace.vector(*a).map(|part| scale * part)
                };
                found.extend(terms(trace, *scale).into_iter().map(one));
            }
            _ => found.push(trace.vector(id).map(|part| signed(is_negative, part))),
        }
    }
    found
}

/// Recognises a force along the line from a point of the ground. Returns the point of the ground and the magnitude.
fn from_ground(trace: &Trace<'_>, at: &Material, is: VectorId) -> Option<(usize, ScalarId)> {
    let arena = &trace.model.arena;
    let Form::Scaled(share, line) = arena.vector_at(is)? else { return None };
    let Form::Between { from, to } = arena.vector_at(*line)? else { return None };
    let Scalar::Quotient(size, length) = arena.scalar_at(*share)? else { return None };
    let is_length = matches!(arena.scalar_at(*length)?, Scalar::Norm(of) if of == line);
    (is_length && *to == at.point).then_some((from.0, *size))
}

/// Returns the actions of a force, from its magnitude at zero speeds and its dependence on speeds.
fn actions(trace: &Trace<'_>, ends: [usize; 2], size: Sym) -> Vec<Action> {
    let rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    let at_rest = size.substitute(&rest);
    let has = |letters: &[Sym], of: Sym| of.symbols_of().iter().any(|letter| letters.contains(letter));
    let mut found = Vec::new();
    if has(&trace.coordinates, at_rest) {
        let line = trace.between(PointId(ends[0]), PointId(ends[1]));
        let square = trace.dot(line, line);
        let at = |point: u64| Some((value(trace, square, point)?, -value(trace, at_rest, point)?));
        let grows = (0..POINTS).map(at).collect::<Option<Vec<_>>>().is_none_or(|samples| grows(&samples));
        found.push(if grows { Action::Elastic } else { Action::Field });
    }
    if has(&trace.speeds, size) {
        found.push(Action::Viscous);
    }
    if found.is_empty() {
        found.push(Action::Given);
    }
    found
}

/// Returns whether the second numbers increase with the first on average (nonnegative covariance).
pub(super) fn grows(samples: &[(f64, f64)]) -> bool {
    let count = samples.len().max(1) as f64;
    let (first, second) = samples.iter().fold((0.0, 0.0), |(a, b), (x, y)| (a + x / count, b + y / count));
    samples.iter().map(|(x, y)| (x - first) * (y - second)).sum::<f64>() >= 0.0
}
