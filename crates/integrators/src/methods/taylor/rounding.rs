//! The number of orders of a Taylor series in double-double that need all digits; higher orders are computed in `f64`.
//!
//! The term of order k is of the size tolerance^(k/p): high orders need few digits only. If d is the relative error of
//! a term computed in `f64`, all digits are needed for those orders with
//!
//!   d |a_k| h^k > allowed error of a step.
//!
//! The law determines d: products that cancel may be a thousand times as large as their sum. Therefore d is measured by
//! comparison with a series with more orders in full precision: at the first step, then regularly, and whenever the
//! step size or the sizes of the terms have changed. At the knees of diode characteristics this is needed every few
//! steps.

use super::{Taylor, TaylorSeries};
use crate::Real;

/// The smallest assumed relative error of a term: its own rounding and that of the terms it is computed from.
const LEAST: f64 = 8.0 * f64::EPSILON;

/// Safety factor of a measured error, and the largest factor by which the estimate may decrease at once.
const TIMES: f64 = 16.0;
const KEPT: f64 = 0.5;

/// The number of steps for which a measurement is valid, and the largest changes of the step size (up and down) and of
/// the terms. Terms of high order have larger rounding errors, but shorter steps reduce their weight.
const STEPS: u32 = 32;
const LONGER: f64 = 2.0;
const SHORTER: f64 = 4.0;
const LARGER: f64 = 10.0;

/// A measurement is valid for numbers of full orders that differ by at most this number: where products cancel, d may
/// double from one order to the next.
const NEAR: usize = 2;

/// The number of further full orders in a measurement, and the number of further orders whose terms are checked between
/// measurements.
const MORE: usize = 4;
const WEIGHED: usize = 8;

/// The full orders are chosen for this fraction of the allowed error, and steps are accepted up to the whole of it: one
/// more order may be needed in the next step.
const CHOSEN: f64 = 0.25;

/// Estimate of the rounding error of the terms.
#[derive(Clone, Debug)]
pub(super) struct Rounding {
    /// The highest order in full precision.
    fine: usize,
    /// The relative rounding error d of a term.
    error: f64,
    measured: Measured,
    /// The reciprocal of the allowed error of each component.
    shares: Vec<f64>,
    /// The sizes of the terms at the end of the step in units of the allowed error, from order 1 on.
    sizes: Vec<f64>,
    /// Buffer for terms to compare with.
    terms: Vec<f64>,
}

/// The step with the last measurement.
#[derive(Clone, Debug)]
struct Measured {
    reach: f64,
    /// The highest full order there, and the largest term above it.
    fine: usize,
    largest: f64,
    /// The remaining number of steps for which it is valid.
    rest: u32,
}

impl Rounding {
    /// The estimate before the first measurement: the term of order k is of the size tolerance^(k/p).
    pub fn new(order: usize, tolerance: f64) -> Self {
        let fine = 2 + (order as f64 * (1.0 - LEAST.ln() / tolerance.ln()).clamp(0.0, 1.0)) as usize;
        let measured = Measured { reach: 0.0, fine, largest: 0.0, rest: 0 };
        Rounding { fine, error: LEAST, measured, shares: Vec::new(), sizes: Vec::new(), terms: Vec::new() }
    }

    /// The highest order whose term has a rounding error above `times` the allowed error.
    fn last_beyond(&self, times: f64) -> usize {
        self.sizes.iter().rposition(|size| size * self.error > times).map_or(0, |index| index + 1)
    }

    fn largest_after(&self, fine: usize) -> f64 {
        largest(self.sizes.iter().skip(fine).copied())
    }

    /// Whether the last measurement is valid for a step of this length with `in_full` full orders.
    fn is_known(&self, reach: f64, in_full: usize) -> bool {
        let Measured { reach: there, fine, largest, rest } = self.measured;
        let term = self.largest_after(fine);
        let is_alike = there <= SHORTER * reach && reach <= LONGER * there;
        rest > 0 && in_full.abs_diff(fine) <= NEAR && is_alike && largest <= LARGER * term && term <= LARGER * largest
    }
}

impl<T> Taylor<T> {
    /// The largest step size for the series through (t, y), with as many full orders as needed.
    pub(super) fn reach_rounding<S: Real>(&mut self, time: S, y: &[S]) -> f64
    where
        T: TaylorSeries<S>,
    {
        loop {
            let fine = self.source.expand_rounding(time, y, self.order, self.rounding.fine);
            let reach = self.allowed(y);
            if fine >= self.order || reach.is_nan() {
                return reach;
            }
            self.weigh(y, reach, fine + WEIGHED);
            let mut is_enough = self.rounding.last_beyond(1.0) <= fine;
            if is_enough && !self.rounding.is_known(reach, fine) {
                let fine = self.measure(time, y, reach, fine);
                is_enough = self.rounding.last_beyond(CHOSEN) <= fine;
            }
            self.rounding.fine = self.rounding.last_beyond(CHOSEN).max(1);
            if is_enough {
                self.rounding.measured.rest = self.rounding.measured.rest.saturating_sub(1);
                return reach;
            }
        }
    }

    /// Computes the sizes of the terms up to order `last` at the time h.
    fn weigh<S: Real>(&mut self, y: &[S], h: f64, last: usize)
    where
        T: TaylorSeries<S>,
    {
        let Taylor { source, tolerance, order, rounding: Rounding { shares, sizes, .. }, .. } = self;
        shares.clear();
        shares.extend(y.iter().enumerate().map(|(i, y)| 1.0 / tolerance.allowed(i, y.approx().abs())));
        let mut power = 1.0;
        sizes.clear();
        sizes.extend((1..=last.min(*order)).map(|k| {
            power *= h;
            power * largest(source.coefficients(k).iter().zip(&*shares).map(|(c, share)| c.approx() * share))
        }));
    }

    /// Computes the series with more full orders, and from it the rounding error of the previous ones. Returns the
    /// number of full orders.
    fn measure<S: Real>(&mut self, time: S, y: &[S], h: f64, fine: usize) -> usize
    where
        T: TaylorSeries<S>,
    {
        self.weigh(y, h, self.order);
        let Taylor { source, order, rounding, .. } = self;
        rounding.measured = Measured { reach: h, fine, largest: rounding.largest_after(fine), rest: STEPS };
        let Rounding { error, shares, sizes, terms, .. } = rounding;
        let rounded = fine + 1..=*order;
        terms.clear();
        rounded.clone().for_each(|k| terms.extend(source.coefficients(k).iter().map(|c| c.approx())));
        let now_fine = source.expand_rounding(time, y, *order, fine + MORE);
        let (mut power, mut wrong) = (h.powi(fine as i32), 0.0);
        for (k, before) in rounded.zip(terms.chunks(y.len().max(1))) {
            power *= h;
            let now = source.coefficients(k).iter().map(|c| c.approx());
            let off = now.zip(before).zip(&*shares).map(|((now, before), share)| (now - before) * share);
            wrong += power * largest(off);
        }
        let found = TIMES * wrong / sizes[fine..].iter().sum::<f64>();
        *error = [found, KEPT * *error].into_iter().fold(LEAST, f64::max);
        now_fine
    }
}

/// The largest magnitude, without NaN.
fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |most, x| if x.abs() > most { x.abs() } else { most })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_measured_stands_for_steps_and_terms_of_its_size() {
        let mut rounding = Rounding::new(20, 1e-20);
        rounding.measured = Measured { reach: 1.0, fine: 1, largest: 1.0, rest: STEPS };
        let mut is_known = |reach, term, in_full, rest| {
            rounding.sizes = vec![1e9, term, 0.5 * term];
            rounding.measured.rest = rest;
            rounding.is_known(reach, in_full)
        };
        assert!(is_known(1.9, 9.0, 1 + NEAR, 1) && is_known(0.3, 0.2, 1, 1));
        assert!(!is_known(2.1, 1.0, 1, 1) && !is_known(0.2, 1.0, 1, 1), "steps of another length");
        assert!(!is_known(1.0, 11.0, 1, 1) && !is_known(1.0, 0.09, 1, 1), "terms of another size");
        assert!(!is_known(1.0, 1.0, 2 + NEAR, 1), "many more orders in full");
        assert!(!is_known(1.0, 1.0, 1, 0), "steps that are long past");
    }
}
