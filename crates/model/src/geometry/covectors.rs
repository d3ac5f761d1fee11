//! Terms of energies, generalised forces, forces at points and constraints, as covectors in the space of the coordinates.

use super::elements::Load;
use super::samples::is_of_state;
use super::{Action, terms, written_distances};
use crate::equations::{Level, ScalarConstraint, held_of};
use crate::{Along, PointId, Trace, Zero};
use symbolic::Sym;

/// A covector with one component per speed: the gradient of an energy or of a constraint, or a generalised force.
pub(super) struct Covector {
    pub kind: Kind,
    pub slope: Vec<Sym>,
    /// Pairs of points whose distance occurs literally in the expression.
    pub written: Vec<[usize; 2]>,
}

/// The origin of a covector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A term of the potential energy or of the dissipation function; the generalised force is its negative gradient.
    Energy(Action),
    /// A term of a generalised force along a coordinate, with opposite sign.
    Generalised(Action),
    /// A term of a force at a point, with opposite sign; the array contains the number of the load and that of the term.
    Load(Action, [usize; 2]),
    /// A constraint of positions, by its index.
    Position(usize),
    /// A constraint of speeds, by its index.
    Speed(usize),
}

/// Returns all covectors of a model.
pub(super) fn covectors(trace: &Trace<'_>, loads: &[Load]) -> Vec<Covector> {
    let model = trace.model;
    let mut found = Vec::new();
    for (id, _) in model.energies.potential.into_iter().flat_map(|sum| terms(trace, sum)) {
        let slope = by_each(trace, |i| trace.by_coordinate(trace.scalar(id), i));
        found.push(Covector { kind: Kind::Energy(Action::Elastic), slope, written: written_distances(trace, id) });
    }
    for (id, _) in model.energies.dissipation.into_iter().flat_map(|sum| terms(trace, sum)) {
        let slope = by_each(trace, |i| trace.by_speed(trace.scalar(id), i));
        found.push(Covector { kind: Kind::Energy(Action::Viscous), slope, written: written_distances(trace, id) });
    }
    for force in &model.generalised {
        let Along::Speed(along) = force.along else { continue };
        for (id, is_negative) in terms(trace, force.is) {
            let term = if is_negative { trace.scalar(id) } else { -trace.scalar(id) };
            let Some(action) = action_of(trace, &[term]) else { continue };
            let slope = by_each(trace, |i| if i == along { term } else { Sym::ZERO });
            found.push(Covector { kind: Kind::Generalised(action), slope, written: Vec::new() });
        }
    }
    for (number, load) in loads.iter().enumerate() {
        let position = trace.position(PointId(load.place));
        for (place, term) in load.terms.iter().enumerate() {
            let Some(action) = action_of(trace, &term.components) else { continue };
            let slope = by_each(trace, |i| -trace.dot(*term, trace.vector_by_coordinate(position, i)));
            found.push(Covector { kind: Kind::Load(action, [number, place]), slope, written: Vec::new() });
        }
    }
    for (place, constraint) in model.constraints.iter().enumerate() {
        let Zero::Scalar(zero) = constraint.zero else { continue };
        let of_held = |held: ScalarConstraint| {
            let (kind, slope) = match trace.level_of(held.zero) {
                Level::Position => (Kind::Position(place), by_each(trace, |i| trace.by_coordinate(held.zero, i))),
                Level::Speed => (Kind::Speed(place), by_each(trace, |i| trace.by_speed(held.zero, i))),
            };
            Covector { kind, slope, written: written_distances(trace, zero) }
        };
        found.extend(held_of(trace, place).into_iter().map(of_held));
    }
    found
}

fn by_each(trace: &Trace<'_>, part: impl Fn(usize) -> Sym) -> Vec<Sym> {
    (0..trace.speeds.len()).map(part).collect()
}

/// Returns the action of a force or torque, by the quantities that its components depend on; `None` if it depends on reactions.
pub(super) fn action_of(trace: &Trace<'_>, components: &[Sym]) -> Option<Action> {
    if !components.iter().all(|component| is_of_state(trace, *component)) {
        return None;
    }
    let used: Vec<Sym> = components.iter().flat_map(|component| component.symbols_of()).collect();
    let has = |letters: &[Sym]| letters.iter().any(|letter| used.contains(letter));
    Some(match (has(&trace.coordinates), has(&trace.speeds)) {
        (_, true) => Action::Viscous,
        (true, false) => Action::Elastic,
        (false, false) => Action::Given,
    })
}
