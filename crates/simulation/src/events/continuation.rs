//! The continuation of a motion beyond a singular position, on its smooth branch.
//!
//! At a singular position the constraints are linearly dependent: there the equations do not determine the accelerations, and several
//! motions may follow. At most one of them has coordinates that are analytic functions of the time throughout, and its Taylor series at a
//! regular state before the position gives the states behind. The series is summed from two states before to one behind. Rounding errors grow
//! where the states are close to the position, the remainder of the series where they are far from it, so pairs of several distances are
//! tried, and the one whose sums agree best is taken. The derivative of the series
//! must be the rate of the law at the state behind: a series that converges to no motion of the law is no continuation.

use super::law_end::SwitchesAndEnds;
use integrators::{Observer, Ode, System, TaylorSeries, Tolerance};

/// The number of states of a trail at which it is thinned out, and the factor by which their distances to the last one then grow at least.
const MOST: usize = 128;
const THINNED: f64 = 1.25;

/// The order of the series.
const ORDER: usize = 24;

/// The distance of the state behind, by that of the nearer state before. A rounding error e of the constraints makes the motion pass the
/// position beside the branch, by the order of e/t at the distance t: from a base at the distance b the terms of e/t grow with the power
/// k as ((t + b)/b)^k, so that t is to be small beside b.
const PARTS: [f64; 5] = [1.0, 0.5, 0.25, 0.125, 0.0625];

/// Distances of two states from a position differ by this factor at least.
const APART: f64 = 1.2;

/// States within one step, each at half the distance of the one before.
const HALVINGS: i32 = 6;

/// Both sums differ by no more than so many tolerances, or by this part of the largest component.
const AGREED: f64 = 10.0;
const ROUNDING: f64 = 1e-9;

/// Bisections by which the position is found between the states, and looks at the signals behind it.
const BISECTIONS: usize = 40;
const LOOKS: u32 = 16;

/// The derivative of the series differs from the rates of the law by no more than this part of the largest rate.
const OF_RATES: f64 = 1e-5;

/// States of a motion up to the last one, the denser the later they are: steps become short before a singular position.
#[derive(Debug, Default)]
pub(super) struct Trail {
    states: Vec<(f64, Vec<f64>)>,
    /// Room of states that were dropped.
    spare: Vec<Vec<f64>>,
}

impl Trail {
    pub fn restart(&mut self, time: f64, state: &[f64]) {
        self.spare.extend(self.states.drain(..).map(|(_, room)| room));
        self.step(time, state);
    }

    pub fn step(&mut self, time: f64, state: &[f64]) {
        if self.states.len() == MOST {
            let mut kept = f64::INFINITY;
            let dropped = self.states.extract_if(.., |(known, _)| {
                let distance = (time - *known).abs();
                let goes = distance * THINNED > kept;
                kept = if goes { kept } else { distance };
                goes
            });
            self.spare.extend(dropped.map(|(_, room)| room));
        }
        let mut room = self.spare.pop().unwrap_or_default();
        room.clear();
        room.extend_from_slice(state);
        self.states.push((time, room));
    }
}

/// The motion from before a singular position to a state behind, on its smooth branch.
pub(super) struct Continuation<'a> {
    /// The time of the singular position.
    pub passed: f64,
    /// The state behind.
    pub time: f64,
    pub state: Vec<f64>,
    /// The largest difference of both sums, relative to the largest component.
    pub error: f64,
    series: Box<dyn TaylorSeries<f64> + 'a>,
    expanded_at: f64,
}

impl<'a> Continuation<'a> {
    /// The continuation of a motion that came to a singular position with an event, within the span up to `end`. None where no pair of sums
    /// agrees, or where a switch falls, or another margin, before the state behind.
    pub fn of(
        (law, tolerance): (&'a dyn System, &Tolerance),
        trail: &Trail,
        ((event, met), end): ((f64, &[f64]), f64),
        switches: &SwitchesAndEnds<'_>,
    ) -> Option<Self> {
        let mut series = law.taylor()?;
        let states = bases(&mut *series, trail, event)?;
        let mut best: Option<Candidate<'_>> = None;
        for pair in states.windows(2) {
            let [near, far] = [&pair[0], &pair[1]];
            let times = PARTS.map(|part| nearer_of(event + part * (event - near.0), end, event));
            let [ones, others] = [near, far].map(|(base, state)| {
                series.expand(*base, state, ORDER);
                times.map(|time| {
                    let mut sum = vec![0.0; state.len()];
                    series.sum(time - base, &mut sum);
                    sum
                })
            });
            for ((time, one), mut state) in times.into_iter().zip(ones).zip(others) {
                let Some(error) = difference(tolerance, &one, &state) else { continue };
                if let Some(projection) = law.projection() {
                    projection.project(time, &mut state);
                }
                // an error is that of a direction, by the distance from the position
                let doubt = error.max(f64::EPSILON) / (time - event).abs();
                if best.as_ref().is_none_or(|best| doubt < best.doubt)
                    && difference(tolerance, &one, &state).is_some()
                    && is_motion(law, &*series, (time, time - far.0), &state)
                    && switches.hold((event, met), (time, &state))
                {
                    best = Some(Candidate { base: far, time, state, error, doubt });
                }
            }
        }
        let Candidate { base: (expanded_at, base), time, state, error, .. } = best?;
        series.expand(*expanded_at, base, ORDER);
        let found = Continuation { passed: event, time, state, error, series, expanded_at: *expanded_at };
        let is_up = |at: f64| switches.hold((event, met), (at, &found.at(at)));
        let between = |part: f64| event + part * (time - event);
        // the position lies in the middle of where its margin is not positive
        let (mut below, mut above) = (0.0, 1.0);
        for _ in 0..BISECTIONS {
            let middle = f64::midpoint(below, above);
            if is_up(between(middle)) { above = middle } else { below = middle }
        }
        let rest_is_up =
            (0..LOOKS).all(|look| is_up(between(above + (1.0 - above) * f64::from(look) / f64::from(LOOKS))));
        let passed = between(0.5 * above);
        (rest_is_up && !is_up(passed)).then_some(Continuation { passed, ..found })
    }

    /// The state at a time before the one behind.
    pub fn at(&self, time: f64) -> Vec<f64> {
        let mut state = self.state.clone();
        self.series.sum(time - self.expanded_at, &mut state);
        state
    }

    /// Shows an observer the samples in between, and the state behind; returns their number.
    pub fn show(&self, outputs: &[f64], event: f64, states: usize, observer: &mut dyn Observer<f64>) -> usize {
        let direction = self.time - event;
        let within = |output: &&f64| (**output - event) * direction > 0.0 && (self.time - **output) * direction >= 0.0;
        let samples: Vec<f64> = outputs.iter().filter(within).copied().collect();
        samples.iter().for_each(|output| observer.sample(*output, &self.at(*output)[..states]));
        observer.singular_position(self.passed, &self.at(self.passed)[..states], self.error);
        observer.step(self.time, &self.state[..states]);
        samples.len()
    }
}

/// A state behind a singular position, by the series of a state before.
struct Candidate<'a> {
    base: &'a (f64, Vec<f64>),
    time: f64,
    state: Vec<f64>,
    /// The difference of both sums, and this by the distance from the position.
    error: f64,
    doubt: f64,
}

/// The nearer of two times to an event before both.
fn nearer_of(time: f64, other: f64, event: f64) -> f64 {
    if (time - event).abs() < (other - event).abs() { time } else { other }
}

/// States before an event, from the nearest on: those that the motion left, and some on the series of the last one.
fn bases(series: &mut dyn TaylorSeries<f64>, trail: &Trail, event: f64) -> Option<Vec<(f64, Vec<f64>)>> {
    let (last, state) = trail.states.iter().rev().find(|(time, _)| *time != event)?;
    series.expand(*last, state, ORDER);
    let within = (1..=HALVINGS).rev().map(|halving| {
        let time = event - (event - last) * 0.5_f64.powi(halving);
        let mut sum = state.clone();
        series.sum(time - last, &mut sum);
        (time, sum)
    });
    let mut states: Vec<(f64, Vec<f64>)> = Vec::new();
    for (time, state) in within.chain(trail.states.iter().rev().filter(|(time, _)| *time != event).cloned()) {
        if states.last().is_none_or(|(known, _)| (event - time).abs() > APART * (event - known).abs()) {
            states.push((time, state));
        }
    }
    Some(states)
}

/// The largest difference of two states relative to the largest component; none where it is more than the tolerance allows.
fn difference(tolerance: &Tolerance, one: &[f64], other: &[f64]) -> Option<f64> {
    let largest = one.iter().fold(0.0, |largest: f64, part| largest.max(part.abs()));
    let differences = || one.iter().zip(other).map(|(one, other)| (one - other).abs());
    let allowed =
        |i: usize| (AGREED * (tolerance.absolute(i) + tolerance.relative * one[i].abs())).max(ROUNDING * largest);
    let agree = differences().enumerate().all(|(i, difference)| difference <= allowed(i));
    agree.then(|| differences().fold(0.0, f64::max) / largest.max(f64::MIN_POSITIVE))
}

/// Whether the derivative of a series, at a time so far from where it was expanded, is the rate of the law.
fn is_motion(law: &dyn System, series: &dyn TaylorSeries<f64>, (time, apart): (f64, f64), state: &[f64]) -> bool {
    let mut rates = vec![f64::NAN; state.len()];
    Ode::<f64>::rates(law, time, state, &mut rates);
    let largest = rates.iter().fold(0.0, |largest: f64, rate| largest.max(rate.abs()));
    let mut derivative = vec![0.0; state.len()];
    for order in (1..=ORDER).rev() {
        let parts = derivative.iter_mut().zip(series.coefficients(order));
        parts.for_each(|(sum, part)| *sum = *sum * apart + order as f64 * part);
    }
    largest.is_finite() && rates.iter().zip(&derivative).all(|(rate, sum)| (rate - sum).abs() <= OF_RATES * largest)
}
