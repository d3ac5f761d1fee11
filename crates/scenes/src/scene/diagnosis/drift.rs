//! Diagnosis of drift: the residuals of constraints become too large along a run.

use super::samples::Samples;
use crate::start::KeptConstraints;
use simulation::{FailureKind, RunFailure};

/// Largest accepted residual of constraints that the run enforces, relative to the state.
const OFF: f64 = 1e-6;

/// Largest accepted relative residual for constant steps; the error of such runs is measured with shorter steps.
const OFF_OF_STEPS: f64 = 1e-4;

/// For coarse tolerances, the accepted residual as a multiple of the tolerance.
const TOLERANCES: f64 = 10.0;

/// The failure at the first sample with a residual beyond the accepted one; `None` if the model has no enforced constraint.
pub(super) fn found(run: &Samples<'_>) -> Option<RunFailure> {
    let kept = run.model().constraints.iter().any(|constraint| constraint.gains.is_none());
    if !kept {
        return None;
    }
    let place = run.trajectory.checks.iter().position(|name| name == "residual of constraints")?;
    let residuals = run.trajectory.checked.iter().map(|checked| checked[place]);
    let largest = residuals.clone().fold(0.0, f64::max);
    let states = run.states.iter().zip(residuals);
    let most = match run.choice.method.steps() {
        Some(_) => OFF_OF_STEPS,
        None => OFF.max(TOLERANCES * run.choice.tolerance),
    };
    let is_off = |(_, state): &(f64, Vec<f64>), residual: f64| {
        residual > most * state.iter().fold(1.0, |size: f64, part| size.max(part.abs()))
    };
    let mut off = states.filter(|(state, residual)| is_off(state, *residual));
    let ((at, state), _) = off.next()?;
    let broken = KeptConstraints::of(run.model()).broken(*at, state)?;
    Some(RunFailure {
        kind: FailureKind::Drift,
        at: *at,
        evidence: format!("{broken}; the largest residual along the run is {largest:.1e} in SI units"),
        remedy: match run.choice.method.steps() {
            Some(steps) => format!(
                "more steps than {steps}, or a method that follows a tolerance, such as --method dormand_prince_8"
            ),
            None => format!("a finer tolerance than {:e}: --tol, or `tolerance` in [run]", run.choice.tolerance),
        },
    })
}
