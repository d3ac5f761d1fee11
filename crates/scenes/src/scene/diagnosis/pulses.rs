//! Diagnosis of missed pulses: between two samples a force acts for a short time, and no step of the run evaluated the law within this time.
//!
//! Rates are evaluated between samples, with positions from cubic and speeds from linear interpolation. Where the integral of a rate differs
//! from the change of its speed, the motion is integrated again from the sample before, with short steps during the pulse. The pulse is reported
//! if the result differs from the next sample of the run. Pulses shorter than the distance of two evaluations stay undetected.

use super::samples::Samples;
use crate::changing_laws::is_watched;
use integrators::{Method, Ode, Span, Tolerance, integrate};
use model::{PowerBalance, Trace};
use simulation::{FailureKind, RunFailure};
use symbolic::{Operation, Sym, Tape, apart};

/// Largest number of evaluations between two samples.
const LOOKS: usize = 1_000;

/// Largest number of intervals between samples that are examined, from the start of the run.
const MOST_SAMPLES: usize = 400;

/// Largest number of evaluations in all: for laws that depend on time and constant steps, and for the others. The steps of adaptive methods
/// are limited where the law depends on time.
const MOST_RATES_OF_TIME: usize = 400_000;
const MOST_RATES: usize = 30_000;

/// A pulse begins and ends where the deviation of the rate from linear interpolation is this fraction of its maximum.
const BEGINS: f64 = 1e-3;

/// Largest duration of a pulse in steps of the run.
const SHORT: f64 = 2.0;

/// Number of intervals that are integrated again: those with the largest differences.
const MOST_AGAIN: usize = 4;

/// Tolerance of the repeated integration. A relative difference is reported from `TOLD` tolerances on.
const TOLERANCE: f64 = 1e-9;
const TOLD: f64 = 1e4;

/// A difference is reported from this many absolute tolerances of the run on.
const ABSOLUTE: f64 = 100.0;

/// Largest number of evaluations of each part of the repeated integration.
const BUDGET: u64 = 100_000;

/// A time interval between two samples, of indices `sample` and `sample` + 1, with a rate unlike that before and after.
struct Pulse {
    sample: usize,
    from: f64,
    to: f64,
    /// The time of the largest deviation in seconds, and the index of the speed in the state.
    at: f64,
    component: usize,
    /// The integral of the rate minus the change of the speed, as a multiple of the least difference that is reported.
    weight: f64,
}

/// The failure at the first missed pulse; only for systems whose law does not change at conditions, contacts or events.
pub(super) fn missed(run: &Samples<'_>) -> Option<RunFailure> {
    let model = run.model();
    // laws that solve numerically for accelerations are too expensive for so many evaluations
    let is_followed = !is_watched(model) && run.scene.system.is_written();
    // rates may be unbounded where a run has stopped
    if !is_followed || run.states.len() < 2 || run.trajectory.stopped().is_some() {
        return None;
    }
    let Loads { by_time, may_be_narrow } = Loads::of(run);
    if !by_time && !may_be_narrow {
        return None;
    }
    let most = if by_time && !run.choice.method.traits().adaptive { MOST_RATES_OF_TIME } else { MOST_RATES };
    let count = (run.states.len() - 1).min(MOST_SAMPLES);
    let looks = LOOKS.min(most / count);
    let mut found: Vec<Pulse> = (0..count).filter_map(|k| pulse(run, k, looks)).collect();
    found.sort_by(|a, b| b.weight.total_cmp(&a.weight));
    found.truncate(MOST_AGAIN);
    found.sort_by(|a, b| a.at.total_cmp(&b.at));
    found.iter().find_map(|pulse| {
        let own = again(run, pulse)?;
        let (_, next) = &run.states[pulse.sample + 1];
        let (_, before) = &run.states[pulse.sample];
        let is_off = |place: &usize| {
            let size = own[*place].abs().max(before[*place].abs()).max((own[*place] - before[*place]).abs());
            (own[*place] - next[*place]).abs() > allowed(run, size)
        };
        let place = (0..own.len()).find(is_off)?;
        let lasts = pulse.to - pulse.from;
        let names = model.state_names();
        let steps = (run.scene.run.span / lasts * 20.0).ceil();
        let (cause, remedy) = match by_time {
            true => (
                "changes by itself",
                "conditions of the time that begin and end the pulse, as `if(t < t1, a, if(t < t2, b, a))`: a run steps to them",
            ),
            false => (
                "changes along the motion",
                "a condition where the force begins, as `if(x < x1, a, b)`, or an [[event]] there: a run steps to it",
            ),
        };
        Some(RunFailure {
            kind: FailureKind::MissedEvent,
            at: pulse.at,
            evidence: format!(
                "the rate of `{}` {cause} for {lasts:.1e} s about t = {:.6} s, and steps of {:.1e} s passed over it: {} behind it, and {} \
                 with shorter steps",
                names[pulse.component].0,
                pulse.at,
                run.step(),
                run.told(place, next[place]),
                run.told(place, own[place])
            ),
            remedy: format!("{remedy}; or steps shorter than the pulse: --method runge_kutta_4:{steps}"),
        })
    })
}

/// The least difference that is reported for a component of the given size.
fn allowed(run: &Samples<'_>, size: f64) -> f64 {
    let tolerance = run.choice.tolerance;
    (TOLD * TOLERANCE.max(tolerance) * size).max(ABSOLUTE * tolerance)
}

/// Properties of the expressions of energies and loads that make pulses possible.
struct Loads {
    /// Whether they contain the time explicitly.
    by_time: bool,
    /// Whether they contain exponentials, quotients or angles, which may be large in a narrow region only. Polynomials and circular functions
    /// cannot be.
    may_be_narrow: bool,
}

impl Loads {
    fn of(run: &Samples<'_>) -> Self {
        apart(|| {
            let trace = Trace::of(run.model());
            let PowerBalance { energy, power } = PowerBalance::of(&trace);
            let all = [energy, power];
            let symbols: Vec<Sym> = all.iter().flat_map(|one| one.symbols_of()).collect();
            let is_narrow = |step: &Operation| matches!(step, Operation::Elementary(..) | Operation::Quotient(..));
            let tape = Tape::record(&symbols, &all);
            Loads {
                by_time: symbols.contains(&trace.time),
                may_be_narrow: tape.map_or(true, |tape| tape.steps().iter().any(is_narrow)),
            }
        })
    }
}

/// The pulse of the speed with the largest weight between samples `k` and `k` + 1; `None` if no integral differs from the change.
fn pulse(run: &Samples<'_>, k: usize, looks: usize) -> Option<Pulse> {
    let [(from, before), (to, after)] = [&run.states[k], &run.states[k + 1]];
    let (from, to) = (*from, *to);
    let time = |look: usize| from + (to - from) * (look as f64 / looks as f64);
    let all: Vec<Vec<f64>> = (0..=looks)
        .map(|look| {
            let (time, state) = run.between(k, look as f64 / looks as f64);
            let mut rates = vec![0.0; state.len()];
            Ode::<f64>::rates(&*run.scene.system, time, &state, &mut rates);
            rates
        })
        .collect();
    let (first, last) = (&all[0], &all[looks]);
    let off = |look: usize, place: usize| {
        let part = look as f64 / looks as f64;
        (all[look][place] - first[place] - part * (last[place] - first[place])).abs()
    };
    let weighed = |place: usize| {
        let inner: f64 = all[1..looks].iter().map(|rates| rates[place]).sum();
        let integral = (to - from) / looks as f64 * (inner + 0.5 * (first[place] + last[place]));
        let change = after[place] - before[place];
        let size = before[place].abs().max(after[place].abs()).max(integral.abs());
        let weight = (integral - change).abs() / allowed(run, size);
        let (at, most) =
            (0..=looks).map(|look| (look, off(look, place))).fold((0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        if !(weight > 1.0 && weight.is_finite() && most > 0.0) {
            return None;
        }
        let begin = (0..at).rev().find(|&look| off(look, place) < BEGINS * most).unwrap_or(0);
        let end = (at..=looks).find(|&look| off(look, place) < BEGINS * most).unwrap_or(looks);
        let is_short = time(end) - time(begin) <= SHORT * run.step();
        is_short.then(|| Pulse { sample: k, from: time(begin), to: time(end), at: time(at), component: place, weight })
    };
    let found = (run.model().positions()..before.len()).filter_map(weighed);
    found.max_by(|a, b| a.weight.total_cmp(&b.weight))
}

/// The state at the sample after a pulse, integrated again with a short first step at the beginning of the pulse.
fn again(run: &Samples<'_>, pulse: &Pulse) -> Option<Vec<f64>> {
    let (from, state) = &run.states[pulse.sample];
    let to = run.states[pulse.sample + 1].0;
    let law = run.scene.system.law();
    let law = run.scene.system.projected(law);
    let mut here = state.clone();
    for (begin, end, first) in [
        (*from, pulse.from, f64::INFINITY),
        (pulse.from, pulse.to, 0.02 * (pulse.to - pulse.from)),
        (pulse.to, to, f64::INFINITY),
    ] {
        if begin < end {
            let mut span = Span::new(begin, end, &here).with_evaluations(BUDGET);
            span.longest_first = Some(first).filter(|first| first.is_finite());
            let outcome = integrate(&*law, Method::DormandPrince8, &Tolerance::both(TOLERANCE), &span, &mut ());
            here = outcome.reached().then_some(outcome.state)?;
        }
    }
    Some(here)
}
