//! The hierarchy of models of a text model, with or without events.

use super::outputs::{Watched, largest};
use super::plan::Runnable;
use super::run_rows::{Along, Run};
use super::sampled_run::{COARSE, looks};
use super::{Hierarchy, ReducedModel};
use integrators::{Failure, Method, Observer, Record, Span, Tolerance};
use simulation::models::Modelled;
use simulation::{Axes, Problem};
use std::sync::Arc;

/// Reduced models of systems that files name by `known_as`, for the parameter values of a file.
pub struct Reductions {
    /// The name, as in [`simulation::knowledge::Knowledge`].
    pub name: &'static str,
    pub models: fn(&dyn Modelled) -> Vec<ReducedModel>,
}

inventory::collect!(Reductions);

/// The reason why a run that an event ends early cannot be compared: later output times have no rows.
const ENDS: &str = "an event ends the run before its span";

impl Hierarchy {
    /// The hierarchy of a text model.
    pub fn of_model(scene: &dyn Modelled) -> Self {
        let own = scene.problem(Axes::First);
        let known = inventory::iter::<Reductions>().filter(|one| scene.known_as() == Some(one.name));
        let models = known.flat_map(|one| (one.models)(scene)).collect();
        Hierarchy {
            model: scene.model().to_owned(),
            written: scene.symbolic_law(),
            law: Arc::clone(&own.law),
            start: own.state.clone(),
            whole: Box::new(|_, state| state.to_vec()),
            models,
            lumping: None,
            metered: Some(scene.metered(Axes::First)).filter(|metered| metered.metered > 0),
            own,
        }
    }

    /// As [`Hierarchy::watched`], for a problem with events.
    pub(super) fn watched_across_events(&self, names: &[String]) -> Result<(Watched, u64), Failure> {
        let (own, mut record) = (&self.own, Record::new());
        let outputs: Vec<f64> = looks(own.span).collect();
        let span = Span::new(0.0, own.span, &own.state).with_outputs(&outputs);
        let mut steps = Steps(Vec::new());
        let (method, coarse) = (Method::DormandPrince8, Tolerance::both(COARSE));
        let (outcome, left) = own.integrate(method, &coarse, &span, &mut (&mut record, &mut steps));
        if let (Some(failure), None) = (outcome.failure(), left) {
            return Err(failure);
        }
        let left = left.or((outcome.time < own.span).then_some(ENDS));
        let sampled = record.times.into_iter().zip(record.states);
        let seen: Vec<(f64, Vec<f64>)> = [(0.0, own.state.clone())].into_iter().chain(sampled).chain(steps.0).collect();
        let rows: Vec<Vec<f64>> = seen.iter().map(|(time, state)| (own.row)(*time, state)).collect();
        let sizes = (0..own.state.len()).map(|i| largest(seen.iter().map(|(_, state)| state[i]))).collect();
        Ok((Watched { left, ..Watched::of(&own.columns, names, &rows, sizes) }, outcome.work.rates))
    }
}

/// A problem with events, in a form that a choice can run.
pub(super) fn across_events(axes: Axes, own: &Problem) -> Runnable<'_> {
    Runnable::new(axes, own.span, |method, tolerance, most, times, serves| {
        let span = Span::new(0.0, own.span, &own.state).with_outputs(times).with_evaluations(most);
        let mut along = Along::within(|time, state: &[f64]| (own.row)(time, state), &|_, _| false, serves);
        let (outcome, left) = own.integrate(method, &Tolerance::both(tolerance), &span, &mut along);
        let evaluations = outcome.work.rates + outcome.work.jacobians * own.state.len() as u64;
        let is_whole = outcome.reached() && left.is_none() && outcome.time == own.span && !along.left();
        let run: Option<Run> = is_whole.then(|| along.run(evaluations));
        (run, evaluations)
    })
}

/// The states at the steps of a run.
struct Steps(Vec<(f64, Vec<f64>)>);

impl Observer<f64> for Steps {
    fn step(&mut self, time: f64, state: &[f64]) {
        self.0.push((time, state.to_vec()));
    }
}
