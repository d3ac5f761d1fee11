//! Poles of a law that a step has passed over.
//!
//! A method of finite order may step over a place where the rates are infinite, and go on with numbers that are no motion. Along a
//! motion the divisors of a law keep their signs, or vanish together with what they divide. So a step over which one changes its sign
//! is looked at: near the zero of the divisor, on the chord of the step, rates are large beside those at both ends if it is a pole, and
//! of their size if it is none.

use integrators::{Divisors, Observer, Outcome, System};

/// Rates near a zero that are larger than at the ends of the step by this factor are those of a pole.
const LARGE: f64 = 1e3;

/// The distance from the zero at which they are looked at, of the shorter part of the step: at a pole rates are larger there by 1e6.
const NEAR: f64 = 1e-6;

/// Rates smaller than this part of the largest rate are rounding.
const ROUNDING: f64 = 1e-9;

/// Halvings of the step that bring its zero closer than [`NEAR`].
const HALVINGS: usize = 60;

/// Why a run ends before a pole.
pub(super) const POLE: &str = "a divisor of its rates passes through zero in the next step, where they grow without bound: no motion goes on there";

/// A run that ends before its last step; what changed most in that step is not told.
pub(super) fn up_to(outcome: Outcome<f64>, (time, state): (f64, Vec<f64>)) -> Outcome<f64> {
    let deviations = outcome.deviations.into_iter().filter(|one| one.at <= time).collect();
    Outcome { time, state, deviations, ..outcome }
}

/// A time and a state.
#[derive(Clone, Debug, Default)]
struct Instant {
    time: f64,
    state: Vec<f64>,
}

/// Watches the divisors of a law over the steps of a run, and shows its observer nothing beyond a pole.
pub(super) struct PoleWatch<'a> {
    law: &'a dyn System,
    divisors: Option<&'a dyn Divisors>,
    observer: &'a mut dyn Observer<f64>,
    before: Instant,
    /// The divisors there, and after the step.
    values: [Vec<f64>; 2],
    /// Outputs of the step that was not looked at yet.
    samples: Vec<Instant>,
    is_over: bool,
}

impl<'a> PoleWatch<'a> {
    /// Of a run that begins at a time and a state.
    pub fn new(law: &'a dyn System, (time, state): (f64, &[f64]), observer: &'a mut dyn Observer<f64>) -> Self {
        let divisors = law.divisors();
        let mut value = vec![f64::NAN; divisors.map_or(0, Divisors::count)];
        if let Some(divisors) = divisors {
            divisors.at(time, state, &mut value);
        }
        PoleWatch {
            law,
            divisors,
            observer,
            before: Instant { time, state: state.to_vec() },
            values: [value.clone(), value],
            samples: Vec::new(),
            is_over: false,
        }
    }

    /// The last state before a pole, where the run has come to one, be it on the way to the event that has ended it.
    pub fn end(mut self, Outcome { time, state, .. }: &Outcome<f64>) -> Option<(f64, Vec<f64>)> {
        if self.is_over || self.has_passed(*time, state) {
            return Some((self.before.time, self.before.state));
        }
        self.show_samples();
        None
    }

    fn show_samples(&mut self) {
        for Instant { time, state } in self.samples.drain(..) {
            self.observer.sample(time, &state);
        }
    }

    /// Whether a pole lies between the last state and another.
    fn has_passed(&mut self, time: f64, state: &[f64]) -> bool {
        let Some(divisors) = self.divisors else { return false };
        let [before, after] = &mut self.values;
        divisors.at(time, state, after);
        let changed = |(one, other): (&f64, &f64)| one * other < 0.0;
        let candidates = before.iter().zip(&*after).map(changed).enumerate();
        let candidates: Vec<usize> = candidates.filter_map(|(place, has)| has.then_some(place)).collect();
        candidates.into_iter().any(|place| self.is_pole(divisors, place, (time, state)))
    }

    /// Whether the rates are large where a divisor vanishes between the last state and another.
    fn is_pole(&self, divisors: &dyn Divisors, place: usize, (time, state): (f64, &[f64])) -> bool {
        let at = |part: f64| {
            let between = |(from, to): (&f64, &f64)| from + part * (to - from);
            let states = self.before.state.iter().zip(state).map(between).collect::<Vec<f64>>();
            (between((&self.before.time, &time)), states)
        };
        let mut values = vec![f64::NAN; divisors.count()];
        let mut value = |part: f64| {
            let (time, state) = at(part);
            divisors.at(time, &state, &mut values);
            values[place]
        };
        let sign = value(0.0).signum();
        let [mut from, mut to] = [0.0_f64, 1.0];
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(from, to);
            if value(middle).signum() == sign { from = middle } else { to = middle }
        }
        let apart = NEAR * from.min(1.0 - to);
        let rates = |part: f64| {
            let (time, state) = at(part);
            let mut rates = vec![f64::NAN; state.len()];
            self.law.rates(time, &state, &mut rates);
            rates
        };
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
        self.is_over = self.has_passed(time, state);
        if self.is_over {
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
        self.is_over || self.observer.enough()
    }
}
