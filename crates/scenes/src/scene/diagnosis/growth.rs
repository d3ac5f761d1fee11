//! Diagnosis of unbounded motions: growth to infinity in finite time (blow-up), or exponential growth.
//!
//! The growth time |y|/|y'| of a component y distinguishes them. It falls to zero as t* - t before a blow-up at t*, is constant for exponential
//! growth, and is t/p for growth as t^p.

use super::samples::Samples;
use integrators::{Failure, Ode};
use simulation::{FailureKind, RunFailure};

/// Least ratio of the last value to the largest one in the first nine tenths of the run; a component with less growth is not examined.
const GROWN: f64 = 100.0;

/// For a blow-up, the growth time must be below this fraction of the elapsed time.
const FAST: f64 = 1e-3;

/// For a blow-up, the growth time must be below this fraction of its value in the middle of the run.
const SHRUNK: f64 = 0.02;

/// A component has overflown if it is this many times as large as one SI unit and as its values in the first tenth of the run.
const HUGE: f64 = 1e12;

/// Growth is slower than exponential if its logarithm over the last quarter of a run, divided by that over the quarter before, is less.
const SLOWER: f64 = 0.85;

/// Growth is faster than exponential if this ratio of logarithms is larger.
const FASTER: f64 = 1.3;

/// The failure of a run in which the component with the most growth is unbounded.
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
    // constant steps continue behind t*; growth times shorter than a step have no meaning there
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
        // powers of the state, as terms of a series or squares of error estimates, overflow before the state itself
        Some(Failure::StepCollapsed { .. } | Failure::NewtonFailed { .. } | Failure::Singular { .. }) => {
            let first = run.states.iter().take_while(|(time, _)| *time <= 0.1 * at);
            last[place].abs() > HUGE * first.fold(1.0, |size: f64, (_, state)| size.max(state[place].abs()))
        }
        _ => false,
    };
    if !has_overflown {
        return None;
    }
    // maxima over intervals measure the growth of oscillations, too
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
