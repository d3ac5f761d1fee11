//! How many orders of a series in a finer field need all of its digits.
//!
//! The term of order k is of the size of the tolerance^(k/p): of high orders a few digits are enough, and those of `f64` more than
//! enough. With d the relative error of a term that is rounded, those orders need all digits for which
//!
//!   d |a_k| h^k > what is allowed of a step.
//!
//! What d is the law decides: products that cancel may be a thousand times as large as what is left of them. So it is
//! measured, by terms that were found with more orders in full, at the first step and now and then. Where it changes faster, at
//! the knees of diodes, rounding shows: four digits at a tolerance of 1e-21.

use super::{Taylor, TaylorSeries};
use crate::Real;

/// The least relative error that is reckoned with: a term's own rounding, and that of some terms it comes from.
const LEAST: f64 = 16.0 * f64::EPSILON;

/// What is measured at one step stands for so many, if it is taken so many times.
const STEPS: u32 = 32;
const TIMES: f64 = 4.0;

/// So many orders more are in full where it is measured.
const MORE: usize = 4;

/// What the steps so far tell of rounding.
#[derive(Clone, Debug)]
pub(super) struct Rounding {
    /// The last order in full.
    fine: usize,
    /// Relative, of a term.
    error: f64,
    /// Steps until it is measured again.
    rest: u32,
    /// For each component 1 over what is allowed of it.
    shares: Vec<f64>,
    /// Room for terms to compare with.
    terms: Vec<f64>,
}

impl Rounding {
    /// As if the term of order k were of the size of the tolerance^(k/p).
    pub fn new(order: usize, tolerance: f64) -> Self {
        let fine = 2 + (order as f64 * (1.0 - LEAST.ln() / tolerance.ln()).clamp(0.0, 1.0)) as usize;
        Rounding { fine, error: LEAST, rest: 0, shares: Vec::new(), terms: Vec::new() }
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
            let mut needed = self.last_in_full(y, reach);
            let is_known = self.rounding.rest > 0;
            if needed <= fine && !is_known {
                self.measure(time, y, reach, fine);
                needed = self.last_in_full(y, reach);
            }
            self.rounding.fine = needed + 1;
            if needed <= fine {
                self.rounding.rest = if is_known { self.rounding.rest - 1 } else { STEPS };
                return reach;
            }
        }
    }

    /// The last order whose term, h on, may not be rounded.
    fn last_in_full<S: Real>(&mut self, y: &[S], h: f64) -> usize
    where
        T: TaylorSeries<S>,
    {
        let Rounding { shares, error, .. } = &mut self.rounding;
        shares.clear();
        shares.extend(y.iter().enumerate().map(|(i, y)| 1.0 / self.tolerance.allowed(i, y.approx().abs())));
        let (mut power, mut last) = (*error, 0);
        for k in 1..=self.order {
            power *= h;
            let size = largest(self.source.coefficients(k).iter().zip(&*shares).map(|(c, share)| c.approx() * share));
            last = if size * power > 1.0 { k } else { last };
        }
        last
    }

    /// Finds the series with more orders in full, and what rounding made of the others before.
    fn measure<S: Real>(&mut self, time: S, y: &[S], h: f64, fine: usize)
    where
        T: TaylorSeries<S>,
    {
        let Taylor { source, order, rounding: Rounding { error, shares, terms, .. }, .. } = self;
        let rounded = fine + 1..=*order;
        terms.clear();
        rounded.clone().for_each(|k| terms.extend(source.coefficients(k).iter().map(|c| c.approx())));
        source.expand_rounding(time, y, *order, fine + MORE);
        let (mut power, mut wrong, mut whole) = (h.powi(fine as i32), 0.0, 0.0);
        for (k, before) in rounded.zip(terms.chunks(y.len().max(1))) {
            power *= h;
            let now = source.coefficients(k).iter().map(|c| c.approx());
            let off = now.clone().zip(before).zip(&*shares).map(|((now, before), share)| (now - before) * share);
            wrong += power * largest(off);
            whole += power * largest(now.zip(&*shares).map(|(now, share)| now * share));
        }
        let found = TIMES * wrong / whole;
        *error = if found > LEAST { found } else { LEAST };
    }
}

/// The largest magnitude; what is not a number is none.
fn largest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, |most, x| if x.abs() > most { x.abs() } else { most })
}
