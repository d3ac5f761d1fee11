//! Forces of short duration that a run has passed over: with the state of a sample held, the rates change within the time to the next sample,
//! and no step saw it.
//!
//! Rates are looked at [`LOOKS`] times between two samples; a pulse that is shorter stays unseen. What is seen is computed again from the
//! sample before, with steps that are short where the pulse is, and told where the next sample of the run differs.

use super::samples::Samples;
use crate::changing_laws::is_watched;
use integrators::{Method, Ode, Span, Tolerance, integrate};
use model::{PowerBalance, Trace};
use simulation::{FailureKind, RunFailure};
use symbolic::apart;

/// Times between two samples at which rates are looked at.
const LOOKS: usize = 1_000;

/// Samples after which others are left out.
const MOST_SAMPLES: usize = 400;

/// Evaluations in all.
const MOST_RATES: usize = 400_000;

/// The part of its largest distance from a line at which a pulse begins and ends.
const BEGINS: f64 = 1e-3;

/// A pulse takes less than this part of the time between two samples.
const SHORT: f64 = 0.2;

/// The accuracy of the motion that is computed again, and how much coarser a difference is told.
const TOLERANCE: f64 = 1e-9;
const TOLD: f64 = 1e4;

/// Evaluations for it.
const BUDGET: u64 = 100_000;

/// A stretch of time in which rates are others than before and after it.
struct Pulse {
    from: f64,
    to: f64,
    /// The time at which they differ most, and the component that does.
    at: f64,
    component: usize,
}

/// The first pulse that was passed over, of a system with one law that knows the time.
pub(super) fn missed(run: &Samples<'_>) -> Option<RunFailure> {
    let model = run.model();
    // rates for which accelerations are solved cost too much to be looked at so often
    if is_watched(model) || !run.scene.system.is_written() || run.states.len() < 2 || !knows_time(run) {
        return None;
    }
    let count = (run.states.len() - 1).min(MOST_SAMPLES);
    let looks = LOOKS.min(MOST_RATES / count);
    (0..count).find_map(|k| {
        let pulse = pulse(run, k, looks)?;
        let own = again(run, k, &pulse)?;
        let (_, next) = &run.states[k + 1];
        let (_, before) = &run.states[k];
        let allowed = TOLD * TOLERANCE.max(run.choice.tolerance);
        let is_off = |place: &usize| {
            let size = own[*place].abs().max(before[*place].abs()).max((own[*place] - before[*place]).abs());
            (own[*place] - next[*place]).abs() > allowed * size
        };
        let place = (0..own.len()).find(is_off)?;
        let lasts = pulse.to - pulse.from;
        let names = model.state_names();
        Some(RunFailure {
            kind: FailureKind::MissedEvent,
            at: pulse.at,
            evidence: format!(
                "the rate of `{}` changes by itself for {lasts:.1e} s about t = {:.6} s, and steps of {:.1e} s passed over it: {} behind it, and {} \
                 with shorter steps",
                names[pulse.component].0,
                pulse.at,
                run.step(),
                run.told(place, next[place]),
                run.told(place, own[place])
            ),
            remedy: format!(
                "conditions of the time that begin and end the pulse, as `if(t < t1, a, if(t < t2, b, a))`: a run steps to them; or steps shorter \
                 than the pulse: --method runge_kutta_4:{}",
                (run.scene.run.span / lasts * 20.0).ceil()
            ),
        })
    })
}

/// Whether the time stands in energies or loads.
fn knows_time(run: &Samples<'_>) -> bool {
    apart(|| {
        let trace = Trace::of(run.model());
        let PowerBalance { energy, power } = PowerBalance::of(&trace);
        [energy, power].iter().any(|all| all.symbols_of().contains(&trace.time))
    })
}

/// The rates at a time with the state of a sample.
fn rates(run: &Samples<'_>, time: f64, state: &[f64]) -> Vec<f64> {
    let mut rates = vec![0.0; state.len()];
    Ode::<f64>::rates(&*run.scene.system, time, state, &mut rates);
    rates
}

/// A pulse between sample `k` and the next, where rates leave the line between their ends and come back to it.
fn pulse(run: &Samples<'_>, k: usize, looks: usize) -> Option<Pulse> {
    let (from, state) = &run.states[k];
    let to = run.states[k + 1].0;
    let time = |look: usize| from + (to - from) * (look as f64 / looks as f64);
    let all: Vec<Vec<f64>> = (0..=looks).map(|look| rates(run, time(look), state)).collect();
    let (first, last) = (&all[0], &all[looks]);
    let off = |look: usize, place: usize| {
        let part = look as f64 / looks as f64;
        (all[look][place] - first[place] - part * (last[place] - first[place])).abs()
    };
    (run.model().positions()..state.len()).find_map(|place| {
        let (at, most) =
            (0..=looks).map(|look| (look, off(look, place))).fold((0, 0.0), |a, b| if b.1 > a.1 { b } else { a });
        let level = first[place].abs().max(last[place].abs());
        if most.is_nan() || most <= 1e-9 * level || most == 0.0 {
            return None;
        }
        let begin = (0..at).rev().find(|&look| off(look, place) < BEGINS * most)?;
        let end = (at..=looks).find(|&look| off(look, place) < BEGINS * most)?;
        let is_short = (end - begin) as f64 <= SHORT * looks as f64;
        is_short.then(|| Pulse { from: time(begin), to: time(end), at: time(at), component: place })
    })
}

/// The state of the sample after `k`, with steps that are short where a pulse begins.
fn again(run: &Samples<'_>, k: usize, pulse: &Pulse) -> Option<Vec<f64>> {
    let (from, state) = &run.states[k];
    let to = run.states[k + 1].0;
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
