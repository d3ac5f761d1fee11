//! Algebraic speeds at the start: speeds that a law without inertia determines, by the law of the first mode.

use super::given;
use crate::compiled_system::{CompiledSystem, ImplicitSpeeds};
use crate::modes::Modes;
use crate::row_units::measured;
use model::Model;
use reader::Issue;
use std::sync::Arc;

/// Largest accepted difference between a given speed and its law, relative to the largest speed.
const MET: f64 = 1e-9;

/// Sets the algebraic speeds that the file does not give, by the law of the first mode; the state is unchanged where no mode is possible.
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

/// Sets all algebraic speeds of a start; returns a fault if the file gives one of them with another value.
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
