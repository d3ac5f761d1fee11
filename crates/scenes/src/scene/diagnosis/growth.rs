//! Motions that grow without bound, in finite time (blow-up) or exponentially.
//!
//! The time |y|/|y'| in which a component grows by its own size goes to zero like t* - t where it blows up at t*, is constant for exponential
//! growth, and is t/p for growth as t^p.

use super::samples::Samples;
use integrators::{Failure, Ode};
use simulation::{FailureKind, RunFailure};

/// The growth of a component over its largest value in the first nine tenths of the run, from which on it is looked at.
const GROWN: f64 = 100.0;

/// The part of the time of the run below which the time of growth is small.
const FAST: f64 = 1e-3;

/// The part of its value in the middle of the run to which the time of growth has come down, where it goes to zero.
const SHRUNK: f64 = 0.02;

/// A component that has grown so many times beyond one in SI units, and beyond its size in the first tenth of the run, has no bound, whatever
/// ends the run.
const HUGE: f64 = 1e12;

/// The logarithm of the growth in the last quarter of a run, over that in the quarter before, below which it is slower than an exponential's.
const SLOWER: f64 = 0.85;

/// The ratio of these logarithms above which the growth is faster than exponential.
const FASTER: f64 = 1.3;

/// The component that has grown most.
pub(super) fn found(run: &Samples<'_>) -> Option<RunFailure> {
    let (at, last) = run.last();
    let before: Vec<&(f64, Vec<f64>)> = run.states.iter().filter(|(time, _)| *time <= 0.9 * at).collect();
    let growth = |place: usize| {
        let earlier = before.iter().fold(0.0, |size: f64, (_, state)| size.max(state[place].abs()));
        last[place].abs() / earlier.max(f64::MIN_POSITIVE.sqrt())
    };
    let place = (0..last.len()).max_by(|a, b| growth(*a).total_cmp(&growth(*b)))?;
    let grown = growth(place);
    if grown < GROWN {
        return None;
    }
    let scale = |(time, state): &(f64, Vec<f64>)| {
        let mut rates = vec![0.0; state.len()];
        Ode::<f64>::rates(&*run.scene.system, *time, state, &mut rates);
        (state[place] / rates[place]).abs()
    };
    // a constant step goes on behind t*: there its own length is all that it shows
    let step = if run.choice.method.steps().is_some() { run.step() } else { 0.0 };
    let followed = |state: &&(f64, Vec<f64>)| scale(state).is_finite() && scale(state) > step;
    let near = run.states.iter().rev().find(followed)?;
    let middle = run.states.iter().find(|(time, _)| *time >= 0.5 * near.0)?;
    let (now, then) = (scale(near), scale(middle));
    let told = run.told(place, last[place]);
    if now < then * SHRUNK.max(2.0 * step / then) && now < (FAST * near.0).max(20.0 * step) {
        return Some(RunFailure {
            kind: FailureKind::BlowUp,
            at: near.0,
            evidence: format!(
                "{} grows by its own size in {now:.1e} s there, and in {then:.1e} s in the middle of the run; the last good state has {told}",
                run.told(place, near.1[place])
            ),
            remedy: "an [[event]] with `end = true` before it, or a shorter `span`: no motion follows; a force that grows faster \
                     than its speed, where it is not meant, is bounded by `min` and `max`"
                .to_owned(),
        });
    }
    let has_overflown = match run.trajectory.outcome.failure() {
        Some(Failure::LeftTheNumbers { .. }) => true,
        // powers of a state, as the terms of a series or the squares of an error, overflow before it does
        Some(Failure::StepCollapsed { .. } | Failure::NewtonFailed { .. } | Failure::Singular { .. }) => {
            let first = run.states.iter().take_while(|(time, _)| *time <= 0.1 * at);
            last[place].abs() > HUGE * first.fold(1.0, |size: f64, (_, state)| size.max(state[place].abs()))
        }
        _ => false,
    };
    if !has_overflown {
        return None;
    }
    // an oscillation grows by its largest values
    let largest = |from: f64, to: f64| {
        let own = run.states.iter().filter(|(time, _)| from * at < *time && *time <= to * at);
        own.map(|(_, state)| state[place].abs()).fold(0.0, f64::max)
    };
    let logarithms = [(0.25, 0.5), (0.5, 0.75), (0.75, 1.0)].map(|(from, to)| largest(from, to).ln());
    let [earlier, later] = [logarithms[1] - logarithms[0], logarithms[2] - logarithms[1]];
    let rate = match later / earlier {
        ratio if !ratio.is_finite() || ratio <= 0.0 => "grows without bound".to_owned(),
        ratio if ratio < SLOWER => format!(
            "grows {:.1e} times in the last quarter of the run, and {:.1e} times in the one before: more slowly than an exponential",
            later.exp(),
            earlier.exp()
        ),
        ratio if ratio > FASTER => format!(
            "grows {:.1e} times in the last quarter of the run, and {:.1e} times in the one before: faster than an exponential",
            later.exp(),
            earlier.exp()
        ),
        _ => format!("grows e times in {:.1e} s, as it did before: an unstable motion", 0.25 * at / later),
    };
    Some(RunFailure {
        kind: FailureKind::UnboundedGrowth,
        at,
        evidence: format!("{told} {rate}"),
        remedy: "signs of the forces: a damping or a stiffness that is negative feeds this growth; `dalembert linearise` has its \
                 eigenvalues; or a shorter `span`"
            .to_owned(),
    })
}
