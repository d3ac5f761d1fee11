//! Algebraic speeds at the start, by the laws of the first mode.

use super::given;
use crate::compiled_system::{CompiledSystem, ImplicitSpeeds};
use crate::modes::Modes;
use crate::row_units::measured;
use model::Model;
use reader::Issue;
use std::sync::Arc;

/// A given speed may differ from its law by so much of the largest one.
const MET: f64 = 1e-9;

/// Gives algebraic speeds that the file does not give what the laws of the first mode make of them, where there is one.
pub(crate) fn complete_algebraic_speeds(model: &Model, state: &mut [f64]) {
    if model.algebraic_speeds.is_empty() || model.unsolved_law.is_some() {
        return;
    }
    if let Some(reactions) = ImplicitSpeeds::in_the_middle(model) {
        reactions.set(0.0, (model.positions(), &mut *state));
    }
    let Ok(system) = Modes::of(&Arc::new(model.clone()), &[], &[]).first(state) else { return };
    let (mut all, given) = (state.to_vec(), given(model));
    system.set_algebraic_speeds(0.0, &mut all);
    for (place, value) in all.into_iter().enumerate().filter(|(place, _)| !given[*place]) {
        state[place] = value;
    }
}

/// Completes the algebraic speeds of a start; the fault of the first that the file gives otherwise.
pub(crate) fn with_algebraic_speeds(model: &Model, system: &CompiledSystem, start: &mut [f64]) -> Option<Issue> {
    let (written, given) = (start.to_vec(), given(model));
    system.set_algebraic_speeds(0.0, start);
    let first = model.positions();
    let largest = start[first..].iter().fold(0.0, |largest: f64, speed| largest.max(speed.abs()));
    let differs = |place: usize| given[place] && (start[place] - written[place]).abs() > MET * largest;
    let speed = model.algebraic_speeds.iter().copied().find(|&speed| differs(first + speed))?;
    let (coordinate, (name, unit)) = (&model.coordinates[speed], &model.state_names()[first + speed]);
    let [is, given] = [&*start, &written].map(|state| measured(state[first + speed], unit));
    let title = format!("the law of `{}` does not hold at the start", coordinate.name);
    let issue = Issue::at(coordinate.at.clone(), title, format!("it gives {name} = {is}, and [start] gives {given}"));
    Some(issue.accepted("a start without this speed: nothing with inertia moves with it, so that its law gives it"))
}
