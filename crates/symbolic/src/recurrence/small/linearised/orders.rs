//! All orders of a small series after the first, the work of each in registers.
//!
//! For k > 0
//!
//!   f(y)_k = J y_k + W m_k ,    m_k = a_1 b_(k-1) + .. + a_(k-1) b_1 for each product a b ,
//!
//! with J and W the derivatives of f at y_0 by the quantities and by the products, what is solved for put in.

use super::matrix::{Fours, Matrix, times};
use super::pattern::Pattern;
use crate::recurrence::fused::Fused;
use crate::recurrence::pick::Pick;
use crate::recurrence::small::MOST_ORDER;
use crate::recurrence::small::factors::{Chains, Factors, Places, reciprocals};
use crate::recurrence::small::law::Law;
use crate::recurrence::small::round::{round, rounded};
use crate::recurrence::stored::{Stored, Wide};
use std::ops::Range;

/// What is where, whatever the numbers are.
#[derive(Clone, Debug)]
pub(super) struct Shape<const B: usize, const G: usize> {
    pub linear: Fours<B>,
    pub weights: Fours<B>,
    jacobian: Fours<B>,
    gains: Fours<B>,
    pub places: Places<G>,
    /// A bit for each quantity that is solved for.
    is_solved: [u8; B],
}

impl<const B: usize, const G: usize> Shape<B, G> {
    pub fn new(law: &Law, pattern: &Pattern) -> Self {
        let mut is_solved = [0; B];
        (law.moving..law.quantities()).for_each(|quantity| is_solved[quantity / 8] |= 1 << (quantity % 8));
        Shape {
            linear: Fours::new(&pattern.linear),
            weights: Fours::new(&pattern.weights),
            jacobian: Fours::new(&pattern.jacobian),
            gains: Fours::new(&pattern.gains),
            places: Places::new(law),
            is_solved,
        }
    }
}

/// Between two orders: f(y)_(k-1), what is known of f(y)_k without y_k, y_k, and what is known of the next products.
#[derive(Clone, Copy)]
pub(super) struct Between<E, const B: usize, const G: usize> {
    pub sums: [E; B],
    pub rest: [E; B],
    pub newest: [E; B],
    pub ahead: Chains<E, G>,
}

/// The law at the point of an expansion, and the factors so far.
#[derive(Clone, Debug)]
pub(super) struct Orders<S: Fused, const B: usize, const G: usize> {
    /// J and W.
    pub jacobian: Matrix<S, B, B>,
    pub gains: Matrix<S, B, G>,
    pub factors: Factors<S, G>,
    reciprocals: [S; MOST_ORDER + 1],
}

impl<S: Fused, const B: usize, const G: usize> Orders<S, B, G> {
    pub fn new() -> Self {
        let zero = Wide::zero();
        Orders {
            jacobian: [[[zero; B]; 8]; B],
            gains: [[[zero; B]; 8]; G],
            factors: Factors::new(),
            reciprocals: reciprocals(),
        }
    }

    /// Takes a_k and b_k, and sums a_1 b_k + .. + a_k b_1.
    #[inline(always)]
    fn middle<P: Pick<S>>(
        &mut self,
        pick: P,
        k: usize,
        newest: [[P::Eight; G]; 2],
        ahead: &mut Chains<P::Eight, G>,
    ) -> [P::Eight; G] {
        let [mut sums, others] = self.factors.older(pick, 2, k, ahead);
        self.factors.keep(pick, k, &newest);
        let [a, b] = newest;
        for group in 0..G {
            let [oldest_a, oldest_b] = self.factors.at(pick, 1, group);
            let both = pick.plus(sums[group], others[group]);
            sums[group] = pick.plus_product(both, a[group], oldest_b);
            if k > 1 {
                sums[group] = pick.plus_product(sums[group], oldest_a, b[group]);
            }
        }
        sums
    }

    /// Finds y_(k+1) for these k, into the rows of the series.
    #[inline(always)]
    pub fn run<P: Pick<S>, R: From<S>>(
        &mut self,
        pick: P,
        shape: &Shape<B, G>,
        orders: Range<usize>,
        Between { mut sums, mut rest, mut newest, mut ahead }: Between<P::Eight, B, G>,
        rows: &mut [[R; 8]],
    ) -> Between<P::Eight, B, G> {
        for k in orders {
            if k > 0 {
                // y_k = sums / k: the division need not be waited for
                let known = times(pick, &self.jacobian, &sums, &shape.jacobian);
                for block in 0..B {
                    sums[block] = pick.plus_product(rest[block], known[block], pick.all(self.reciprocals[k]));
                    newest[block] = pick.blend(shape.is_solved[block], newest[block], sums[block]);
                }
                let older = self.middle(pick, k, shape.places.pick(pick, &newest), &mut ahead);
                rest = times(pick, &self.gains, &older, &shape.gains);
            }
            for block in 0..B {
                newest[block] = pick.product(sums[block], pick.all(self.reciprocals[k + 1]));
                let stored = pick.store(newest[block]);
                rows[(k + 1) * B + block] = std::array::from_fn(|lane| R::from(stored.lane(lane)));
            }
        }
        Between { sums, rest, newest, ahead }
    }
}

impl<const B: usize, const G: usize> Orders<f64, B, G> {
    /// Takes over from a finer field after so many orders.
    #[inline(always)]
    pub fn take<S: Fused>(&mut self, finer: &Orders<S, B, G>, orders: usize) {
        round(self.jacobian.as_flattened_mut(), finer.jacobian.as_flattened());
        round(self.gains.as_flattened_mut(), finer.gains.as_flattened());
        self.factors.take(&finer.factors, orders);
    }
}

impl<E: Copy, const B: usize, const G: usize> Between<E, B, G> {
    #[inline(always)]
    pub fn rounded<S: Fused, P: Pick<S, Eight = E> + Pick<f64>>(
        &self,
        pick: P,
    ) -> Between<<P as Pick<f64>>::Eight, B, G> {
        let [one, other] = &self.ahead;
        Between {
            sums: rounded::<S, P, B>(pick, &self.sums),
            rest: rounded::<S, P, B>(pick, &self.rest),
            newest: rounded::<S, P, B>(pick, &self.newest),
            ahead: [rounded::<S, P, G>(pick, one), rounded::<S, P, G>(pick, other)],
        }
    }
}
