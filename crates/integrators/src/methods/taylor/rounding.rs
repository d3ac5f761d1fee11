//! The number of orders of a series in a finer field that need all of its digits.
//!
//! The term of order k is of the size of the tolerance^(k/p): high orders need a few digits only, fewer than `f64` has. With d the
//! relative error of a rounded term, all digits are needed by those orders for which
//!
//! d |a_k| h^k > the error allowed in a step.
//!
//! The law decides how large d is: products that cancel may be a thousand times as large as their sum. Therefore d is measured,
//! with terms that were found with more orders in full: at the first step, after some steps, and wherever steps or terms are no
//! longer of the size that they had there. At the knees of diodes that is every few steps.

use super::{Taylor, TaylorSeries};
use crate::Real;

/// The least relative error: a term's own rounding, and that of some terms from which it comes.
const LEAST: f64 = 8.0 * f64::EPSILON;

/// Safety factor of a measured error, and the share of the error before it below which the new one does not fall.
const TIMES: f64 = 16.0;
const KEPT: f64 = 0.5;

/// The number of steps for which a measurement holds, and the largest ratios for them: of longer and of shorter steps, and of
/// sizes of terms. Terms of high order are rounded more, for they come from more terms, and count the less the shorter a step is.
const STEPS: u32 = 32;
const LONGER: f64 = 2.0;
const SHORTER: f64 = 4.0;
const LARGER: f64 = 10.0;

/// A measurement holds for orders in full that differ by at most this number: where products cancel, d may double from one
/// order to the next.
const NEAR: usize = 2;

/// Orders that are in full beyond the last one where rounding is measured, and orders beyond it whose terms are
/// examined elsewhere.
const MORE: usize = 4;
const WEIGHED: usize = 8;

/// The orders in full are chosen for this part of the allowed error of a step, and a step is accepted with all of it: the
/// next may need one more.
const CHOSEN: f64 = 0.25;

/// The rounding error of terms, as measured along the steps so far.
#[derive(Clone, Debug)]
pub(super) struct Rounding {
    /// The last order in full.
    fine: usize,
    /// The relative rounding error of a term.
    error: f64,
    measured: Measured,
    /// For each component 1 over its allowed error.
    shares: Vec<f64>,
    /// The sizes of the terms of the first orders, from 1 on, at the end of the step, in units of the allowed error.
    sizes: Vec<f64>,
    /// Room for terms to compare with.
    terms: Vec<f64>,
}

/// The step at which rounding was measured last.
#[derive(Clone, Debug)]
struct Measured {
    reach: f64,
    /// The last order in full there, and the largest term after it.
    fine: usize,
    largest: f64,
    /// The number of steps for which it still holds.
    rest: u32,
}

impl Rounding {
    /// The estimate before any measurement: the term of order k is of the size of the tolerance^(k/p).
    pub fn new(order: usize, tolerance: f64) -> Self {
        let fine = 2 + (order as f64 * (1.0 - LEAST.ln() / tolerance.ln()).clamp(0.0, 1.0)) as usize;
        let measured = Measured { reach: 0.0, fine, largest: 0.0, rest: 0 };
        Rounding { fine, error: LEAST, measured, shares: Vec::new(), sizes: Vec::new(), terms: Vec::new() }
    }

    /// The last order whose term would be rounded by more than so many times the allowed error.
    fn last_beyond(&self, times: f64) -> usize {
        self.sizes.iter().rposition(|size| size * self.error > times).map_or(0, |index| index + 1)
    }

    fn largest_after(&self, fine: usize) -> f64 {
        largest(self.sizes.iter().skip(fine).copied())
    }

    /// Whether a step of this length, with so many orders in full, is like the measured one.
    fn is_known(&self, reach: f64, in_full: usize) -> bool {
        let Measured { reach: there, fine, largest, rest } = self.measured;
        let term = self.largest_after(fine);
        let is_alike = there <= SHORTER * reach && reach <= LONGER * there;
        rest > 0 && in_full.abs_diff(fine) <= NEAR && is_alike && largest <= LARGER * term && term <= LARGER * largest
    }
}

impl<T> Taylor<T> {
    /// The longest step that the series through (t, y) allows, with as many orders in full as it needs.
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

    /// Computes the sizes of the terms up to this order at the time h.
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

    /// Finds the series with more orders in full, and the rounding error of the others before. Returns the number of full
    /// orders.
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

/// The largest magnitude; NaN is ignored.
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
