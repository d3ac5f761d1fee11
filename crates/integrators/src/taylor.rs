//! The Taylor method: as many terms as the tolerance is worth, the step read off the last two.
//!
//! y(t + h) = sum_k a_k h^k up to an order p that grows with the logarithm of the tolerance, with the step that makes
//! the last two terms just as large as the tolerance allows (Jorba and Zou 2005). The polynomial is the dense output: an
//! output costs one Horner scheme and no step.

use crate::drive::{Attempt, Cause, Stepper};
use crate::meter::Meter;
use crate::{Absolute, Failure, Real, Refusal, Tolerance};
use field::Scalar;

/// A source of Taylor coefficients: the recurrences of a system's expression graph.
pub trait TaylorSeries<S: Scalar> {
    /// Expands the solution through (t, y) up to an order.
    fn expand(&mut self, t: S, y: &[S], order: usize);

    /// Of the last expansion the coefficients of order k, that is the k-th derivatives over k!, for k up to its order.
    fn coefficients(&self, k: usize) -> &[S];

    /// The sum of the last expansion at h.
    fn sum(&self, h: S, out: &mut [S]);
}

impl<S: Scalar, T: TaylorSeries<S> + ?Sized> TaylorSeries<S> for Box<T> {
    fn expand(&mut self, t: S, y: &[S], order: usize) {
        (**self).expand(t, y, order);
    }

    fn coefficients(&self, k: usize) -> &[S] {
        (**self).coefficients(k)
    }

    fn sum(&self, h: S, out: &mut [S]) {
        (**self).sum(h, out);
    }
}

/// The order for a tolerance, within what rounding leaves of it.
///
/// The step goes as tolerance^(1/p), so with L = -ln(tolerance) the cheapest p for steps that cost b + p + c p^2 has
///
///   p^2 (1 + 2 c p) = L (b + p + c p^2) .
///
/// In `f64` what a step costs beside its orders is worth about five of them, and eight terms of a product cost as much as
/// one: b = 5, c = 0.015, and p = 4 + 0.8 L is near to that for all L from 7 to 33. But never below 16: where a decay and not
/// the tolerance bounds the step, that of a series grows with its order. Measured on eight scenes of motors at an error of 1e-3, order 16
/// takes 0.8 to 1.05 of the time of order 10; mechanisms were not timed. A tolerance below the rounding of `f64` is for
/// double-double, where the products are all that counts, and p = L / 2.
pub fn taylor_order(tolerance: f64) -> usize {
    let order = if tolerance < f64::EPSILON { 1.0 - 0.5 * tolerance.ln() } else { 4.0 - 0.8 * tolerance.ln() };
    (order.ceil() as usize).clamp(16, 60)
}

/// How far a series of order p reaches whose last two coefficients have these sizes, in units of what is allowed.
#[inline]
pub(crate) fn reach(order: usize, last: f64, one_before: f64) -> f64 {
    let p = order as f64;
    if last.max(one_before) < f64::MIN_POSITIVE {
        return f64::INFINITY;
    }
    power_of_two(-(logarithm(last) * (1.0 / p)).max(logarithm(one_before) * (1.0 / (p - 1.0))))
}

/// log2 of a number that is not negative, to 3e-6: a step need not be known better, and steps are short enough for the
/// difference to show. Zero counts as the smallest number.
#[inline]
fn logarithm(x: f64) -> f64 {
    const FRACTION: u64 = (1 << 52) - 1;
    let exponent = f64::from((x.to_bits() >> 52) as i32 - 1023);
    let fraction = f64::from_bits((x.to_bits() & FRACTION) | 1.0_f64.to_bits());
    exponent + polynomial(fraction - 1.5, LOGARITHM)
}

/// 2^y, to 2e-6.
#[inline]
fn power_of_two(y: f64) -> f64 {
    let y = y.clamp(-1000.0, 1000.0);
    let whole = y as i32;
    let scale = f64::from_bits(((1023 + whole) as u64) << 52);
    scale * polynomial(y - f64::from(whole), POWER)
}

/// log2(1.5 + x) for |x| < 1/2.
const LOGARITHM: [f64; 8] = [
    0.5849627591044444,
    0.9617965401665365,
    -0.3206318784567618,
    0.1425080240329688,
    -0.07059455402256631,
    0.03761046428219572,
    -0.0251101409525063,
    0.014440352491874364,
];
/// 2^x for |x| < 1.
const POWER: [f64; 8] = [
    0.9999999895646148,
    0.693147179757808,
    0.2402268408359096,
    0.05550413432974688,
    0.009616461222384132,
    0.0013332275843138675,
    0.00015669788598415835,
    1.545752248688359e-05,
];

/// sum c_k x^k, by halves that do not wait for each other.
#[inline]
fn polynomial(x: f64, [a, b, c, d, e, f, g, h]: [f64; 8]) -> f64 {
    let square = x * x;
    let (low, high) = ((a + b * x) + (c + d * x) * square, (e + f * x) + (g + h * x) * square);
    low + high * (square * square)
}

/// The Taylor method on one system, to be used for as many runs as one likes: a run allocates nothing.
#[derive(Clone, Debug)]
pub struct Taylor<T> {
    source: T,
    tolerance: Tolerance,
    order: usize,
}

impl<T> Taylor<T> {
    /// With the order that suits the tolerance.
    pub fn new(source: T, tolerance: &Tolerance) -> Self {
        let order = taylor_order(tolerance.relative);
        Taylor { source, tolerance: tolerance.clone(), order }
    }

    /// The order of the last term.
    pub fn order(&self) -> usize {
        self.order
    }

    /// The same with another order.
    pub fn with_order(mut self, order: usize) -> Self {
        self.order = order.max(2);
        self
    }

    /// The longest step that the series through (t, y) allows; not a number where the series is undefined.
    ///
    /// With s_k the largest coefficient of order k in units of what is allowed: the smaller one of s_k^(-1/k), k = p - 1, p.
    #[inline]
    fn reach<S: Real>(&mut self, time: S, y: &[S]) -> f64
    where
        T: TaylorSeries<S>,
    {
        self.source.expand(time, y, self.order);
        let (last, one_before) = (self.source.coefficients(self.order), self.source.coefficients(self.order - 1));
        let (mut s_last, mut s_before, mut sum) = (0.0_f64, 0.0_f64, 0.0);
        let mut compare = |absolute: f64, y: S, last: S, before: S| {
            let share = 1.0 / (absolute + self.tolerance.relative * y.approx().abs());
            let (a, b) = (last.approx().abs() * share, before.approx().abs() * share);
            // `max` forgets what is not a number, a sum does not
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

    /// Why the last expansion has terms that are no numbers: where the rates are some, those of high order are beyond them because a
    /// singularity is nearer than any step.
    fn beyond<S: Real>(&self) -> Cause
    where
        T: TaylorSeries<S>,
    {
        let rates = self.source.coefficients(1);
        if rates.iter().all(|rate| rate.finite()) { Cause::Error } else { Cause::Undefined }
    }

    /// Carries the state from one time to another, forwards or backwards, and returns the number of steps.
    ///
    /// # Errors
    /// [`Failure`] says why the run ended, and `state` holds where.
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

/// One run of the method as the loop around the steps sees it.
pub(crate) struct TaylorStepper<S, T> {
    method: Taylor<T>,
    /// Where the series at hand begins, and how far it reaches.
    expanded_at: Option<S>,
    reach: f64,
    direction: S,
}

impl<S: Real, T: TaylorSeries<S>> TaylorStepper<S, T> {
    pub fn new(source: T, tolerance: &Tolerance) -> Self {
        TaylorStepper { method: Taylor::new(source, tolerance), expanded_at: None, reach: 0.0, direction: S::one() }
    }
}

impl<S: Real, T: TaylorSeries<S>> Stepper<S> for TaylorStepper<S, T> {
    fn reach(&mut self, tau: S, before: &[S], meter: &Meter<S>) -> Option<f64> {
        if self.expanded_at != Some(tau) {
            (self.expanded_at, self.direction) = (Some(tau), meter.direction);
            let allowed = meter.charge(self.method.order as u64);
            self.reach = if allowed { self.method.reach(meter.time(tau), before) } else { f64::NAN };
        }
        (!self.reach.is_nan()).then_some(self.reach)
    }

    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &Meter<S>) -> Attempt {
        if self.reach(tau, before, meter).is_none() {
            return Attempt::Rejected { next: step.approx() / 4.0, cause: self.method.beyond() };
        }
        self.method.source.sum(step * self.direction, after);
        Attempt::Accepted { next: self.reach }
    }

    fn reads_between(&self) -> bool {
        true
    }

    fn between(&self, passed: S, state: &mut [S]) {
        self.method.source.sum(passed * self.direction, state);
    }
}
