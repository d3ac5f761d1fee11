//! Detection of poles and jumps of a law that a step has passed over.
//!
//! A method of finite order may step over a pole of the rates, and continue with numbers that are no motion of the law.
//! Along a motion the divisors of a law keep their signs, or vanish together with their dividends. A step over which a
//! divisor changes its sign is therefore examined: near the zero of the divisor, on the chord of the step, the rates
//! are large compared with those at both ends if the zero is a pole, and similar to them if it is removable.
//!
//! A square root has a corner where its radicand vanishes, for example the distance of two points that pass each other
//! on a line; a unit vector jumps there. A method of finite order passes a jump by short steps, or steps over it
//! unnoticed. A step over which a radicand touches zero is therefore examined too: the jump of the rates, times the
//! step, must not exceed the tolerance much. A step over which an angle atan2(y, x) passes from pi to -pi is examined
//! likewise.

use integrators::{Divisors, Observer, Outcome, System, Tolerance};
use std::f64::consts::PI;

/// The rates near a zero belong to a pole if they exceed those at the ends of the step by this factor.
const LARGE: f64 = 1e3;

/// The distance from the zero at which rates are compared, as a fraction of the shorter part of the step: at a pole
/// rates are larger there by 1e6.
const NEAR: f64 = 1e-6;

/// Rates smaller than this fraction of the largest rate are rounding.
const ROUNDING: f64 = 1e-9;

/// The number of bisections that locate the zero more closely than [`NEAR`].
const HALVINGS: usize = 60;

/// The reason of a run that ends before a pole.
pub const POLE: &str =
    "a divisor of its rates passes through zero in the next step, where they grow without bound: no motion follows";

/// The outcome, cut back to an earlier time and state.
pub(super) fn up_to(outcome: Outcome<f64>, (time, state): (f64, Vec<f64>)) -> Outcome<f64> {
    let deviations = outcome.deviations.into_iter().filter(|one| one.at <= time).collect();
    Outcome { time, state, deviations, ..outcome }
}

/// The reason of a run that ends before a jump that the method does not resolve.
const JUMP: &str = "in the next step the argument of a root, such as a distance or a speed, passes through zero, where the rates jump: \
     this step is too long to follow them; dormand_prince_8 and taylor pass such places by short steps";

/// The reason of a run that ends before a jump of an angle that the method does not resolve.
const TURN: &str = "in the next step an angle atan2(y, x) goes over from pi to -pi, where the rates jump: this step is too long to follow \
     them; dormand_prince_8 and taylor pass such places by short steps. An angle that is counted on is a coordinate of its own";

/// A radicand touches zero if it is smaller than at the ends of a step by this factor.
const SMALL: f64 = 1e-3;

/// The distance from a jump at which rates are compared, as a fraction of the shorter part of the step.
const BESIDE: f64 = 1e-3;

/// A change of the rates by this fraction over that distance is a jump.
const JUMPS: f64 = 0.05;

/// A jump times the step is not resolved if it exceeds the tolerance by this factor.
const UNSEEN: f64 = 1e3;

/// A time (s) and a state.
#[derive(Clone, Debug, Default)]
struct Instant {
    time: f64,
    state: Vec<f64>,
}

/// Examines the divisors of a law over each step; its observer receives nothing beyond a pole.
pub(super) struct PoleWatch<'a> {
    law: &'a dyn System,
    tolerance: &'a Tolerance,
    divisors: Option<&'a dyn Divisors>,
    observer: &'a mut dyn Observer<f64>,
    before: Instant,
    /// The divisors at the last state, and after the step.
    values: [Vec<f64>; 2],
    /// Outputs of the step that has not been examined yet.
    samples: Vec<Instant>,
    /// The reason if the run must end.
    why: Option<&'static str>,
}

impl<'a> PoleWatch<'a> {
    /// Begins the observation of a run at its start, a time (s) and a state.
    pub fn new(
        (law, tolerance): (&'a dyn System, &'a Tolerance),
        (time, state): (f64, &[f64]),
        observer: &'a mut dyn Observer<f64>,
    ) -> Self {
        let divisors = law.divisors();
        let mut value = vec![f64::NAN; divisors.map_or(0, |divisors| divisors.counts().iter().sum())];
        if let Some(divisors) = divisors {
            divisors.at(time, state, &mut value);
        }
        PoleWatch {
            law,
            tolerance,
            divisors,
            observer,
            before: Instant { time, state: state.to_vec() },
            values: [value.clone(), value],
            samples: Vec::new(),
            why: None,
        }
    }

    /// The last state before a pole or a jump, as time (s), state and reason; also if it lies within the last
    /// step of the run. `None` if the run has reached none.
    pub fn end(mut self, Outcome { time, state, .. }: &Outcome<f64>) -> Option<(f64, Vec<f64>, &'static str)> {
        if let Some(why) = self.why.or_else(|| self.passed(*time, state)) {
            return Some((self.before.time, self.before.state, why));
        }
        self.show_samples();
        None
    }

    fn show_samples(&mut self) {
        for Instant { time, state } in self.samples.drain(..) {
            self.observer.sample(time, &state);
        }
    }

    /// The reason why the step from the last state to this one is invalid; `None` where it is valid.
    fn passed(&mut self, time: f64, state: &[f64]) -> Option<&'static str> {
        let divisors = self.divisors?;
        let [before, after] = &mut self.values;
        divisors.at(time, state, after);
        let changed = |(one, other): (&f64, &f64)| one * other < 0.0;
        let [signed, radicands, angles] = divisors.counts();
        let candidates = before[..signed].iter().zip(&*after).map(changed).enumerate();
        let candidates: Vec<usize> = candidates.filter_map(|(place, has)| has.then_some(place)).collect();
        if candidates.into_iter().any(|place| self.is_pole(divisors, place, (time, state))) {
            return Some(POLE);
        }
        let end = (time, state);
        if radicands > 0 && self.corners(divisors, end).into_iter().any(|at| self.jumps(at, end)) {
            return Some(JUMP);
        }
        (angles > 0 && self.half_turns(divisors, end).into_iter().any(|at| self.jumps(at, end))).then_some(TURN)
    }

    /// The time and state at a fraction of the chord from the last state to another.
    fn chord(&self, (time, state): (f64, &[f64]), part: f64) -> (f64, Vec<f64>) {
        let between = |(from, to): (&f64, &f64)| from + part * (to - from);
        (between((&self.before.time, &time)), self.before.state.iter().zip(state).map(between).collect())
    }

    /// The rates at a fraction of the chord.
    fn rates(&self, end: (f64, &[f64]), part: f64) -> Vec<f64> {
        let (time, state) = self.chord(end, part);
        let mut rates = vec![f64::NAN; state.len()];
        self.law.rates(time, &state, &mut rates);
        rates
    }

    /// The fractions of the step at which a radicand touches zero.
    fn corners(&self, divisors: &dyn Divisors, end: (f64, &[f64])) -> Vec<f64> {
        let [signed, radicands, _] = divisors.counts();
        let mut middle = vec![f64::NAN; self.values[0].len()];
        let (time_between, between) = self.chord(end, 0.5);
        divisors.at(time_between, &between, &mut middle);
        let [before, after] = &self.values;
        let lowest = |place: usize| {
            let [from, at, to] = [before[place], middle[place], after[place]];
            // the parabola through three values
            let (slope, bend) = (4.0 * at - 3.0 * from - to, 2.0 * (from + to - 2.0 * at));
            let lowest = -slope / (2.0 * bend);
            let least = from + lowest * (slope + lowest * bend);
            (lowest > 0.0 && lowest < 1.0 && least <= SMALL * from.min(to)).then_some(lowest)
        };
        (signed..signed + radicands).filter_map(lowest).collect()
    }

    /// The fractions of the step at which an angle jumps from pi to -pi, or back.
    fn half_turns(&self, divisors: &dyn Divisors, end: (f64, &[f64])) -> Vec<f64> {
        let [signed, radicands, angles] = divisors.counts();
        let [before, after] = &self.values;
        let places = signed + radicands..signed + radicands + angles;
        let turned = places.filter(|&place| (after[place] - before[place]).abs() > PI);
        turned.map(|place| self.change_of_sign(divisors, place, end).0).collect()
    }

    /// Whether the rates jump at a fraction of the step by more than the method resolves.
    fn jumps(&self, at: f64, (time, state): (f64, &[f64])) -> bool {
        let part = at.min(1.0 - at);
        let [first, last, below, above] =
            [0.0, 1.0, at - BESIDE * part, at + BESIDE * part].map(|at| self.rates((time, state), at));
        let step = part * (time - self.before.time).abs();
        (0..first.len()).any(|i| {
            let jump = (above[i] - below[i]).abs();
            let usual = first[i].abs().max(last[i].abs());
            let allowed = self.tolerance.absolute(i) + self.tolerance.relative * state[i].abs();
            jump > JUMPS * usual && jump * step > UNSEEN * allowed
        })
    }

    /// Adjacent fractions of the step between which one of the values changes its sign.
    fn change_of_sign(&self, divisors: &dyn Divisors, place: usize, end: (f64, &[f64])) -> (f64, f64) {
        let mut values = vec![f64::NAN; self.values[0].len()];
        let mut value = |part: f64| {
            let (time, state) = self.chord(end, part);
            divisors.at(time, &state, &mut values);
            values[place]
        };
        let sign = value(0.0).signum();
        let [mut from, mut to] = [0.0_f64, 1.0];
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(from, to);
            if value(middle).signum() == sign { from = middle } else { to = middle }
        }
        (from, to)
    }

    /// Whether the rates have a pole where a divisor vanishes between the last state and another.
    fn is_pole(&self, divisors: &dyn Divisors, place: usize, end: (f64, &[f64])) -> bool {
        let (from, to) = self.change_of_sign(divisors, place, end);
        let apart = NEAR * from.min(1.0 - to);
        let rates = |part: f64| self.rates(end, part);
        let [first, last, below, above] = [0.0, 1.0, from - apart, to + apart].map(rates);
        let largest = first.iter().chain(&last).fold(0.0, |largest: f64, rate| largest.max(rate.abs()));
        (0..first.len()).any(|i| {
            let usual = first[i].abs().max(last[i].abs()).max(ROUNDING * largest);
            [below[i], above[i]].iter().any(|rate| rate.is_nan() || rate.abs() > LARGE * usual)
        })
    }
}

impl Observer<f64> for PoleWatch<'_> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        if self.divisors.is_none() || time == self.before.time {
            self.observer.sample(time, state);
        } else {
            self.samples.push(Instant { time, state: state.to_vec() });
        }
    }

    fn between(&mut self, begin: f64, end: f64, state_at: &dyn Fn(f64, &mut [f64])) {
        self.observer.between(begin, end, state_at);
    }

    fn step(&mut self, time: f64, state: &[f64]) {
        self.why = self.passed(time, state);
        if self.why.is_some() {
            return;
        }
        self.show_samples();
        self.observer.step(time, state);
        self.before.time = time;
        self.before.state.clone_from_slice(state);
        self.values.swap(0, 1);
    }

    fn progress(&mut self, fraction: f64) {
        self.observer.progress(fraction);
    }

    fn enough(&self) -> bool {
        self.why.is_some() || self.observer.enough()
    }
}
