//! Where some quantities are solved for, quotients and roots: they are put into the rates, linearised about the point.

mod eliminate;
mod expand;
mod matrix;
mod orders;
mod pattern;
mod solved;

pub(super) use expand::Expand;

use super::law::{Law, Sums};
use super::starts::Starts;
use crate::recurrence::fused::Fused;
use crate::recurrence::pick::Pick;
use crate::recurrence::stored::{Stored, Wide};
use eliminate::Elimination;
use matrix::Matrix;
use orders::{Orders, Shape};
use pattern::{Pattern, solved_by};
use solved::Row;

/// A law, with the quantities in B groups of eight and the products in G.
#[derive(Clone, Debug)]
pub struct Linearised<S: Fused, const B: usize, const G: usize> {
    law: Law,
    starts: Starts<S, B>,
    /// The coefficients of what is solved for.
    values: Vec<S>,
    shape: Shape<B, G>,
    constants: [Wide<S>; B],
    /// The rates by the quantities, and what is solved for by itself.
    linear: Matrix<S, B, B>,
    /// The rates by the products.
    weights: Matrix<S, B, G>,
    /// For each quantity its products, with the other factor; and where the next one's begin.
    partners: Vec<(u8, u8)>,
    ends: Vec<u8>,
    elimination: Elimination,
    /// What is solved for at that point.
    rows: Vec<Row<S, B, G>>,
    orders: Orders<S, B, G>,
    /// Of a finer field: the orders for which the digits of `f64` do.
    rounded: Option<Orders<f64, B, G>>,
}

impl<S: Fused, const B: usize, const G: usize> Linearised<S, B, G> {
    pub(super) fn new(law: &Law) -> Self {
        let solved_by = solved_by(law);
        let pattern = Pattern::new(law, &solved_by);
        let (mut partners, mut ends) = (Vec::new(), Vec::new());
        for quantity in 0..law.quantities() {
            for (number, &[a, b]) in law.products.iter().enumerate() {
                partners.extend((a == quantity).then_some((number as u8, b as u8)));
                partners.extend((b == quantity).then_some((number as u8, a as u8)));
            }
            ends.push(partners.len() as u8);
        }
        let zero = Wide::zero();
        Linearised {
            law: law.clone(),
            starts: Starts::new(law),
            values: Vec::new(),
            shape: Shape::new(law, &pattern),
            constants: [zero; B],
            linear: [[[zero; B]; 8]; B],
            weights: [[[zero; B]; 8]; G],
            partners,
            ends,
            elimination: Elimination::new(law, &solved_by),
            rows: solved_by.into_iter().map(Row::new).collect(),
            orders: Orders::new(),
            rounded: S::FINER.then(Orders::new),
        }
    }

    pub(super) fn set(&mut self, values: &[S]) {
        let value = |number: u32| values.get(number as usize).copied().unwrap_or(S::zero());
        self.starts.set(&self.law, value);
        let Sums { constants, linear, quadratic } = &self.law.rates;
        for &(row, number) in constants {
            self.constants[row / 8].0.set(row % 8, value(number));
        }
        for &(row, column, number) in linear {
            self.linear[column / 8][column % 8][row / 8].0.set(row % 8, value(number));
        }
        for quantity in self.law.moving..self.law.quantities() {
            self.linear[quantity / 8][quantity % 8][quantity / 8].0.set(quantity % 8, S::one());
        }
        for &(row, product, number) in quadratic {
            self.weights[product / 8][product % 8][row / 8].0.set(row % 8, value(number));
        }
        self.orders.gains = self.weights;
        self.values = values.to_vec();
    }

    /// The derivatives of the rates at a point by all quantities: L, and each product's weight times the one factor in the
    /// column of the other.
    #[inline(always)]
    fn linearise<P: Pick<S>>(&mut self, pick: P, point: &[[S; 8]; B]) {
        let (weights, point) = (self.weights.as_flattened(), point.as_flattened());
        let columns = self.orders.jacobian.as_flattened_mut().iter_mut().zip(self.linear.as_flattened());
        let mut first = 0;
        for ((column, linear), &end) in columns.zip(&self.ends) {
            let mut sums = [pick.all(S::zero()); B];
            for (sum, own) in sums.iter_mut().zip(linear) {
                *sum = pick.load(&own.0);
            }
            for &(product, partner) in self.partners.get(first..usize::from(end)).unwrap_or(&[]) {
                let (product, partner) = (weights.get(usize::from(product)), point.get(usize::from(partner)));
                let (Some(weights), Some(&partner)) = (product, partner) else { continue };
                let partner = pick.all(partner);
                for (sum, weight) in sums.iter_mut().zip(weights) {
                    *sum = pick.plus_product(*sum, pick.load(&weight.0), partner);
                }
            }
            for (own, sum) in column.iter_mut().zip(sums) {
                own.0 = pick.store(sum);
            }
            first = end.into();
        }
    }
}
