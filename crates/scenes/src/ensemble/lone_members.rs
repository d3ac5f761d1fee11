//! Ensemble members whose law changes at conditions, events or contacts, or fast in time: each runs alone, with laws compiled for its
//! values.

use super::ModelEnsemble;
use crate::changing_laws::is_watched;
use crate::modes::{Modes, Refused, described};
use model::Model;
use simulation::ensemble::{Drawn, Ended, IndividualMembers, Last, Stopped};
use simulation::{Choice, IvpScene};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

/// The time limit of a member: none, since the time of the whole run is limited.
const UNLIMITED: Duration = Duration::from_secs(1 << 30);

/// All that decides the laws and the events of a model that has any, or whose law changes fast by itself at some times, for its fingerprint;
/// none of one without.
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
