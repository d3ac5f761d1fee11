//! The Taylor method: as many terms as the tolerance is worth, the step read off the last two.
//!
//! y(t + h) = sum_k a_k h^k up to order p = ceil(1 - ln(tolerance) / 2), which is the cheapest for a cost that grows as
//! p^2, with the step that makes the last two terms just as large as the tolerance allows (Jorba and Zou 2005). The
//! polynomial is the dense output: an output costs one Horner scheme and no step.

use crate::drive::{Attempt, Cause, Stepper};
use crate::meter::Meter;
use crate::{Real, Tolerance};

/// A source of Taylor coefficients: the recurrences of a system's expression graph.
pub trait TaylorSeries<S> {
    /// The coefficients of the solution through (t, y) up to an order: `out[k * n + i]` is a_k of component i, that is
    /// the k-th derivative over k!, for k = 0 ..= order; n is the length of y.
    fn coefficients(&mut self, t: S, y: &[S], order: usize, out: &mut [S]);
}

/// The order for a tolerance, within what rounding leaves of it.
pub(crate) fn order(tolerance: f64) -> usize {
    ((1.0 - 0.5 * tolerance.ln()).ceil() as usize).clamp(4, 60)
}

pub(crate) struct Taylor<'a, S> {
    source: Box<dyn TaylorSeries<S> + 'a>,
    tolerance: Tolerance,
    order: usize,
    dimension: usize,
    /// The polynomial of the last accepted step, and the one that starts at its end.
    past: Vec<S>,
    coming: Vec<S>,
    coming_at: Option<S>,
    /// The longest step that the coming polynomial allows.
    reach: f64,
}

impl<'a, S: Real> Taylor<'a, S> {
    pub fn new(source: Box<dyn TaylorSeries<S> + 'a>, tolerance: &Tolerance, dimension: usize) -> Self {
        let order = order(tolerance.relative);
        let zeros = || vec![S::zero(); (order + 1) * dimension];
        let tolerance = tolerance.clone();
        let (past, coming) = (zeros(), zeros());
        Taylor { source, tolerance, order, dimension, past, coming, coming_at: None, reach: 0.0 }
    }

    /// The polynomial at (tau, y), and the step that it allows.
    pub fn look_ahead(&mut self, tau: S, y: &[S], meter: &Meter<S>) -> f64 {
        self.coming_at = Some(tau);
        self.reach = f64::NAN;
        if !meter.charge(self.order as u64) {
            return self.reach;
        }
        self.source.coefficients(meter.time(tau), y, self.order, &mut self.coming);
        if meter.direction < S::zero() {
            let n = self.dimension;
            self.coming.chunks_mut(n).skip(1).step_by(2).flatten().for_each(|a| *a = -*a);
        }
        let term = |k: usize| {
            let a = &self.coming[k * self.dimension..][..self.dimension];
            self.tolerance.norm(y, y, |i| a[i].approx()).powf(-1.0 / k as f64)
        };
        let (last, one_before) = (term(self.order), term(self.order - 1));
        let defined = self.coming.iter().all(|a| a.finite()) && !last.is_nan() && !one_before.is_nan();
        self.reach = if defined { last.min(one_before) } else { f64::NAN };
        self.reach
    }
}

/// The polynomial at h after its beginning, by Horner's scheme.
fn evaluate<S: Real>(coefficients: &[S], h: S, out: &mut [S]) {
    let n = out.len();
    out.fill(S::zero());
    for row in coefficients.chunks(n).rev() {
        for (sum, a) in out.iter_mut().zip(row) {
            *sum = *sum * h + *a;
        }
    }
}

impl<S: Real> Stepper<S> for Taylor<'_, S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &Meter<S>) -> Attempt {
        if self.coming_at != Some(tau) {
            self.look_ahead(tau, before, meter);
        }
        if self.reach.is_nan() {
            return Attempt::Rejected { next: step.approx() / 4.0, cause: Cause::Undefined };
        }
        if step.approx() > self.reach * 1.001 {
            return Attempt::Rejected { next: self.reach, cause: Cause::Error };
        }
        evaluate(&self.coming, step, after);
        std::mem::swap(&mut self.past, &mut self.coming);
        let next = self.look_ahead(tau + step, after, meter);
        Attempt::Accepted { next: if next.is_nan() { step.approx() } else { next } }
    }

    fn reads_between(&self) -> bool {
        true
    }

    fn between(&self, passed: S, state: &mut [S]) {
        evaluate(&self.past, passed, state);
    }
}
