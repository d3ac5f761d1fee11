//! Diagnosis of stiffness and unstable steps: stability, not accuracy, limits the step size of an explicit method.

use super::samples::Samples;
use crate::modes::Modes;
use integrators::{Failure, Jacobian, Method};
use nalgebra::{Complex, DMatrix, Schur};
use simulation::{FailureKind, Law, RunFailure};
use std::sync::Arc;

/// Largest number of states; the cost of eigenvalues grows with the cube of the number.
const MOST_STATES: usize = 128;

/// Least number of steps of a completed run that is examined.
const MANY_STEPS: u64 = 1_000;

/// A mode has decayed if the run lasts at least this many of its time constants.
const GONE: f64 = 1_000.0;

/// Number of samples at which eigenvalues are computed.
const LOOKS: usize = 5;

/// Largest number of iterations of the QR algorithm.
const MOST_ITERATIONS: usize = 10_000;

/// Real parts below this multiple of an eigenvalue's absolute value are rounding errors.
const ROUNDING: f64 = 1e-9;

/// Number of bisections for the longest stable step.
const HALVINGS: usize = 60;

/// Least growth of a mode over a run that explains an overflow.
const OVERFLOWS: f64 = 1e6;

/// A mode of the linearised equations.
struct Mode {
    /// The eigenvalue in 1/s.
    value: Complex<f64>,
    at: f64,
    /// Index of the speed with the largest component of the mode.
    moves: usize,
}

/// The failure of a run that stopped by the method's own test for stiffness, by an unstable constant step, or by a limit of time or
/// evaluations in a stiff system.
pub(super) fn found(run: &Samples<'_>) -> Option<RunFailure> {
    match run.trajectory.outcome.failure()? {
        Failure::Stiff { at } => {
            // undamped fast oscillations limit the step as well
            let is_kept = |mode: &Mode| mode.value.re <= ROUNDING * mode.value.norm();
            let mode = fastest(run, |mode| if is_kept(mode) { mode.value.norm() } else { -mode.value.re })?;
            is_kept(&mode).then(|| of(run, &mode, at))
        }
        Failure::LeftTheNumbers { .. } => unstable(run),
        Failure::OutOfTime { .. } | Failure::Interrupted { .. } | Failure::TooManyEvaluations { .. } => given_up(run),
        _ => None,
    }
}

/// The failure of a run with a constant step that amplifies a mode which does not grow in the exact motion.
fn unstable(run: &Samples<'_>) -> Option<RunFailure> {
    let (h, method) = (run.step(), run.choice.method);
    if !matches!(method, Method::Euler { .. } | Method::RungeKutta4 { .. }) {
        return None;
    }
    let growth = |mode: &Mode| amplified(method, mode.value * h);
    let mode = fastest(run, growth)?;
    let factor = growth(&mode);
    let fades = mode.value.re <= ROUNDING * mode.value.norm();
    if !fades || factor.powf(run.trajectory.outcome.work.steps as f64) < OVERFLOWS {
        return None;
    }
    let steps = longest(method, mode.value, h).map(|stable| (run.scene.run.span / stable).ceil());
    let steps = steps.map_or_else(String::new, |steps| format!("; or at least {steps} steps"));
    Some(RunFailure {
        kind: FailureKind::UnstableStep,
        at: mode.at,
        evidence: format!(
            "the mode that moves {} most has the eigenvalue {} and does not grow, but a step of {h:.1e} s of {method} multiplies it \
             by {factor:.3e}",
            moved(run, &mode),
            told(mode.value)
        ),
        remedy: format!("{IMPLICIT}{steps}"),
    })
}

/// The stiffness of a completed run: its steps had the length of the stability limit, although the fastest mode had decayed.
pub(super) fn hidden(run: &Samples<'_>) -> Option<RunFailure> {
    let traits = run.choice.method.traits();
    if traits.implicit || !traits.adaptive || run.trajectory.outcome.work.steps < MANY_STEPS {
        return None;
    }
    let mode = fastest(run, |mode| -mode.value.re)?;
    let fades = -mode.value.re;
    let is_held = fades * run.step() >= 1.0 && fades * run.last().0 >= GONE && mode.value.im.abs() < 0.5 * fades;
    is_held.then(|| of(run, &mode, mode.at))
}

/// The stiffness of a run that exceeded its time or its number of evaluations: its steps had the length of the stability limit, and the span is
/// many time constants of the fastest mode.
fn given_up(run: &Samples<'_>) -> Option<RunFailure> {
    let (traits, outcome) = (run.choice.method.traits(), &run.trajectory.outcome);
    if traits.implicit || !traits.adaptive || outcome.work.steps < MANY_STEPS {
        return None;
    }
    let mode = fastest(run, |mode| -mode.value.re)?;
    let fades = -mode.value.re;
    let is_held = fades * run.step() >= 1.0 && fades * run.scene.run.span >= GONE && mode.value.im.abs() < 0.5 * fades;
    is_held.then(|| of(run, &mode, mode.at))
}

/// The remedy for stiffness, for messages.
const IMPLICIT: &str = "an implicit method: --method radau_5 or rodas_4, or `method = \"radau_5\"` in [run]";

fn of(run: &Samples<'_>, mode: &Mode, at: f64) -> RunFailure {
    let (h, fades) = (run.step(), mode.value.norm());
    RunFailure {
        kind: FailureKind::Stiffness,
        at,
        evidence: format!(
            "the mode that moves {} most has the eigenvalue {}, and the run lasts {:.1e} of its time constants; the steps of {h:.1e} s \
             are {:.1} of them: the stability of {} bounds the steps, not the accuracy",
            moved(run, mode),
            told(mode.value),
            fades * run.scene.run.span,
            fades * h,
            run.choice.method
        ),
        remedy: IMPLICIT.to_owned(),
    }
}

/// The name of the speed with the largest component of a mode.
fn moved(run: &Samples<'_>, mode: &Mode) -> String {
    format!("`{}`", run.model().state_names()[run.model().positions() + mode.moves].0)
}

/// An eigenvalue for messages: `-2.000e4 1/s`, or with its imaginary part.
fn told(value: Complex<f64>) -> String {
    match value.im == 0.0 {
        true => format!("{:.3e} 1/s", value.re),
        false => format!("({:.3e} +- {:.3e} i) 1/s", value.re, value.im.abs()),
    }
}

/// The mode with the largest measure at some samples of the run.
fn fastest(run: &Samples<'_>, measure: impl Fn(&Mode) -> f64) -> Option<Mode> {
    let sound = run.sound();
    let every = sound.len().div_ceil(LOOKS).max(1);
    let all = sound.iter().rev().step_by(every).filter_map(|(time, state)| modes(run, *time, state)).flatten();
    all.max_by(|a, b| measure(a).total_cmp(&measure(b)))
}

/// All modes of the law, linearised at a state; `None` for large systems and where derivatives are not finite.
fn modes(run: &Samples<'_>, time: f64, state: &[f64]) -> Option<Vec<Mode>> {
    let n = state.len();
    if n > MOST_STATES {
        return None;
    }
    let law = law_at(run, (time, state));
    let mut matrix = vec![0.0; n * n];
    Jacobian::of(&*law).matrix(time, state, &mut matrix);
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let matrix = DMatrix::from_row_slice(n, n, &matrix);
    let values = Schur::try_new(matrix.clone(), f64::EPSILON, MOST_ITERATIONS)?.complex_eigenvalues();
    let positions = run.model().positions();
    let moves = |value: &Complex<f64>| {
        let shifted = matrix.map(|entry| Complex::new(entry, 0.0)) - DMatrix::identity(n, n) * *value;
        let decomposed = shifted.svd(false, true);
        let (least, _) = decomposed.singular_values.argmin();
        let rows = decomposed.v_t?;
        (0..run.model().speeds())
            .max_by(|a, b| rows[(least, positions + a)].norm().total_cmp(&rows[(least, positions + b)].norm()))
    };
    Some(values.iter().filter_map(|value| Some(Mode { value: *value, at: time, moves: moves(value)? })).collect())
}

/// The law of the motion from a state at a time in s.
fn law_at(run: &Samples<'_>, (time, state): (f64, &[f64])) -> Arc<dyn Law> {
    let model = &run.scene.model;
    let changes = !model.switches.is_empty() || !model.contacts.is_empty();
    let here = if changes { Modes::of(model, &[], &[]).law_from(time, state).ok() } else { None };
    here.as_ref().unwrap_or(&run.scene.system).law()
}

/// The longest step in s for which a method does not amplify the mode with the eigenvalue `value` in 1/s, by bisection between 0 and the unstable step
/// `grows` in s; `None` if every tested step amplifies the mode.
fn longest(method: Method, value: Complex<f64>, grows: f64) -> Option<f64> {
    let (mut fades, mut grows) = (0.0, grows);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (fades + grows);
        if amplified(method, value * middle) <= 1.0 { fades = middle } else { grows = middle }
    }
    (fades > 0.0).then_some(fades)
}

/// The factor |R(z)| by which a step multiplies a mode, where z is the step times the eigenvalue, with the stability function R of Euler's or the classical Runge-Kutta method.
fn amplified(method: Method, z: Complex<f64>) -> f64 {
    let one = Complex::new(1.0, 0.0);
    match method {
        Method::Euler { .. } => (one + z).norm(),
        _ => (one + z * (one + z / 2.0 * (one + z / 3.0 * (one + z / 4.0)))).norm(),
    }
}
