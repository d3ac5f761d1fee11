//! Solved quantities, order by order: sums from their parts, quotients and square roots from the products that they
//! solve.

mod by;
mod rows;

pub(super) use by::{Set, members, solved_by};
pub(super) use rows::Row;

use super::law::{Law, Solved};
use crate::fused::Fused;
use crate::small::permutation::Permute;
use crate::stored::Stored;

/// The solved quantities, among B groups of eight quantities and G groups of products.
#[derive(Clone, Debug)]
pub(super) struct Solving<S: Fused, const B: usize, const G: usize> {
    law: Law,
    /// The coefficients of the law.
    values: Vec<S>,
    /// All quantities of order 0.
    point: [S::Stored; B],
    /// The rows of the higher orders, at the expansion point.
    rows: Vec<Row<S, B, G>>,
}

impl<S: Fused, const B: usize, const G: usize> Solving<S, B, G> {
    pub fn new(law: &Law) -> Self {
        Solving {
            law: law.clone(),
            values: Vec::new(),
            point: [S::Stored::of([S::zero(); 8]); B],
            rows: solved_by(law).into_iter().map(Row::new).collect(),
        }
    }

    pub fn set(&mut self, values: &[S]) {
        self.values = values.to_vec();
    }

    /// All quantities of order 0.
    pub fn point(&self) -> &[S::Stored; B] {
        &self.point
    }

    pub fn rows(&self) -> &[Row<S, B, G>] {
        &self.rows
    }

    fn coefficient(&self, number: u32) -> S {
        self.values.get(number as usize).copied().unwrap_or(S::zero())
    }

    /// All quantities of order 0, from the moving ones.
    #[inline(always)]
    pub fn first<P: Permute<S>>(&mut self, pick: P, moving: &[P::Eight; B]) -> [P::Eight; B] {
        let mut all = stored(pick, moving);
        for (quantity, solved) in (self.law.moving..).zip(&self.law.solved) {
            let at = |quantity: usize| lane(&all, quantity);
            let value = match solved {
                Solved::Sum { constant, linear, products } => {
                    let sum = constant.map_or(S::zero(), |number| self.coefficient(number));
                    let sum = linear.iter().fold(sum, |sum, &(of, number)| sum + self.coefficient(number) * at(of));
                    products.iter().fold(sum, |sum, &(product, number)| {
                        let [a, b] = self.law.products[product];
                        sum + self.coefficient(number) * at(a) * at(b)
                    })
                }
                Solved::Quotient { above, of, .. } => above.map_or(S::one(), at) / at(*of),
                Solved::Root { of, .. } => at(*of).sqrt(),
            };
            all[quantity / 8 % B].set(quantity % 8, value);
        }
        self.point = all;
        self.find_rows();
        loaded(pick, &all)
    }

    /// All quantities of order k > 0, from the moving ones and m_k = a_1 b_(k-1) + .. + a_(k-1) b_1 for each product.
    #[inline(always)]
    pub fn next<P: Permute<S>>(&self, pick: P, moving: &[P::Eight; B], middle: &[P::Eight; G]) -> [P::Eight; B] {
        let (mut all, middle) = (stored(pick, moving), stored(pick, middle));
        for (quantity, row) in (self.law.moving..).zip(&self.rows) {
            // the products are known earlier
            let known = row.products().fold(S::zero(), |sum, (product, times)| sum + times * lane(&middle, product));
            let value = row.moving().fold(known, |sum, (quantity, times)| sum + times * lane(&all, quantity));
            all[quantity / 8 % B].set(quantity % 8, value);
        }
        loaded(pick, &all)
    }
}

#[inline(always)]
fn lane<S, E: Stored<S>, const N: usize>(groups: &[E; N], number: usize) -> S {
    groups[number / 8 % N].lane(number % 8)
}

#[inline(always)]
fn stored<S: Fused, P: Permute<S>, const N: usize>(pick: P, eights: &[P::Eight; N]) -> [S::Stored; N] {
    let mut stored = [S::Stored::of([S::zero(); 8]); N];
    for (own, eight) in stored.iter_mut().zip(eights) {
        *own = pick.store(*eight);
    }
    stored
}

#[inline(always)]
fn loaded<S: Fused, P: Permute<S>, const N: usize>(pick: P, stored: &[S::Stored; N]) -> [P::Eight; N] {
    let mut loaded = [pick.all(S::zero()); N];
    for (own, eight) in loaded.iter_mut().zip(stored) {
        *own = pick.load(eight);
    }
    loaded
}
