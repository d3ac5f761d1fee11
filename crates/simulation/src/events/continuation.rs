//! The continuation of a motion beyond a singular position, on its smooth branch.
//!
//! At a singular position the constraints are linearly dependent: the equations do not determine the accelerations, and
//! several motions may follow. At most one of them has coordinates that are analytic functions of time, and its Taylor
//! series at a regular state before the position gives the states beyond. The series is summed from two states before
//! to one state beyond. Rounding errors grow for states close to the position, the truncation error for states far from
//! it. Therefore pairs at several distances are tried, and the pair whose sums agree best is taken. The derivative of
//! the series must equal the rate of the law at the state beyond: a series that converges to no motion of the law is
//! rejected.
//!
//! A run may begin near a singular position. If it moves away from it, Taylor series lead away too. If it moves towards
//! it, series backwards in time give states before the start, from which the motion is continued.

use super::law_end::SwitchesAndEnds;
use super::trail::{FIRST, Instant, ORDER, Trail, away};
use integrators::{Observer, Ode, System, TaylorSeries, Tolerance};

/// The distance of the state beyond the position, as a fraction of the distance b of the nearer state before. A
/// rounding error e of the constraints makes the motion deviate from the branch by the order of e/t at the distance t,
/// and the terms of e/t grow as ((t + b)/b)^k with the order k; t must be small compared with b.
const PARTS: [f64; 5] = [1.0, 0.5, 0.25, 0.125, 0.0625];

/// Both sums may differ by at most this many tolerances, or by the fraction `ROUNDING` of the largest component.
const AGREED: f64 = 10.0;
const ROUNDING: f64 = 1e-9;

/// Among sums that agree to this fraction the nearest state is taken: fewer events can occur on the way.
const SURE: f64 = 1e-13;

/// The number of bisections for the ends of the position's neighbourhood.
const BISECTIONS: usize = 40;
const LOOKS: u32 = 16;

/// The number of intervals in the search for a position that does not coincide with the event.
const SCANNED: u32 = 4096;

/// The derivative of the series may differ from the rates of the law by at most this fraction of the largest rate.
const OF_RATES: f64 = 1e-5;

/// The number of states on each side of the position for interpolation near it.
const NODES: u32 = 4;

/// The motion across the neighbourhood of a singular position, up to a state beyond it.
pub(super) struct Continuation<'a> {
    /// The singular position; `None` where the motion only moves away from it.
    position: Option<Position>,
    /// The time of the state beyond, s.
    pub time: f64,
    state: Vec<f64>,
    series: Box<dyn TaylorSeries<f64> + 'a>,
    expanded_at: f64,
}

/// A singular position that the motion passes.
#[derive(Clone, Copy, Debug)]
struct Position {
    /// The times (s) between which the margins are not positive; the position lies in the middle.
    around: [f64; 2],
    /// The largest difference of both sums, relative to the largest component.
    error: f64,
}

impl Position {
    fn time(&self) -> f64 {
        f64::midpoint(self.around[0], self.around[1])
    }
}

impl<'a> Continuation<'a> {
    /// The continuation of a motion that reached a singular position with an event. `event` is its time (s), `met` the state
    /// then. `None` where no pair of sums
    /// agrees, or where a switch or another margin falls before the state beyond.
    pub fn of(
        (law, tolerance): (&'a dyn System, &Tolerance),
        trail: &Trail,
        (event, met): (f64, &[f64]),
        switches: &SwitchesAndEnds<'_>,
    ) -> Option<Self> {
        let mut series = law.taylor()?;
        let chains = trail.chains(law, event)?;
        let mut candidates: Vec<Candidate> = Vec::new();
        for (number, chain) in chains.iter().enumerate() {
            for pair in chain.windows(2) {
                let [far, near] = [&pair[0], &pair[1]];
                let times = PARTS.map(|part| event + part * (event - near.0));
                let mut sums = |(base, state): &Instant| {
                    series.expand(*base, state, ORDER);
                    times.map(|time| {
                        let mut sum = vec![0.0; state.len()];
                        series.sum(time - base, &mut sum);
                        sum
                    })
                };
                // all states of a chain share the rounding error of its first state
                let is_behind = |other: &&Instant| (event - other.0).abs() <= (event - far.0).abs();
                let other = chains.get(number + 1).and_then(|other| other.iter().find(is_behind)).map(&mut sums);
                let agrees = |place: usize, state: &[f64]| {
                    other.as_ref().is_none_or(|other| difference(tolerance, &other[place], state).is_some())
                };
                for (place, (one, mut state)) in sums(near).into_iter().zip(sums(far)).enumerate() {
                    let time = times[place];
                    let Some(error) = difference(tolerance, &one, &state) else { continue };
                    if let Some(projection) = law.projection() {
                        projection.project(time, &mut state);
                    }
                    let is_behind = switches.hold((event, met), (time, &state));
                    if is_behind && difference(tolerance, &one, &state).is_some() && agrees(place, &state) {
                        candidates.push(Candidate { base: far.clone(), behind: (time, state), error });
                    }
                }
            }
        }
        let distance = |candidate: &Candidate| (candidate.behind.0 - event).abs();
        let nearest = candidates.iter().map(distance).fold(f64::INFINITY, f64::min);
        // the error of a direction is the error divided by the distance from the position
        let doubt = |candidate: &Candidate| (candidate.error * nearest / distance(candidate)).max(SURE);
        candidates
            .sort_by(|one, other| doubt(one).total_cmp(&doubt(other)).then(distance(one).total_cmp(&distance(other))));
        candidates.into_iter().find_map(|Candidate { base: (expanded_at, base), behind: (time, state), error }| {
            series.expand(expanded_at, &base, ORDER);
            let is_found = is_motion(law, &*series, (time, time - expanded_at), &state);
            let at = |at: f64| {
                let mut sum = state.clone();
                series.sum(at - expanded_at, &mut sum);
                sum
            };
            let around = is_found.then(|| around((expanded_at, event, time), &at, met, switches)).flatten()?;
            let series = law.taylor().map(|mut series| {
                series.expand(expanded_at, &base, ORDER);
                series
            })?;
            Some(Continuation { position: Some(Position { around, error }), time, state, series, expanded_at })
        })
    }

    /// The motion away from a singular position near its start, up to a state with positive margins. `span` is the length of
    /// the run in s. `None` if the law has no Taylor series, or no such state is found.
    pub fn leaving(
        (law, tolerance): (&'a dyn System, &Tolerance),
        start: &Instant,
        span: f64,
        switches: &SwitchesAndEnds<'_>,
    ) -> Option<Self> {
        let mut series = law.taylor()?;
        let (time, state) = away(law, start, FIRST * span, (switches, 1))?.pop()?;
        series.expand(time, &state, ORDER);
        let found = Continuation { position: None, time, state, series, expanded_at: time };
        difference(tolerance, &start.1, &found.at(start.0)).map(|_| found)
    }

    /// Whether another continuation leads to the same state, within the tolerance.
    pub fn agrees(&self, other: &Self, tolerance: &Tolerance) -> bool {
        difference(tolerance, &self.state, &other.at(self.time)).is_some()
    }

    /// The state at a time up to that of the state beyond.
    pub fn at(&self, time: f64) -> Vec<f64> {
        if time == self.time {
            return self.state.clone();
        }
        let mut state = self.state.clone();
        self.series.sum(time - self.expanded_at, &mut state);
        state
    }

    /// Reports to the observer the samples at `outputs` (s) from an event to `end`, both times in s, and the state there.
    /// `states` is the number of states that are reported. Returns the number of samples.
    pub fn show(
        &self,
        outputs: &[f64],
        (event, end): (f64, f64),
        states: usize,
        observer: &mut dyn Observer<f64>,
    ) -> usize {
        let direction = self.time - event;
        let is_within =
            |time: f64, [from, to]: [f64; 2]| (time - from) * direction > 0.0 && (to - time) * direction >= 0.0;
        let nodes = self.position.map(|position| self.nodes(position, states)).unwrap_or_default();
        let mut shown = 0;
        for output in outputs.iter().copied().filter(|output| is_within(*output, [event, end])) {
            let state = self.at(output);
            match self.position.is_some_and(|position| is_within(output, position.around)) {
                true => observer.sample_between(output, &state[..states], &nodes),
                false => observer.sample(output, &state[..states]),
            }
            shown += 1;
        }
        // the step size may collapse just beyond the position
        if let Some(position) = self.position.filter(|position| (end - position.time()) * direction >= 0.0) {
            let state = self.at(position.time());
            observer.singular_position(position.time(), &state[..states], position.error, &nodes);
        }
        observer.step(end, &self.at(end)[..states]);
        shown
    }

    /// States on both sides of the position where the margins are positive.
    fn nodes(&self, Position { around: [from, to], .. }: Position, states: usize) -> Vec<Instant> {
        let steps = (1..=NODES).map(|node| f64::from(node) / f64::from(NODES));
        let before = steps.clone().map(|step| from + step * (self.expanded_at - from));
        let behind = steps.map(|step| to + step * (self.time - to));
        let times = before.chain(behind);
        times.map(|time| (time, self.at(time)[..states].to_vec())).collect()
    }
}

/// A state beyond a singular position, by the Taylor series of a state before.
struct Candidate {
    base: Instant,
    behind: Instant,
    /// The difference of both sums.
    error: f64,
}

/// The times around an event at which the margins cease and begin to be positive, between the expansion point `base`
/// and `time`. `None` where they are not positive again by then, or a switch falls.
fn around(
    (base, event, time): (f64, f64, f64),
    at: &dyn Fn(f64) -> Vec<f64>,
    met: &[f64],
    switches: &SwitchesAndEnds<'_>,
) -> Option<[f64; 2]> {
    let is_up = |time: f64| switches.hold((event, met), (time, &at(time)));
    let end = |outside: f64, inside: f64, holds: &dyn Fn(f64) -> bool| {
        let (mut outside, mut inside) = (outside, inside);
        for _ in 0..BISECTIONS {
            let middle = f64::midpoint(outside, inside);
            if holds(middle) { outside = middle } else { inside = middle }
        }
        outside
    };
    // a method that deviates from the position may locate its event beyond it
    let scan = (1..SCANNED).map(|part| base + (time - base) * f64::from(part) / f64::from(SCANNED));
    let inside = [event].into_iter().chain(scan).find(|time| !is_up(*time))?;
    let to = end(time, inside, &is_up);
    let from = end(base, inside, &|time: f64| switches.margins_hold(time, &at(time)));
    let rest_is_up = (0..LOOKS).all(|look| is_up(to + (time - to) * f64::from(look) / f64::from(LOOKS)));
    (rest_is_up && !is_up(f64::midpoint(from, to))).then_some([from, to])
}

/// The largest difference of two states, relative to the largest component; `None` where it exceeds the tolerance.
fn difference(tolerance: &Tolerance, one: &[f64], other: &[f64]) -> Option<f64> {
    let largest = one.iter().fold(0.0, |largest: f64, part| largest.max(part.abs()));
    let differences = || one.iter().zip(other).map(|(one, other)| (one - other).abs());
    let allowed =
        |i: usize| (AGREED * (tolerance.absolute(i) + tolerance.relative * one[i].abs())).max(ROUNDING * largest);
    let agree = differences().enumerate().all(|(i, difference)| difference <= allowed(i));
    agree.then(|| differences().fold(0.0, f64::max) / largest.max(f64::MIN_POSITIVE))
}

/// Whether the derivative of a series, at the time `apart` after its expansion point, equals the rate of the law.
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
