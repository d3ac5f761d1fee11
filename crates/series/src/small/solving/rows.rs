//! Linear rows for the solved quantities in each order, by the moving quantities and by the known parts of products.
//!
//! A product has (a b)_k = a_0 b_k + b_0 a_k + m_k with m_k = a_1 b_(k-1) + .. + a_(k-1) b_1. For k > 0 every solved
//! quantity is
//!
//!   x_k = A y_k + C m_k
//!
//! with rows A and C that depend on order 0 only: for a quotient q_k = (a_k - q_0 b_k - m_k) / b_0, for a square root
//! r_k = (a_k - m_k) / 2 r_0.

use super::{Set, Solving, lane, members};
use crate::fused::Fused;
use crate::small::law::Solved;

/// The rows A and C of a solved quantity. They are stored as single numbers, since few are nonzero.
#[derive(Clone, Debug)]
pub(in crate::small) struct Row<S, const B: usize, const G: usize> {
    moving: [[S; 8]; B],
    products: [[S; 8]; G],
    /// The indices of entries that may be nonzero.
    members: [Vec<u8>; 2],
}

impl<S: Fused, const B: usize, const G: usize> Row<S, B, G> {
    pub fn new((moving, products): (Set, Set)) -> Self {
        let members = [moving, products].map(|set| members(set).map(|member| member as u8).collect());
        Row { moving: [[S::zero(); 8]; B], products: [[S::zero(); 8]; G], members }
    }

    /// The moving quantities, each with its coefficient.
    #[inline(always)]
    pub fn moving(&self) -> impl Iterator<Item = (usize, S)> {
        self.members[0].iter().map(|member| (usize::from(*member), self.of_moving((*member).into())))
    }

    /// The products, each with its coefficient.
    #[inline(always)]
    pub fn products(&self) -> impl Iterator<Item = (usize, S)> {
        self.members[1].iter().map(|member| (usize::from(*member), self.of_product((*member).into())))
    }

    #[inline(always)]
    pub fn of_moving(&self, quantity: usize) -> S {
        self.moving[quantity / 8 % B][quantity % 8]
    }

    #[inline(always)]
    pub fn of_product(&self, product: usize) -> S {
        self.products[product / 8 % G][product % 8]
    }

    #[inline(always)]
    fn clear(&mut self) {
        self.members[0].iter().for_each(|member| *at(&mut self.moving, (*member).into()) = S::zero());
        self.members[1].iter().for_each(|member| *at(&mut self.products, (*member).into()) = S::zero());
    }

    /// Adds a multiple of a quantity: a moving one, or one whose row is known.
    #[inline(always)]
    fn take(&mut self, known: &[Self], quantity: usize, moving: usize, times: S) {
        if quantity < moving {
            *at(&mut self.moving, quantity) += times;
        } else if let Some(row) = known.get(quantity - moving) {
            row.moving().for_each(|(member, own)| *at(&mut self.moving, member) += own * times);
            row.products().for_each(|(member, own)| *at(&mut self.products, member) += own * times);
        }
    }
}

fn at<S, const N: usize>(groups: &mut [[S; 8]; N], number: usize) -> &mut S {
    &mut groups[number / 8 % N][number % 8]
}

impl<S: Fused, const B: usize, const G: usize> Solving<S, B, G> {
    /// Computes the rows at the expansion point.
    #[inline(always)]
    pub(super) fn find_rows(&mut self) {
        let Solving { law, values, point, rows } = self;
        let coefficient = |number: u32| values.get(number as usize).copied().unwrap_or(S::zero());
        let value = |quantity: usize| lane(point, quantity);
        let moving = law.moving;
        for (number, solved) in law.solved.iter().enumerate() {
            let (known, later) = rows.split_at_mut(number);
            let Some(row) = later.first_mut() else { continue };
            row.clear();
            match solved {
                Solved::Sum { linear, products, .. } => {
                    for &(of, number) in linear {
                        row.take(known, of, moving, coefficient(number));
                    }
                    for &(product, number) in products {
                        let ([a, b], times) = (law.products[product], coefficient(number));
                        row.take(known, a, moving, times * value(b));
                        row.take(known, b, moving, times * value(a));
                        *at(&mut row.products, product) += times;
                    }
                }
                Solved::Quotient { above, of, product } => {
                    let (own, inverse) = (value(moving + number), S::one() / value(*of));
                    if let Some(above) = above {
                        row.take(known, *above, moving, inverse);
                    }
                    row.take(known, *of, moving, -own * inverse);
                    *at(&mut row.products, *product) -= inverse;
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
