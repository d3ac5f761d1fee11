//! What is solved for in each order: by what moves, and by what is known of the products.
//!
//! Of a product (a b)_k = a_0 b_k + b_0 a_k + m_k, m = a_1 b_(k-1) + .. + a_(k-1) b_1. So for k > 0 every quantity is
//!
//!   x_k = A y_k + C m_k
//!
//! with rows A and C that the order 0 gives: of a reciprocal, r_k = -r_0 (r_0 b_k + m_k), of a root, r_k = (a_k - m_k) / 2 r_0.
//! Put into the rates, what is solved for is gone from them.

use super::Linearised;
use super::pattern::{RowSet, members};
use crate::recurrence::fused::Fused;
use crate::recurrence::small::law::Solved;

/// Of something that is solved for A and C. Numbers one by one: few of them are not zero.
#[derive(Clone, Debug)]
pub(super) struct Row<S, const B: usize, const G: usize> {
    pub moving: [[S; 8]; B],
    pub products: [[S; 8]; G],
    /// Those that can be something else than zero.
    members: [Vec<u8>; 2],
}

impl<S: Fused, const B: usize, const G: usize> Row<S, B, G> {
    pub(super) fn new((moving, products): (RowSet, RowSet)) -> Self {
        let members = [moving, products].map(|set| members(set).map(|member| member as u8).collect());
        Row { moving: [[S::zero(); 8]; B], products: [[S::zero(); 8]; G], members }
    }

    #[inline(always)]
    fn clear(&mut self) {
        self.members[0].iter().for_each(|member| *at(&mut self.moving, (*member).into()) = S::zero());
        self.members[1].iter().for_each(|member| *at(&mut self.products, (*member).into()) = S::zero());
    }

    /// Adds a quantity so many times: one that moves, or one whose row is known.
    #[inline(always)]
    fn take(&mut self, known: &[Self], quantity: usize, moving: usize, times: S) {
        if quantity < moving {
            *at(&mut self.moving, quantity) += times;
        } else if let Some(row) = known.get(quantity - moving) {
            for member in row.members[0].iter().map(|member| usize::from(*member)) {
                *at(&mut self.moving, member) += row.moving[member / 8 % B][member % 8] * times;
            }
            for member in row.members[1].iter().map(|member| usize::from(*member)) {
                *at(&mut self.products, member) += row.products[member / 8 % G][member % 8] * times;
            }
        }
    }
}

fn at<S, const N: usize>(groups: &mut [[S; 8]; N], number: usize) -> &mut S {
    &mut groups[number / 8 % N][number % 8]
}

impl<S: Fused, const B: usize, const G: usize> Linearised<S, B, G> {
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

    /// Finds the rows of what is solved for.
    #[inline(always)]
    pub(super) fn find_rows(&mut self, point: &[[S; 8]; B]) {
        let coefficient = |number: u32| self.values.get(number as usize).copied().unwrap_or(S::zero());
        let value = |quantity: usize| point[quantity / 8 % B][quantity % 8];
        let moving = self.law.moving;
        for (number, solved) in self.law.solved.iter().enumerate() {
            let (known, later) = self.rows.split_at_mut(number);
            let Some(row) = later.first_mut() else { continue };
            row.clear();
            match solved {
                Solved::Sum { linear, products, .. } => {
                    for &(of, number) in linear {
                        row.take(known, of, moving, coefficient(number));
                    }
                    for &(product, number) in products {
                        let ([a, b], times) = (self.law.products[product], coefficient(number));
                        row.take(known, a, moving, times * value(b));
                        row.take(known, b, moving, times * value(a));
                        *at(&mut row.products, product) += times;
                    }
                }
                Solved::Reciprocal { of, product } => {
                    let own = value(moving + number);
                    row.take(known, *of, moving, -own * own);
                    *at(&mut row.products, *product) -= own;
                }
                Solved::Root { of, product } => {
                    let half = S::ratio(1, 2) / value(moving + number);
                    row.take(known, *of, moving, half);
                    *at(&mut row.products, *product) -= half;
                }
            }
        }
    }
}
