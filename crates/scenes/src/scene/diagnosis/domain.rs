//! Diagnosis of runs that stop at the boundary of the law's domain: rates are finite at the last state and NaN a little later.

use super::samples::Samples;
use crate::letters::Letters;
use crate::program::recorded;
use integrators::{Failure, Ode};
use model::{Domain, DomainEnd, Model, Trace};
use simulation::{FailureKind, RunFailure};

/// Fractions of the elapsed time by which the motion is extrapolated, in increasing order.
const AHEAD: [f64; 7] = [1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 1e-1];

/// The failure of a run that stopped where the argument of a function, such as `sqrt`, leaves its domain; with the text and line of the
/// function.
///
/// The margin m is an expression that is not negative in the domain. By linear extrapolation m reaches zero after the time -m/m'; later the
/// rates must be NaN.
pub(super) fn crossed(run: &Samples<'_>) -> Option<RunFailure> {
    if !has_lost_numbers(run) || run.trajectory.left.is_some() {
        return None;
    }
    let (at, state) = run.last();
    let here = rates(run, at, state);
    let bounded = run.model().domains.iter().zip(run.scene.domain_texts());
    bounded.filter(|(domain, _)| domain.end == DomainEnd::Negative).find_map(|(domain, (text, line))| {
        let margin = margin(run.model(), domain)?;
        let value = margin(at, state);
        let left = if value > 0.0 {
            let h = SHORT * at.max(f64::MIN_POSITIVE);
            let rate = (margin(at + h, &moved(state, &here, h)) - value) / h;
            let left = -value / rate;
            let beyond = rates(run, at + 2.0 * left, &moved(state, &here, 2.0 * left));
            // an adaptive method stops close to the boundary, a method with constant steps within a few steps of it
            let is_near = left > 0.0
                && match run.choice.method.steps() {
                    Some(_) => left <= NEAR * run.step(),
                    None => value <= CLOSE * largest(run, &margin),
                };
            (is_near && beyond.iter().any(|rate| rate.is_nan())).then_some(left)?
        } else {
            here.iter().any(|rate| !rate.is_finite()).then_some(0.0)?
        };
        let time = at + left;
        let held: Vec<String> =
            (0..run.model().positions()).map(|place| run.told(place, state[place])).take(MOST_TOLD).collect();
        let (needed, argument) = needed(text);
        Some(RunFailure {
            kind: FailureKind::EndOfDomain,
            at: time,
            evidence: format!(
                "{} has a value only where {needed}; the motion leaves this domain at t = {time:.6} s, with {}",
                if text.is_empty() { "a function of the law".to_owned() } else { format!("`{text}` in line {line}") },
                held.join(", ")
            ),
            remedy: match argument {
                Some(argument) => format!(
                    "an [[event]] with `when = \"{argument} - EPS\"`, EPS a small quantity of its dimension, and `end = true`; or, where the motion \
                     passes on, a law that has values there, such as `if({argument} > 0, {text}, 0)`"
                ),
                None => "a law that has values there, with a condition as `if`; or an [[event]] with `end = true` before it".to_owned(),
            },
        })
    })
}

/// Whether the run stopped since rates or steps could not be computed.
pub(super) fn has_lost_numbers(run: &Samples<'_>) -> bool {
    matches!(
        run.trajectory.outcome.failure(),
        Some(Failure::LeftTheNumbers { .. } | Failure::StepCollapsed { .. } | Failure::NewtonFailed { .. })
    )
}

/// The condition under which a function has a value, and its argument if zero is the boundary of the domain.
fn needed(text: &str) -> (&'static str, Option<&str>) {
    let argument = text.split_once('(').and_then(|(_, rest)| rest.strip_suffix(')'));
    match text.split('(').next().unwrap_or_default().trim() {
        "sqrt" => ("its argument is not negative", argument),
        "ln" | "log" => ("its argument is positive", argument),
        "asin" | "acos" => ("its argument lies between -1 and 1", None),
        _ => ("its base is not negative", None),
    }
}

/// The margin of a domain as a function of time and state; `None` if it depends on accelerations or reactions.
pub(super) fn margin(model: &Model, domain: &Domain) -> Option<impl Fn(f64, &[f64]) -> f64> {
    let program = recorded(model.positions() + model.speeds(), |time, state| {
        let trace = Trace::of(model);
        Letters::with_data(time, state).put_into(&trace, &[trace.scalar(domain.margin)])
    });
    let program = program.ok()?;
    Some(move |time: f64, state: &[f64]| {
        let mut value = [f64::NAN];
        // the program was compiled for a state of this length
        program.run(time, state, &mut value).unwrap_or(());
        value[0]
    })
}

/// The rates of all states at a time (s) and a state, in SI units per second.
pub(super) fn rates(run: &Samples<'_>, time: f64, state: &[f64]) -> Vec<f64> {
    let mut rates = vec![0.0; state.len()];
    Ode::<f64>::rates(&*run.scene.system, time, state, &mut rates);
    rates
}

/// The state after one step of Euler's method: state + h rates, with h in s.
fn moved(state: &[f64], rates: &[f64], h: f64) -> Vec<f64> {
    state.iter().zip(rates).map(|(value, rate)| value + h * rate).collect()
}

/// Time of an extrapolation, relative to the elapsed time, over which the motion is linear.
const SHORT: f64 = 1e-9;

/// Largest number of constant steps between the last state and the boundary that stopped the run.
const NEAR: f64 = 4.0;

/// An adaptive method stopped at the boundary if the margin is below this fraction of its largest value.
const CLOSE: f64 = 1e-3;

/// The largest value of a margin along the run, or 0 if the margin is nowhere positive. `margin` maps time (s) and state to the margin of the law's
/// domain, in the margin's unit.
fn largest(run: &Samples<'_>, margin: &impl Fn(f64, &[f64]) -> f64) -> f64 {
    run.sound().iter().map(|(time, state)| margin(*time, state)).fold(0.0, f64::max)
}

/// The failure of a run with moderate states whose extrapolated motion has a rate that is NaN.
pub(super) fn left(run: &Samples<'_>) -> Option<RunFailure> {
    if !has_lost_numbers(run) || run.sound().len() < run.states.len() {
        return None;
    }
    let (at, state) = run.last();
    let here = rates(run, at, state);
    if here.iter().any(|rate| !rate.is_finite()) {
        return None;
    }
    let lost = AHEAD.into_iter().find_map(|part| {
        let h = part * at.max(f64::MIN_POSITIVE);
        let place = rates(run, at + h, &moved(state, &here, h)).iter().position(|rate| rate.is_nan())?;
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

/// Largest number of coordinates in a message.
const MOST_TOLD: usize = 6;
