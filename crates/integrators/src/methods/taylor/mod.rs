//! Taylor's method: the order follows from the tolerance, the step size from the last two terms.
//!
//! y(t + h) = sum_k a_k h^k up to an order p that grows with the logarithm of the tolerance. The step size makes the
//! last two terms as large as the tolerance allows (Jorba and Zou 2005). The polynomial is the dense output: an output
//! costs one evaluation by Horner's scheme.

mod departure;
mod rounding;
mod step;
mod transition;

use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Absolute, Failure, Real, Refusal, TaylorSeries, Tolerance};
use departure::Departure;
use rounding::Rounding;
pub(crate) use step::reach;
pub use step::taylor_order;
pub use transition::{Transition, transition};

/// Taylor's method for one system, for any number of runs. A run allocates no memory.
#[derive(Clone, Debug)]
pub struct Taylor<T> {
    source: T,
    tolerance: Tolerance,
    order: usize,
    rounding: Rounding,
}

impl<T> Taylor<T> {
    /// The method with the optimal order for the tolerance, see [`taylor_order`].
    pub fn new(source: T, tolerance: &Tolerance) -> Self {
        let order = taylor_order(tolerance.relative);
        let rounding = Rounding::new(order, tolerance.relative);
        Taylor { source, tolerance: tolerance.clone(), order, rounding }
    }

    /// The order p of the series.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The method with another order, at least 2.
    pub fn with_order(mut self, order: usize) -> Self {
        self.order = order.max(2);
        self
    }

    /// The largest step size for the series through (t, y); NaN where the series is undefined.
    ///
    /// In a scalar type finer than `f64` only the low orders need all digits, see [`rounding`].
    #[inline]
    fn reach<S: Real>(&mut self, time: S, y: &[S]) -> f64
    where
        T: TaylorSeries<S>,
    {
        let reach = if S::EPSILON < f64::EPSILON {
            self.reach_rounding(time, y)
        } else {
            self.source.expand(time, y, self.order);
            self.allowed(y)
        };
        let shown = self.source.shown();
        // `min` would drop a NaN
        if shown < reach { shown } else { reach }
    }

    /// The largest step size that the tolerance allows: the smaller one of s_k^(-1/k) for k = p - 1 and k = p, where
    /// s_k is the largest coefficient of order k in units of the allowed error.
    #[inline]
    fn allowed<S: Real>(&self, y: &[S]) -> f64
    where
        T: TaylorSeries<S>,
    {
        let (last, one_before) = (self.source.coefficients(self.order), self.source.coefficients(self.order - 1));
        let (mut s_last, mut s_before, mut sum) = (0.0_f64, 0.0_f64, 0.0);
        let mut compare = |absolute: f64, y: S, last: S, before: S| {
            let share = 1.0 / (absolute + self.tolerance.relative * y.approx().abs());
            let (a, b) = (last.approx().abs() * share, before.approx().abs() * share);
            // `max` drops a NaN, a sum does not
            s_last = if a > s_last { a } else { s_last };
            s_before = if b > s_before { b } else { s_before };
            sum += a + b;
        };
        let terms = y.iter().zip(last).zip(one_before);
        match &self.tolerance.absolute {
            Absolute::Same(same) => terms.for_each(|((y, last), before)| compare(*same, *y, *last, *before)),
            Absolute::Each(each) => {
                let terms = terms.zip(each.iter().copied().chain(std::iter::repeat(0.0)));
                terms.for_each(|(((y, last), before), absolute)| compare(absolute, *y, *last, *before));
            }
        }
        if !sum.is_finite() {
            return f64::NAN;
        }
        reach(self.order, s_last, s_before)
    }

    /// The cause of an expansion with terms that are not finite. If the rates are finite, terms of high order
    /// overflowed: a singularity is nearer than any step.
    fn beyond<S: Real>(&self) -> Cause
    where
        T: TaylorSeries<S>,
    {
        let rates = self.source.coefficients(1);
        if rates.iter().all(|rate| rate.finite()) { Cause::Error } else { Cause::Undefined }
    }

    /// Integrates the state from one time to another, forwards or backwards. Returns the number of steps.
    ///
    /// # Errors
    /// [`Failure`] if the run ends early; `state` is then the last valid state.
    pub fn propagate(&mut self, from: f64, to: f64, state: &mut [f64]) -> Result<u64, Failure>
    where
        T: TaylorSeries<f64>,
    {
        if !(from.is_finite() && to.is_finite()) {
            return Err(Failure::Refused(Refusal::SpanNotFinite { start: from, end: to }));
        }
        let (direction, mut at, mut steps) = ((to - from).signum(), from, 0);
        while at != to {
            let reach = self.reach(at, state);
            if reach.is_nan() {
                return Err(self.beyond().failure(at, 0.0));
            }
            let lands = reach >= (to - at).abs();
            let next = if lands { to } else { at + direction * reach };
            if next == at {
                return Err(Failure::StepCollapsed { at, step: reach });
            }
            self.source.sum(next - at, state);
            (at, steps) = (next, steps + 1);
        }
        Ok(steps)
    }
}

/// The method as a [`Stepper`].
pub(crate) struct TaylorStepper<S, T> {
    method: Taylor<T>,
    /// The expansion point of the present series, and its largest step size.
    expanded_at: Option<S>,
    reach: f64,
    direction: S,
    /// Buffers: the state within a step, the rates of the law there, and those of the series.
    within: [Vec<S>; 3],
    /// The step from a state without a series, if there was one; then whether it was the last step.
    departure: Option<Departure<S>>,
    departed: bool,
    /// The number of steps in a row that ended on another branch of the law.
    astray: u32,
}

impl<S: Real, T: TaylorSeries<S>> TaylorStepper<S, T> {
    pub fn new(source: T, tolerance: &Tolerance) -> Self {
        TaylorStepper {
            method: Taylor::new(source, tolerance),
            expanded_at: None,
            reach: 0.0,
            direction: S::one(),
            within: Default::default(),
            departure: None,
            departed: false,
            astray: 0,
        }
    }
}

/// If the rates of the series and of the law differ over a step by more than this many times the allowed error, the law
/// has changed its branch.
const OFF: f64 = 1e3;

/// Differences below this many roundings of the largest component are ignored: the rates of a body that friction holds at
/// rest are rounding errors.
const NOISE: f64 = 64.0;

/// The largest number of steps in a row that may end on another branch. A motion that crosses to another branch needs a
/// few. A motion that needs more has reached the end of the domain of its law, such as the bottom of a tank, where each
/// series leads back into the domain within the tolerance.
const MOST_ASTRAY: u32 = 12;

impl<S: Real, T: TaylorSeries<S>> TaylorStepper<S, T> {
    /// Whether the rates of the series agree with those of the law in the middle of a step and at its end.
    fn follows(&mut self, (tau, step): (S, S), meter: &BudgetedRhs<S>) -> bool {
        let TaylorStepper { method, direction, within: [state, rates, own], astray, .. } = self;
        let states = method.source.coefficients(0).len();
        for room in [&mut *state, rates, own] {
            room.resize(states, S::zero());
        }
        let mut is_astray = false;
        let follows = [step.half(), step].into_iter().all(|passed| {
            let h = passed * *direction;
            method.source.sum(h, state);
            meter.rates(tau + passed, state, rates);
            own.fill(S::zero());
            for k in (1..=method.order).rev() {
                let terms = method.source.coefficients(k);
                let times = S::int(k as i64);
                own.iter_mut().zip(terms).for_each(|(sum, term)| *sum = *sum * h + *term * times);
            }
            let size = |i: usize| state[i].approx().abs() + rates[i].approx().abs() * step.approx();
            let noise = S::EPSILON * NOISE * (0..states).map(size).fold(0.0, f64::max);
            (0..states).all(|i| {
                let apart = (own[i] * *direction - rates[i]).magnitude().approx() * step.approx();
                let value = state[i].approx().abs();
                let allowed = method.tolerance.absolute(i) + method.tolerance.relative * value;
                let rounding = S::EPSILON * size(i);
                let sizes = own[i].approx().abs() + rates[i].approx().abs();
                is_astray |= apart > noise.max(OFF * rounding) && apart > 0.5 * sizes * step.approx();
                apart <= OFF * (allowed + rounding)
            })
        });
        *astray = match (follows, is_astray) {
            (true, true) => *astray + 1,
            (true, false) => 0,
            (false, _) => *astray,
        };
        follows
    }
}

impl<S: Real, T: TaylorSeries<S>> Stepper<S> for TaylorStepper<S, T> {
    fn reach(&mut self, tau: S, before: &[S], meter: &BudgetedRhs<S>) -> Option<f64> {
        if self.expanded_at != Some(tau) {
            (self.expanded_at, self.direction) = (Some(tau), meter.direction);
            let allowed = meter.charge(self.method.order as u64);
            self.reach = if allowed { self.method.reach(meter.time(tau), before) } else { f64::NAN };
        }
        (!self.reach.is_nan()).then_some(self.reach)
    }

    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        if self.reach(tau, before, meter).is_none() {
            let cause = self.method.beyond();
            if cause == Cause::Error && self.method.source.has_branches() {
                let departure =
                    self.departure.get_or_insert_with(|| Departure::new(&self.method.tolerance, before.len()));
                self.departed = true;
                return departure.attempt(tau, before, step, after, meter);
            }
            return Attempt::Rejected { next: step.approx() / 4.0, cause };
        }
        self.departed = false;
        if self.method.source.has_branches() && !self.follows((tau, step), meter) {
            // the series is reused over a shorter step
            self.reach = step.approx() / 4.0;
            return Attempt::Rejected { next: self.reach, cause: Cause::Error };
        }
        if self.astray > MOST_ASTRAY {
            self.reach = 0.0;
            return Attempt::Rejected { next: 0.0, cause: Cause::Undefined };
        }
        self.method.source.sum(step * self.direction, after);
        Attempt::Accepted { next: self.reach }
    }

    fn reads_between(&self) -> bool {
        true
    }

    fn between(&self, passed: S, state: &mut [S]) {
        match &self.departure {
            Some(departure) if self.departed => departure.between(passed, state),
            _ => self.method.source.sum(passed * self.direction, state),
        }
    }
}
