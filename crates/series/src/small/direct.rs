//! All orders of a small series by direct evaluation of the law, with the data of each order in registers.
//!
//!   f(y)_k = c_k + L y_k + W m_k ,    m_k = a_0 b_k + .. + a_k b_0 for each product a b ,
//!
//! with c_k = 0 except c_0 = c. Only the two terms of m_k with a_k and b_k have to wait for y_k.

use super::factors::{CHAINS, Chains, Factors, MOST_ORDER, Places, reciprocals};
use super::law::Law;
use super::round::rounded;
use super::solving::Solving;
use super::wide_sums::WideSums;
use crate::fused::Fused;
use crate::pick::Pick;
use crate::small::permutation::Permute;
use crate::stored::Stored;
use std::ops::Range;

/// A law with the quantities in B groups of eight and the products in G.
#[derive(Clone, Debug)]
pub(super) struct Direct<S: Fused, const B: usize, const G: usize> {
    rates: WideSums<S, B, G>,
    pub factors: Factors<S, G>,
    reciprocals: [S; MOST_ORDER + 1],
}

/// The intermediate results between two orders: y_k, the first terms of f(y)_k, the factors of order 0, and the known
/// part of the next products.
#[derive(Clone, Copy)]
pub(super) struct Between<E, const B: usize, const G: usize> {
    pub newest: [E; B],
    start: [E; B],
    oldest: [[E; G]; 2],
    ahead: Chains<E, G>,
}

impl<S: Fused, const B: usize, const G: usize> Direct<S, B, G> {
    pub fn new(law: &Law) -> Self {
        Direct { rates: WideSums::new(&law.rates), factors: Factors::new(), reciprocals: reciprocals() }
    }

    pub fn set(&mut self, law: &Law, value: impl Fn(u32) -> S) {
        self.rates.set(&law.rates, value);
    }

    /// The state before order 0 of the rates.
    #[inline(always)]
    pub fn begin<P: Permute<S>>(&self, pick: P, newest: [P::Eight; B]) -> Between<P::Eight, B, G> {
        let nothing = [pick.all(S::zero()); G];
        Between { newest, start: self.rates.constants(pick), oldest: [nothing; 2], ahead: [nothing; CHAINS] }
    }

    /// Computes y_(k+1) for these k and writes them into the rows of the series, with the solved quantities.
    #[inline(always)]
    pub fn run<P: Permute<S>, R: From<S>>(
        &mut self,
        pick: P,
        places: &Places<G>,
        solving: Option<&Solving<S, B, G>>,
        orders: Range<usize>,
        between: Between<P::Eight, B, G>,
        rows: &mut [[R; 8]],
    ) -> Between<P::Eight, B, G> {
        let Between { mut newest, mut start, oldest: [mut a_0, mut b_0], mut ahead } = between;
        let later = rows.as_chunks_mut::<B>().0.iter_mut().skip(orders.start + 1);
        for (k, row) in orders.zip(later) {
            let [first, last] = self.factors.older(pick, 1, k, &mut ahead);
            if let Some(solving) = solving
                && k > 0
            {
                let mut middle = first;
                for group in 0..G {
                    middle[group] = pick.plus(first[group], last[group]);
                }
                newest = solving.next(pick, &newest, &middle);
            }
            let [a, b] = places.pick(pick, &newest);
            self.factors.keep(pick, k, &[a, b]);
            // at order 0 both terms coincide
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

impl<E: Copy, const B: usize, const G: usize> Between<E, B, G> {
    #[inline(always)]
    pub fn rounded<S: Fused, P: Permute<S, Eight = E> + Permute<f64>>(
        &self,
        pick: P,
    ) -> Between<<P as Pick<f64>>::Eight, B, G> {
        let ([a_0, b_0], [one, other]) = (&self.oldest, &self.ahead);
        Between {
            newest: rounded::<S, P, B>(pick, &self.newest),
            start: rounded::<S, P, B>(pick, &self.start),
            oldest: [rounded::<S, P, G>(pick, a_0), rounded::<S, P, G>(pick, b_0)],
            ahead: [rounded::<S, P, G>(pick, one), rounded::<S, P, G>(pick, other)],
        }
    }
}
