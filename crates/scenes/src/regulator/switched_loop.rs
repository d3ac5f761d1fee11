//! The closed loop of a model whose law changes at conditions or events: the feedback becomes a part of the model, which then runs as any
//! other.
//!
//! The gains follow from the law at the start. Saturated forces, stops and dry friction act in the run as the file defines them.

use super::METHOD;
use super::closed_loop::ClosedRun;
use crate::modes::Modes;
use crate::refused_start::not_started;
use crate::scene::ModelScene;
use integrators::{Record, Span, Tolerance};
use model::Feedback;
use reader::Issue;
use simulation::events::Switching;
use std::sync::Arc;
use std::time::Instant;

/// Runs the closed loop from a displaced start; the cost is an additional coordinate.
///
/// # Errors
/// If the law at the displaced start cannot be compiled, or no motion starts there.
pub(super) fn run(
    scene: &ModelScene,
    feedback: &Feedback,
    displaced: &[f64],
    tolerance: f64,
    deadline: Instant,
) -> Result<ClosedRun, Issue> {
    let n = scene.model.positions();
    let deviation = |time: f64, state: &[f64]| -> Vec<f64> {
        let motion = &feedback.motion;
        let there = |place: usize| motion[place] + if place < n { time * motion[n + place] } else { 0.0 };
        state.iter().enumerate().map(|(place, part)| part - there(place)).collect()
    };
    let rate = feedback.cost(&deviation(0.0, displaced));
    let (coordinates, speeds) = displaced.split_at(n);
    let start = [coordinates, &[0.0], speeds, &[rate]].concat();
    let model = Arc::new(scene.model.closed_by(feedback));
    let system = Modes::of(&model, &[], &[]).first(&start).map_err(|why| not_started(&model, why))?;
    let closed = scene.with(model, system, start.clone());
    let (problem, modes) = closed.switched();
    let mut span = Span::new(0.0, scene.run.span, &start).with_even_outputs(scene.run.samples).with_deadline(deadline);
    span.outputs.insert(0, 0.0);
    let mut record = Record::new();
    let (outcome, left) = problem.integrate(METHOD, &Tolerance::both(tolerance), &span, &mut record);
    let (mut times, mut all) = (record.times, record.states);
    if times.last().is_none_or(|last| *last < outcome.time) {
        times.push(outcome.time);
        all.push(outcome.state.clone());
    }
    let states: Vec<Vec<f64>> =
        all.iter().map(|state| [&state[..n], &state[n + 1..state.len() - 1]].concat()).collect();
    let deviations: Vec<Vec<f64>> = times.iter().zip(&states).map(|(&time, state)| deviation(time, state)).collect();
    let inputs = |deviation: &Vec<f64>| -> Vec<f64> {
        feedback.inputs.iter().zip(feedback.added(deviation)).map(|((_, value, _), by)| value + by).collect()
    };
    Ok(ClosedRun {
        inputs: deviations.iter().map(inputs).collect(),
        costs: all.iter().map(|state| state[n]).collect(),
        passages: modes.map_or_else(Vec::new, |modes| modes.passages()),
        left,
        deviations,
        states,
        times,
        outcome,
    })
}
