//! Orders of a small series after the first, with the data of each order in registers.
//!
//! For k > 0
//!
//!   f(y)_k = J y_k + W m_k ,    m_k = a_1 b_(k-1) + .. + a_(k-1) b_1 for each product a b ,
//!
//! where J and W are the derivatives of f at y_0 with respect to the quantities and with respect to the products, after
//! the elimination of solved quantities.

use super::matrix::{Fours, Matrix, times};
use super::pattern::Pattern;
use crate::small::MOST_ORDER;
use crate::small::factors::{CHAINS, Chains, Factors, Places, reciprocals};
use crate::small::law::Law;
use crate::small::permutation::Permute;
use crate::small::wide::Wide;
use std::ops::Range;

/// The sparsity pattern of the matrices.
#[derive(Clone, Debug)]
pub(super) struct Shape<const B: usize> {
    jacobian: Fours<B>,
    gains: Fours<B>,
    /// The solved quantities, as bits.
    is_solved: [u8; B],
}

impl<const B: usize> Shape<B> {
    pub fn new(law: &Law, pattern: &Pattern) -> Self {
        let mut is_solved = [0; B];
        (law.moving..law.quantities()).for_each(|quantity| is_solved[quantity / 8] |= 1 << (quantity % 8));
        Shape { jacobian: Fours::new(&pattern.jacobian), gains: Fours::new(&pattern.gains), is_solved }
    }
}

/// The intermediate results between two orders: f(y)_(k-1), the part of f(y)_k without y_k, y_k, and the known part of
/// the next products.
#[derive(Clone, Copy)]
pub(super) struct Between<E, const B: usize, const G: usize> {
    sums: [E; B],
    rest: [E; B],
    newest: [E; B],
    ahead: Chains<E, G>,
}

/// The linearised law at the expansion point, and the factors so far.
#[derive(Clone, Debug)]
pub(super) struct Orders<const B: usize, const G: usize> {
    /// The matrices J and W.
    pub jacobian: Matrix<B, B>,
    pub gains: Matrix<B, G>,
    pub factors: Factors<f64, G>,
    reciprocals: [f64; MOST_ORDER + 1],
}

impl<const B: usize, const G: usize> Orders<B, G> {
    pub fn new() -> Self {
        let zero = Wide::zero();
        Orders {
            jacobian: [[[zero; B]; 8]; B],
            gains: [[[zero; B]; 8]; G],
            factors: Factors::new(),
            reciprocals: reciprocals(),
        }
    }

    /// The intermediate results before order k > 0, from y_k of the moving quantities.
    #[inline(always)]
    pub fn begin<P: Permute<f64>>(
        &mut self,
        pick: P,
        shape: &Shape<B>,
        k: usize,
        newest: [P::Eight; B],
    ) -> Between<P::Eight, B, G> {
        let (nothing, mut sums) = (pick.all(0.0), newest);
        for sum in &mut sums {
            *sum = pick.product(*sum, pick.all(k as f64));
        }
        let mut ahead = [[nothing; G]; CHAINS];
        if k == 1 {
            return Between { sums, rest: [nothing; B], newest, ahead };
        }
        let (mut a, mut b) = ([nothing; G], [nothing; G]);
        for (group, (a, b)) in a.iter_mut().zip(&mut b).enumerate() {
            [*a, *b] = self.factors.at(pick, k - 1, group);
        }
        // the previous order gives the part ahead of this one
        self.factors.older(pick, 2, k - 2, &mut ahead);
        let older = self.middle(pick, k - 1, [a, b], &mut ahead);
        Between { sums, rest: times(pick, &self.gains, &older, &shape.gains), newest, ahead }
    }

    /// Stores a_k and b_k, and returns a_1 b_k + .. + a_k b_1.
    #[inline(always)]
    fn middle<P: Permute<f64>>(
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

    /// Computes y_(k+1) for these k > 0, and writes them into the rows of the series.
    #[inline(always)]
    pub fn run<P: Permute<f64>, R: From<f64>>(
        &mut self,
        pick: P,
        shape: &Shape<B>,
        places: &Places<G>,
        orders: Range<usize>,
        Between { mut sums, mut rest, mut newest, mut ahead }: Between<P::Eight, B, G>,
        rows: &mut [[R; 8]],
    ) {
        for k in orders {
            // y_k = sums / k: J is applied to the sums, so that the division causes no delay
            let known = times(pick, &self.jacobian, &sums, &shape.jacobian);
            for block in 0..B {
                sums[block] = pick.plus_product(rest[block], known[block], pick.all(self.reciprocals[k]));
                newest[block] = pick.blend(shape.is_solved[block], newest[block], sums[block]);
            }
            let older = self.middle(pick, k, places.pick(pick, &newest), &mut ahead);
            rest = times(pick, &self.gains, &older, &shape.gains);
            for block in 0..B {
                newest[block] = pick.product(sums[block], pick.all(self.reciprocals[k + 1]));
                rows[(k + 1) * B + block] = pick.store(newest[block]).map(R::from);
            }
        }
    }
}
