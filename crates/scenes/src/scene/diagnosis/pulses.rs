//! Missed pulses: between two samples the rates change within a short time, and no step of the run has evaluated them there.
//!
//! Between samples positions are interpolated by cubics, speeds linearly, and rates are evaluated there. Where their integral is not the
//! change of a speed, the motion is computed again from the sample before, with short steps where the rates change. The pulse is reported
//! if the next sample of the run differs. A pulse shorter than the distance of two evaluations stays unseen.

use super::samples::Samples;
use crate::changing_laws::is_watched;
use integrators::{Method, Ode, Span, Tolerance, integrate};
use model::{PowerBalance, Trace};
use simulation::{FailureKind, RunFailure};
use symbolic::{Operation, Sym, Tape, apart};

/// Times between two samples at which rates are looked at.
const LOOKS: usize = 1_000;

/// Samples after which others are left out.
const MOST_SAMPLES: usize = 400;

/// Evaluations in all: of a law that knows the time under constant steps, and of others, whose steps are bounded where the time changes them.
const MOST_RATES_OF_TIME: usize = 400_000;
const MOST_RATES: usize = 30_000;

/// The part of its largest distance from a line at which a pulse begins and ends.
const BEGINS: f64 = 1e-3;

/// A pulse takes at most so many of the steps made.
const SHORT: f64 = 2.0;

/// Intervals that are computed again: those with the largest differences.
const MOST_AGAIN: usize = 4;

/// The accuracy of the motion that is computed again, and how much coarser a difference is told.
const TOLERANCE: f64 = 1e-9;
const TOLD: f64 = 1e4;

/// Differences of so many tolerances are told at least: the tolerance is absolute too.
const ABSOLUTE: f64 = 100.0;

/// Evaluations for it.
const BUDGET: u64 = 100_000;

/// A stretch of time in which rates are others than before and after it.
struct Pulse {
    sample: usize,
    from: f64,
    to: f64,
    /// The time at which they differ most, and the component that does.
    at: f64,
    component: usize,
    /// The difference of the integral of this rate from the change of the component, in parts of what is told.
    weight: f64,
}

/// The first pulse that was passed over, of a system with one law.
pub(super) fn missed(run: &Samples<'_>) -> Option<RunFailure> {
    let model = run.model();
    // rates for which accelerations are solved cost too much to be looked at so often
    let is_followed = !is_watched(model) && run.scene.system.is_written();
    // where a law ends rates may have no bound
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

/// The difference of a component of a size from which on it is told.
fn allowed(run: &Samples<'_>, size: f64) -> f64 {
    let tolerance = run.choice.tolerance;
    (TOLD * TOLERANCE.max(tolerance) * size).max(ABSOLUTE * tolerance)
}

/// The parts of energies and loads.
struct Loads {
    /// Whether the time stands in them.
    by_time: bool,
    /// Whether they hold functions that may be large in a narrow place alone: an exponential, a quotient, an angle. Polynomials and circular
    /// functions are as narrow as their whole course.
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

/// The pulse with the largest part in the change of a speed between sample `k` and the next that the run does not have.
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

/// The state of the sample after a pulse, with steps that are short where a pulse begins.
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
