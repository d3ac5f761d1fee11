//! Diagnosis of missed events: the expression `when` changes its sign between two samples, but the run reports no event there.
//!
//! Positions are interpolated by cubics between the samples, which are states of the run. Where the interpolation shows an event, the motion is
//! integrated again from the sample before, and the event is reported if this motion has it, too. Pairs of zeros between tested times stay
//! undetected.

use super::samples::Samples;
use crate::letters::Letters;
use crate::program::recorded;
use integrators::{Method, Span, Tolerance, integrate};
use model::{Direction, Event, Trace};
use simulation::{FailureKind, Program, RunFailure};

/// Number of times tested between two samples.
const BETWEEN: usize = 16;

/// Number of times between two samples that measure how long `when` keeps its new sign; and number of steps within this duration that
/// find the event.
const FINER: usize = 1_024;
const STEPS: f64 = 4.0;

/// Values below this multiple of the largest one along the run are rounding or integration errors.
const ROUNDING: f64 = 1e-6;

/// Tolerance of the repeated integration.
const TOLERANCE: f64 = 1e-10;

/// Largest number of evaluations of the repeated integration.
const BUDGET: u64 = 20_000;

/// The failure at the first missed event; only for systems whose law changes at events alone.
pub(super) fn found(run: &Samples<'_>) -> Option<RunFailure> {
    let model = run.model();
    let changes = !model.switches.is_empty() || !model.contacts.is_empty() || !model.algebraic_speeds.is_empty();
    if model.events.is_empty() || changes || run.states.len() < 2 {
        return None;
    }
    let program = recorded(model.positions() + model.speeds(), |time, state| {
        let trace = Trace::of(model);
        let when: Vec<_> = model.events.iter().map(|event| trace.scalar(event.when)).collect();
        Letters::with_data(time, state).put_into(&trace, &when)
    });
    let program = program.ok()?;
    let values = |time: f64, state: &[f64]| values(&program, model.events.len(), time, state);
    let mut sizes = vec![0.0_f64; model.events.len()];
    for (time, state) in &run.states {
        sizes.iter_mut().zip(values(*time, state)).for_each(|(size, value)| *size = size.max(value.abs()));
    }
    for k in 0..run.states.len() - 1 {
        let (from, to) = (run.states[k].0, run.states[k + 1].0);
        let seen = |time: f64| (from..=to).contains(&time);
        if run.trajectory.passages.iter().skip(1).any(|passage| seen(passage.time)) {
            continue;
        }
        let first = values(from, &run.states[k].1);
        for step in 1..=BETWEEN {
            let (time, state) = run.between(k, step as f64 / BETWEEN as f64);
            let crossed = |event: usize, value: f64| {
                let noise = ROUNDING * sizes[event].max(value.abs());
                let [before, after] = [first[event], value].map(|value| if value.abs() <= noise { 0.0 } else { value });
                match model.events[event].direction {
                    Direction::Up => before < 0.0 && after > 0.0,
                    Direction::Down => before > 0.0 && after < 0.0,
                    Direction::Both => before * after < 0.0,
                }
            };
            let now = values(time, &state);
            for (event, &value) in now.iter().enumerate().filter(|(event, value)| crossed(*event, **value)) {
                let own = if step == BETWEEN {
                    Some(value)
                } else {
                    again(run, k, time).map(|state| values(time, &state)[event])
                };
                if own.is_some_and(|own| crossed(event, own)) {
                    // duration for which `when` keeps its new sign before the next sample
                    let parts = (0..=FINER).map(|part| run.between(k, part as f64 / FINER as f64));
                    let behind = parts.filter(|(time, state)| values(*time, state)[event] * value > 0.0).count();
                    let lasts = behind.max(1) as f64 / FINER as f64 * (to - from);
                    return Some(told(run, event, [from, time], lasts));
                }
            }
        }
    }
    None
}

fn values(program: &Program, count: usize, time: f64, state: &[f64]) -> Vec<f64> {
    let mut values = vec![f64::NAN; count];
    // the program was compiled for a state of this length
    program.run(time, state, &mut values).unwrap_or(());
    values
}

/// The state at a time in seconds, integrated again from sample k; `None` if the integration fails.
fn again(run: &Samples<'_>, k: usize, time: f64) -> Option<Vec<f64>> {
    let (from, state) = &run.states[k];
    let span = Span::new(*from, time, state).with_evaluations(BUDGET);
    let law = run.scene.system.law();
    let outcome = integrate(&*law, Method::DormandPrince8, &Tolerance::both(TOLERANCE), &span, &mut ());
    outcome.reached().then_some(outcome.state)
}

fn told(run: &Samples<'_>, event: usize, [from, to]: [f64; 2], lasts: f64) -> RunFailure {
    let Event { direction, .. } = &run.model().events[event];
    let way = match direction {
        Direction::Up => "up ",
        Direction::Down => "down ",
        Direction::Both => "",
    };
    let steps = (run.scene.run.span / lasts * STEPS).ceil();
    RunFailure {
        kind: FailureKind::MissedEvent,
        at: to,
        evidence: format!(
            "{} passes zero {way}between t = {from:.6} s and t = {to:.6} s, and no event was found there by steps of {:.1e} s",
            run.scene.event_names()[event],
            run.step()
        ),
        remedy: format!(
            "steps shorter than the {lasts:.1e} s that `when` is behind zero there: --method runge_kutta_4:{steps}; `samples` alone changes no step"
        ),
    }
}
