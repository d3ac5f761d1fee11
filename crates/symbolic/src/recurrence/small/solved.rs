//! What is solved for in each order: by what moves, and by what is known of the products.
//!
//! Of a product (a b)_k = a_0 b_k + b_0 a_k + m_k, m = a_1 b_(k-1) + .. + a_(k-1) b_1. So for k > 0 every quantity is
//!
//!   x_k = A y_k + C m_k
//!
//! with rows A and C that the order 0 gives: of a reciprocal, r_k = -r_0 (r_0 b_k + m_k), of a root, r_k = (a_k - m_k) / 2 r_0.
//! Put into the rates, what is solved for is gone from them.

use super::kernel::Kernel;
use super::law::Solved;
use super::matrix::Wide;
use super::orders::Orders;
use crate::recurrence::fused::Fused;
use crate::recurrence::pick::Pick;
use crate::recurrence::stored::Stored;

/// A row over what moves, and over the products.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<S: Fused, const B: usize, const G: usize> {
    moving: [Wide<S>; B],
    products: [Wide<S>; G],
}

impl<S: Fused, const B: usize, const G: usize> Row<S, B, G> {
    pub(super) fn empty() -> Self {
        Row { moving: [Wide::zero(); B], products: [Wide::zero(); G] }
    }

    #[inline(always)]
    fn plus<P: Pick<S>>(&mut self, pick: P, other: &Self, times: S) {
        let groups = self.moving.iter_mut().zip(&other.moving);
        for (sum, other) in groups.chain(self.products.iter_mut().zip(&other.products)) {
            *sum = sum.plus(pick, other, times);
        }
    }

    /// Adds a quantity so many times: one that moves, or one whose row is known.
    #[inline(always)]
    fn take<P: Pick<S>>(&mut self, pick: P, known: &[Self], quantity: usize, moving: usize, times: S) {
        if quantity < moving {
            self.moving[quantity / 8 % B].0.add(quantity % 8, times);
        } else if let Some(row) = known.get(quantity - moving) {
            self.plus(pick, row, times);
        }
    }
}

impl<S: Fused, const B: usize, const G: usize> Kernel<S, B, G> {
    /// Solves the order 0 for the quantities after those that move.
    #[inline(always)]
    pub(super) fn solve(&self, point: &mut [[S; 8]; B]) {
        let coefficient = |number: u32| self.values.get(number as usize).copied().unwrap_or(S::zero());
        for (quantity, solved) in (self.law.moving..).zip(&self.law.solved) {
            let at = |quantity: usize| point[quantity / 8 % B][quantity % 8];
            let value = match solved {
                Solved::Sum { constant, linear, products } => {
                    let sum = constant.map_or(S::zero(), coefficient);
                    let sum = linear.iter().fold(sum, |sum, &(of, number)| sum + coefficient(number) * at(of));
                    products.iter().fold(sum, |sum, &(product, number)| {
                        let [a, b] = self.law.products[product];
                        sum + coefficient(number) * at(a) * at(b)
                    })
                }
                Solved::Reciprocal { of, .. } => S::one() / at(*of),
                Solved::Root { of, .. } => at(*of).sqrt(),
            };
            point[quantity / 8 % B][quantity % 8] = value;
        }
    }

    /// Takes what is solved for out of the rates' derivatives, and gives it rows of its own.
    #[inline(always)]
    pub(super) fn eliminate<P: Pick<S>>(&mut self, pick: P, point: &[[S; 8]; B]) {
        let coefficient = |number: u32| self.values.get(number as usize).copied().unwrap_or(S::zero());
        let at = |quantity: usize| point[quantity / 8 % B][quantity % 8];
        let moving = self.law.moving;
        for (number, solved) in self.law.solved.iter().enumerate() {
            let (known, later) = self.rows.split_at_mut(number);
            let Some(row) = later.first_mut() else { continue };
            *row = Row::empty();
            match solved {
                Solved::Sum { linear, products, .. } => {
                    for &(of, number) in linear {
                        row.take(pick, known, of, moving, coefficient(number));
                    }
                    for &(product, number) in products {
                        let ([a, b], times) = (self.law.products[product], coefficient(number));
                        row.take(pick, known, a, moving, times * at(b));
                        row.take(pick, known, b, moving, times * at(a));
                        row.products[product / 8 % G].0.add(product % 8, times);
                    }
                }
                Solved::Reciprocal { of, product } => {
                    let own = at(moving + number);
                    row.take(pick, known, *of, moving, -own * own);
                    row.products[product / 8 % G].0.add(product % 8, -own);
                }
                Solved::Root { of, product } => {
                    let half = S::ratio(1, 2) / at(moving + number);
                    row.take(pick, known, *of, moving, half);
                    row.products[product / 8 % G].0.add(product % 8, -half);
                }
            }
        }
        // its own column has a one in its own row: so the rows are put in by the way
        let Kernel { law, rows, orders: Orders { jacobian, gains, .. }, weights, .. } = self;
        let (columns, solved) = jacobian.as_flattened_mut().split_at_mut(moving);
        for (number, column) in columns.iter_mut().enumerate() {
            let times = rows.iter().map(|row| row.moving[number / 8 % B].0.lane(number % 8));
            *column = put(pick, *column, times.zip(&*solved));
        }
        let products = gains.as_flattened_mut().iter_mut().zip(weights.as_flattened()).take(law.products.len());
        for (number, (gain, weight)) in products.enumerate() {
            let times = rows.iter().map(|row| row.products[number / 8 % G].0.lane(number % 8));
            *gain = put(pick, *weight, times.zip(&*solved));
        }
        solved[..law.solved.len()].fill([Wide::zero(); B]);
    }
}

/// A column with what is solved for put into it, so many times each.
#[inline(always)]
fn put<'a, S: Fused, P: Pick<S>, const B: usize>(
    pick: P,
    mut column: [Wide<S>; B],
    solved: impl Iterator<Item = (S, &'a [Wide<S>; B])>,
) -> [Wide<S>; B] {
    for (times, own) in solved {
        for block in 0..B {
            column[block] = column[block].plus(pick, &own[block], times);
        }
    }
    column
}
