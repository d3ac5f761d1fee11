//! Where nothing is solved for: all orders of a small series, the work of each in registers.
//!
//!   f(y)_k = c_k + L y_k + W m_k ,    m_k = a_0 b_k + .. + a_k b_0 for each product a b ,
//!
//! with c_k = 0 but for c_0 = c. Of m_k only the two ends wait for y_k.

use super::factors::{CHAINS, Chains, Factors, MOST_ORDER, Places, reciprocals};
use super::law::Law;
use super::round::rounded;
use super::starts::Starts;
use super::wide_sums::WideSums;
use crate::recurrence::fused::{Fused, Task};
use crate::recurrence::pick::Pick;
use crate::recurrence::stored::Stored;
use std::ops::Range;

/// A law, with the quantities in B groups of eight and the products in G.
#[derive(Clone, Debug)]
pub struct Direct<S: Fused, const B: usize, const G: usize> {
    law: Law,
    starts: Starts<S, B>,
    places: Places<G>,
    orders: Orders<S, B, G>,
    /// Of a finer field: the orders for which the digits of `f64` do.
    rounded: Option<Orders<f64, B, G>>,
}

#[derive(Clone, Debug)]
struct Orders<S: Fused, const B: usize, const G: usize> {
    rates: WideSums<S, B, G>,
    factors: Factors<S, G>,
    reciprocals: [S; MOST_ORDER + 1],
}

/// Between two orders: y_k, what f(y)_k begins with, the factors of order 0, and what is known of the next products. While an
/// order is summed the factors of order 0 are known, and they count in it as soon as they are.
#[derive(Clone, Copy)]
struct Between<E, const B: usize, const G: usize> {
    newest: [E; B],
    start: [E; B],
    oldest: [[E; G]; 2],
    ahead: Chains<E, G>,
}

impl<S: Fused, const B: usize, const G: usize> Direct<S, B, G> {
    pub(super) fn new(law: &Law) -> Self {
        Direct {
            law: law.clone(),
            starts: Starts::new(law),
            places: Places::new(law),
            orders: Orders::new(law),
            rounded: S::FINER.then(|| Orders::new(law)),
        }
    }

    pub(super) fn set(&mut self, values: &[S]) {
        let value = |number: u32| values.get(number as usize).copied().unwrap_or(S::zero());
        self.starts.set(&self.law, value);
        self.orders.rates.set(&self.law.rates, value);
        if let Some(rounded) = &mut self.rounded {
            rounded.rates.set(&self.law.rates, |number| value(number).rounded());
        }
    }
}

impl<S: Fused, const B: usize, const G: usize> Orders<S, B, G> {
    fn new(law: &Law) -> Self {
        let (rates, factors) = (WideSums::new(&law.rates), Factors::new());
        Orders { rates, factors, reciprocals: reciprocals() }
    }

    /// Finds y_(k+1) for these k, into the rows of the series.
    #[inline(always)]
    fn run<P: Pick<S>, R: From<S>>(
        &mut self,
        pick: P,
        places: &Places<G>,
        orders: Range<usize>,
        between: Between<P::Eight, B, G>,
        rows: &mut [[R; 8]],
    ) -> Between<P::Eight, B, G> {
        let Between { mut newest, mut start, oldest: [mut a_0, mut b_0], mut ahead } = between;
        let later = rows.as_chunks_mut::<B>().0.iter_mut().skip(orders.start + 1);
        for (k, row) in orders.zip(later) {
            let [a, b] = places.pick(pick, &newest);
            let [first, last] = self.factors.older(pick, 1, k, &mut ahead);
            self.factors.keep(pick, k, &[a, b]);
            // at order 0 both ends are one product
            if k == 0 {
                b_0 = b;
            }
            let mut products = first;
            for group in 0..G {
                let first = pick.plus_product(first[group], a_0[group], b[group]);
                let last = pick.plus_product(last[group], a[group], b_0[group]);
                products[group] = pick.plus(first, last);
            }
            if k == 0 {
                a_0 = a;
            }
            let sums = self.rates.of(pick, &start, &newest, &products);
            for group in 0..B {
                start[group] = pick.all(S::zero());
                newest[group] = pick.product(sums[group], pick.all(self.reciprocals[k + 1]));
                let stored = pick.store(newest[group]);
                row[group] = std::array::from_fn(|lane| R::from(stored.lane(lane)));
            }
        }
        Between { newest, start, oldest: [a_0, b_0], ahead }
    }
}

/// Expands the solution whose first coefficients stand at the head of the series.
pub(super) struct Expand<'a, S: Fused, const B: usize, const G: usize> {
    pub law: &'a mut Direct<S, B, G>,
    pub series: &'a mut [S],
    /// From the order after this one on the digits of `f64` do.
    pub fine: usize,
}

impl<S: Fused, const B: usize, const G: usize> Task<S> for Expand<'_, S, B, G> {
    #[inline(always)]
    fn run<P: Pick<S> + Pick<f64>>(self, pick: P) {
        let Expand { law: Direct { starts, places, orders, rounded, .. }, series, fine } = self;
        let (rows, _) = series.as_chunks_mut::<8>();
        let order = (rows.len() / B).saturating_sub(1).min(MOST_ORDER);
        let fine = if S::FINER { fine.min(order) } else { order };
        let nothing = Pick::<S>::all(pick, S::zero());
        let newest = starts.begin(pick, rows);
        let between = Between {
            newest,
            start: orders.rates.constants(pick),
            oldest: [[nothing; G]; 2],
            ahead: [[nothing; G]; CHAINS],
        };
        let between = orders.run(pick, places, 0..fine, between, rows);
        if S::FINER
            && fine < order
            && let Some(rounded) = rounded
        {
            rounded.factors.take(&orders.factors, fine);
            let between = between.rounded::<S, P>(pick);
            rounded.run(pick, places, fine..order, between, rows);
        }
    }
}

impl<E: Copy, const B: usize, const G: usize> Between<E, B, G> {
    #[inline(always)]
    fn rounded<S: Fused, P: Pick<S, Eight = E> + Pick<f64>>(&self, pick: P) -> Between<<P as Pick<f64>>::Eight, B, G> {
        let ([a_0, b_0], [one, other]) = (&self.oldest, &self.ahead);
        Between {
            newest: rounded::<S, P, B>(pick, &self.newest),
            start: rounded::<S, P, B>(pick, &self.start),
            oldest: [rounded::<S, P, G>(pick, a_0), rounded::<S, P, G>(pick, b_0)],
            ahead: [rounded::<S, P, G>(pick, one), rounded::<S, P, G>(pick, other)],
        }
    }
}
