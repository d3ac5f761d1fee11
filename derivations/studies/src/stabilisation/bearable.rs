//! Smallest and largest stability limit of the step size of Euler's method for the drive's circuit, along a whole
//! motion.
//!
//! The limit at a time depends on the diodes, whose knees are passed in milliseconds. It is evaluated at every step of
//! a method of order 5 and at `INSTANTS` further times; near the extrema it is refined by golden section search.

use super::drive_law::{Seven, bearable_step};
use integrators::{Failure, Method, Observer, Span, System, Tolerance, integrate};
use simulation::CompiledLaw;

/// The number of times at which the limit is evaluated, besides the steps of the method.
const INSTANTS: usize = 4000;

/// The number of local extrema that are refined.
const SEARCHED: usize = 6;

/// The number of golden sections: they reduce an interval to a millionth.
const SECTIONS: usize = 30;

const METHOD: Method = Method::RadauIIA { stages: 3 };
const TOLERANCE: f64 = 1e-8;

/// The budget of evaluations for the whole motion: a stiff circuit takes some hundred thousands.
const EVALUATIONS: u64 = 1_000_000;

/// The motion with the stability limit of the step size at each time.
struct Course<'a> {
    law: &'a CompiledLaw,
    points: Vec<Point>,
}

struct Point {
    time: f64,
    state: Vec<f64>,
    step: f64,
}

impl Point {
    fn of(law: &CompiledLaw, time: f64, state: &[f64]) -> Self {
        Point { time, state: state.to_vec(), step: step_at(law, time, state) }
    }
}

impl Observer<f64> for Course<'_> {
    fn sample(&mut self, time: f64, state: &[f64]) {
        self.points.push(Point::of(self.law, time, state));
    }

    fn step(&mut self, time: f64, state: &[f64]) {
        if self.points.last().is_none_or(|last| last.time < time) {
            self.points.push(Point::of(self.law, time, state));
        }
    }
}

/// The smallest and the largest stability limit (s) of Euler's step size along the motion from a start to the time
/// `end` (s).
///
/// # Errors
/// [`Failure`] of the run, which may use a million evaluations.
pub fn bearable_steps(law: &Seven, start: &[f64], end: f64) -> Result<[f64; 2], Failure> {
    let mut span = Span::new(0.0, end, start).with_even_outputs(INSTANTS).with_evaluations(EVALUATIONS);
    span.outputs.insert(0, 0.0);
    let law = CompiledLaw::new(*law);
    let mut course = Course { law: &law, points: Vec::new() };
    match integrate(&law, METHOD, &Tolerance::both(TOLERANCE), &span, &mut course).failure() {
        None => Ok([-course.greatest(|step| -step), course.greatest(|step| step)]),
        Some(failure) => Err(failure),
    }
}

/// The stability limit at a time, s; NaN for a law without Jacobian.
fn step_at(law: &CompiledLaw, time: f64, state: &[f64]) -> f64 {
    law.jacobian_fn().map_or(f64::NAN, |mut slopes| bearable_step(&mut *slopes, time, state))
}

impl Course<'_> {
    /// The largest value of a function of the limit, refined near the largest local maxima.
    fn greatest(&self, of: impl Fn(f64) -> f64) -> f64 {
        let value = |k: usize| of(self.points[k].step);
        let last = self.points.len() - 1;
        let is_peak = |k: &usize| (*k == 0 || value(k - 1) <= value(*k)) && (*k == last || value(k + 1) <= value(*k));
        let mut peaks: Vec<usize> = (0..=last).filter(is_peak).collect();
        peaks.sort_by(|a, b| value(*b).total_cmp(&value(*a)));
        let searched = peaks.iter().take(SEARCHED).map(|&k| self.about([k.saturating_sub(1), last.min(k + 1)], &of));
        searched.chain(peaks.first().map(|&k| value(k))).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest value between two points, by golden section search.
    fn about(&self, [begin, end]: [usize; 2], of: &impl Fn(f64) -> f64) -> f64 {
        let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut low, mut high) = (self.points[begin].time, self.points[end].time);
        let mut best = f64::NEG_INFINITY;
        let mut value = |time: f64| {
            let value = self.step_at(&self.points[begin], time).map_or(f64::NEG_INFINITY, of);
            best = best.max(value);
            value
        };
        let inner = |low: f64, high: f64| [high - ratio * (high - low), low + ratio * (high - low)];
        let [mut left, mut right] = inner(low, high).map(&mut value);
        for _ in 0..SECTIONS {
            if left > right {
                (high, right) = (inner(low, high)[1], left);
                left = value(inner(low, high)[0]);
            } else {
                (low, left) = (inner(low, high)[0], right);
                right = value(inner(low, high)[1]);
            }
        }
        best
    }

    fn step_at(&self, from: &Point, time: f64) -> Option<f64> {
        if time <= from.time {
            return Some(from.step);
        }
        let span = Span::new(from.time, time, &from.state);
        let outcome = integrate(self.law, METHOD, &Tolerance::both(TOLERANCE), &span, &mut ());
        outcome.reached().then(|| step_at(self.law, time, &outcome.state))
    }
}
