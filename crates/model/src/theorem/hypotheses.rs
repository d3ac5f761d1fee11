//! The hypotheses of the theorem, checked on a model.

use crate::joints::powers_of_reactions;
use crate::principles::Principle;
use crate::principles::loads::{along, forces, torques};
use crate::{Body, FrameId, Inertia, Trace, Turn};
use symbolic::{Hypotheses, Sym, decide};

/// Returns whether every angle of a frame, every displacement between points and the potential is a function of positions and time.
pub(super) fn are_functions_of_places(trace: &Trace<'_>) -> bool {
    let model = trace.model;
    let angles = model.frames.iter().filter_map(|frame| match frame.parent {
        Some((_, Turn::About { angle, .. })) => Some(trace.scalar(angle)),
        _ => None,
    });
    let ways = model.points.iter().filter_map(|point| Some(trace.vector(point.base?.1).components)).flatten();
    let potential = model.energies.potential.map(|potential| trace.scalar(potential));
    let is_of_places = |function: Sym| !holds_any(function, &[&trace.speeds, &trace.accelerations]);
    angles.chain(ways).chain(potential).all(is_of_places)
}

/// Returns whether the lemmas cover all quantities of a model that a principle uses.
pub(super) fn are_fulfilled(trace: &Trace<'_>, principle: Principle) -> bool {
    let model = trace.model;
    are_functions_of_places(trace)
        && match principle {
            // T may be any function of positions, speeds and time
            Principle::Lagrange | Principle::Hamilton => true,
            _ => model.energies.kinetic.is_none() && model.bodies.iter().all(|body| is_carried(trace, body)),
        }
        && match principle {
            // the forces must not depend on the accelerations that are varied
            Principle::Gauss => loads(trace).all(|load| !holds_any(load, &[&trace.accelerations])),
            Principle::NewtonEuler => model.contacts.is_empty() && reactions_act_as_constraints_say(trace),
            _ => true,
        }
}

/// Returns whether the power of every reaction at its point of action equals its multiplier times the rate of its constraint.
fn reactions_act_as_constraints_say(trace: &Trace<'_>) -> bool {
    let shown = |(power, slope): (Sym, Sym)| {
        let difference = power - slope;
        Sym::operations_of(&[difference]) <= MOST_EXPANDED && decide(difference, &Hypotheses::none()).is_zero()
    };
    powers_of_reactions(trace).is_some_and(|pairs| pairs.into_iter().all(shown))
}

/// Longer differences are not brought to normal form.
const MOST_EXPANDED: usize = 4_000;

fn holds_any(expression: Sym, letters: &[&[Sym]]) -> bool {
    expression.symbols_of().iter().any(|symbol| letters.iter().any(|letters| letters.contains(symbol)))
}

/// Returns whether an inertia tensor is constant in the body's axes, or has equal moments about two axes of a frame relative to which the body spins about the third.
fn is_carried(trace: &Trace<'_>, body: &Body) -> bool {
    let (Some(inertia), Some(frame)) = (&body.inertia, body.frame) else { return true };
    let Inertia::Tensor { axes, entries } = inertia else { return true };
    if trace.is_of_ball(inertia) {
        return true;
    }
    let [first, second, third, products @ ..] =
        entries.map(|entry| entry.map_or(Sym::ZERO, |entry| trace.scalar(entry)));
    let moments = [first, second, third];
    let is_round = |axis: usize| moments[(axis + 1) % 3] == moments[(axis + 2) % 3] && products == [Sym::ZERO; 3];
    let turned_in = |frame: FrameId| match trace.model.frames[frame.0].parent {
        Some((parent, Turn::About { axis, angle })) => Some((parent, axis, trace.scalar(angle))),
        _ => None,
    };
    // axes at a constant angle to the body's frame are fixed in the body
    let resting = |frame: &FrameId| {
        turned_in(*frame).filter(|(_, _, angle)| trace.rate_of(*angle) == Sym::ZERO).map(|(parent, ..)| parent)
    };
    let spinning =
        |frame: &FrameId| turned_in(*frame).filter(|(_, axis, _)| is_round(*axis)).map(|(parent, ..)| parent);
    std::iter::successors(Some(*axes), resting).any(|at| at == frame)
        || std::iter::successors(Some(frame), spinning).any(|at| at == *axes)
}

/// Returns the components of all forces and torques, and the generalised forces.
fn loads<'t>(trace: &'t Trace<'_>) -> impl Iterator<Item = Sym> + 't {
    let forces = forces(trace, true).into_iter().flat_map(|force| force.is.components);
    let torques = torques(trace).into_iter().flat_map(|torque| torque.is.components);
    forces.chain(torques).chain((0..trace.speeds.len()).map(|speed| along(trace, speed)))
}
