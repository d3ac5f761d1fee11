//! Drift: constraints that a run has come off.

use super::recorded::Recorded;
use crate::start::KeptConstraints;
use simulation::{FailureKind, RunFailure};

/// Residuals that no step of a run with constraints that are kept leaves, relative to the state.
const OFF: f64 = 1e-6;

/// The first sample at which the residual of the constraints is beyond what is kept.
pub(super) fn found(run: &Recorded<'_>) -> Option<RunFailure> {
    let kept = run.model().constraints.iter().any(|constraint| constraint.gains.is_none());
    if !kept {
        return None;
    }
    let place = run.trajectory.checks.iter().position(|name| name == "residual of constraints")?;
    let residuals = run.trajectory.checked.iter().map(|checked| checked[place]);
    let states = run.states.iter().zip(residuals);
    let is_off = |(_, state): &(f64, Vec<f64>), residual: f64| {
        residual > OFF * state.iter().fold(1.0, |size: f64, part| size.max(part.abs()))
    };
    let mut off = states.filter(|(state, residual)| is_off(state, *residual));
    let ((at, state), _) = off.next()?;
    let broken = KeptConstraints::of(run.model()).broken(*at, state)?;
    Some(RunFailure {
        kind: FailureKind::Drift,
        at: *at,
        evidence: broken,
        remedy: format!(
            "a finer tolerance than {:e} (--tol, or `tolerance` in [run]) or more steps; or `programmed = {{ gains = [...] }}` in the \
             constraint, which leads it back",
            run.choice.tolerance
        ),
    })
}
