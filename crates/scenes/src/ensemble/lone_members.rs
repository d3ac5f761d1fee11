//! Ensemble members that run one by one, with laws compiled for their own parameters: their law changes at conditions, events or
//! contacts, or limits the step at some times.

use super::ModelEnsemble;
use crate::changing_laws::is_watched;
use crate::modes::{Modes, Refused, described};
use model::Model;
use simulation::ensemble::{Drawn, Ended, IndividualMembers, Last, Stopped};
use simulation::{Choice, IvpScene};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

/// The time limit of a member: practically none, since the time of the whole ensemble is limited.
const UNLIMITED: Duration = Duration::from_secs(1 << 30);

/// A text that determines the laws and events of a model, for the fingerprint of the ensemble; `None` if the members run in batches.
/// `has_haste` is true if the law limits the step at some times.
pub(super) fn laws_of(model: &Model, has_haste: bool) -> Option<String> {
    (is_watched(model) || has_haste).then(|| described(model).unwrap_or_else(|reason| reason.to_string()))
}

impl IndividualMembers for ModelEnsemble {
    fn run_alone(&self, drawn: &[Drawn], goes_on: &dyn Fn() -> bool) -> Result<Ended, Stopped> {
        let (parameters, start) = self.placed(drawn)?;
        let mut model = (*self.scene.model).clone();
        for (parameter, value) in model.parameters.iter_mut().zip(parameters) {
            parameter.value = Some(value);
        }
        let model = Arc::new(model);
        let system = Modes::of(&model, &[], &[]).first(&start).map_err(|refused| {
            Stopped::Start(match refused {
                Refused::Law(reason) => reason.to_string(),
                Refused::Motion { why, .. } => why.to_owned(),
                Refused::Contact(unfit) => unfit.why.to_owned(),
            })
        })?;
        let scene = self.scene.with(model, system, start);
        let states = scene.start.len();
        let choice = Choice { samples: 1, allowed: UNLIMITED, ..scene.run.choice() };
        let on = |_| if goes_on() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
        let trajectory = scene.problem(choice.axes).simulate_while(&choice, on);
        let (state, derived) = trajectory.last.split_at(states.min(trajectory.last.len()));
        let finite = |number: &f64| number.is_finite().then_some(*number);
        let last = Last {
            time: trajectory.outcome.time,
            state: state.to_vec(),
            derived: derived.iter().map(finite).collect(),
        };
        let stopped = trajectory.left.map(Stopped::Left).or(trajectory.outcome.failure().map(Stopped::Run));
        Ok(Ended { last, steps: trajectory.outcome.work.steps, stopped })
    }
}
