//! The edge of the domain of a law: rates that have numbers at the last good state, and none a little further along the motion.

use super::samples::Samples;
use integrators::{Failure, Ode};
use simulation::{FailureKind, RunFailure};

/// Parts of the time of the run that are looked ahead, from the shortest on.
const AHEAD: [f64; 7] = [1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 1e-1];

/// The rates that have no number ahead of a run whose own numbers are moderate.
pub(super) fn left(run: &Samples<'_>) -> Option<RunFailure> {
    let is_lost = matches!(
        run.trajectory.outcome.failure(),
        Some(Failure::LeftTheNumbers { .. } | Failure::StepCollapsed { .. } | Failure::NewtonFailed { .. })
    );
    if !is_lost || run.sound().len() < run.states.len() {
        return None;
    }
    let (at, state) = run.last();
    let rates = |time: f64, state: &[f64]| {
        let mut rates = vec![0.0; state.len()];
        Ode::<f64>::rates(&*run.scene.system, time, state, &mut rates);
        rates
    };
    let here = rates(at, state);
    if here.iter().any(|rate| !rate.is_finite()) {
        return None;
    }
    let lost = AHEAD.into_iter().find_map(|part| {
        let h = part * at.max(f64::MIN_POSITIVE);
        let moved: Vec<f64> = state.iter().zip(&here).map(|(value, rate)| value + h * rate).collect();
        let place = rates(at + h, &moved).iter().position(|rate| rate.is_nan())?;
        Some((place, h))
    });
    let (place, h) = lost?;
    let names = run.model().state_names();
    let held: Vec<String> =
        (0..run.model().positions()).map(|place| run.told(place, state[place])).take(MOST_TOLD).collect();
    Some(RunFailure {
        kind: FailureKind::EndOfDomain,
        at,
        evidence: format!("the rate of `{}` has no number {h:.1e} s further on, from {}", names[place].0, held.join(", ")),
        remedy: "a law that has values there, such as `sqrt(abs(x))*sign(x)` or `if(x > 0, sqrt(x), 0)`; or an [[event]] with `end = true` \
                 before it"
            .to_owned(),
    })
}

/// Coordinates that are told.
const MOST_TOLD: usize = 6;
