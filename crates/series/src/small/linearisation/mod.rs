//! Small laws with solved quantities (quotients and square roots): these are eliminated from the linearised rates, so
//! that no order has to wait for them.
//!
//! In `f64` only. In a finer type few orders need all digits, and the derivatives would cost more than those orders.

mod eliminate;
mod matrix;
mod orders;
mod pattern;

use super::factors::{Factors, Places};
use super::law::{Law, Sums};
use super::solving::{Solving, solved_by};
use crate::fused::Fused;
use crate::small::permutation::Permute;
use crate::small::wide::Wide;
use crate::stored::Stored;
use eliminate::Elimination;
use matrix::Matrix;
use orders::{Orders, Shape};
use pattern::Pattern;
use std::ops::Range;

/// A law with the quantities in B groups of eight and the products in G.
#[derive(Clone, Debug)]
pub(super) struct Linearised<const B: usize, const G: usize> {
    law: Law,
    shape: Shape<B>,
    /// The linear coefficients of the rates, by quantities, and those of the solved quantities.
    linear: Matrix<B, B>,
    /// The coefficients of the rates by products.
    weights: Matrix<B, G>,
    /// For each quantity its products with the other factor, and the first index of those of the next one.
    partners: Vec<(u8, u8)>,
    ends: Vec<u8>,
    elimination: Elimination,
    orders: Orders<B, G>,
}

impl<const B: usize, const G: usize> Linearised<B, G> {
    pub fn new(law: &Law) -> Self {
        let solved_by = solved_by(law);
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
            shape: Shape::new(law, &Pattern::new(law, &solved_by)),
            linear: [[[zero; B]; 8]; B],
            weights: [[[zero; B]; 8]; G],
            partners,
            ends,
            elimination: Elimination::new(law, &solved_by),
            orders: Orders::new(),
        }
    }

    pub fn set(&mut self, value: impl Fn(u32) -> f64) {
        let Sums { linear, quadratic, .. } = &self.law.rates;
        for &(row, column, number) in linear {
            self.linear[column / 8][column % 8][row / 8].0.set(row % 8, value(number));
        }
        for quantity in self.law.moving..self.law.quantities() {
            self.linear[quantity / 8][quantity % 8][quantity / 8].0.set(quantity % 8, 1.0);
        }
        for &(row, product, number) in quadratic {
            self.weights[product / 8][product % 8][row / 8].0.set(row % 8, value(number));
        }
        self.orders.gains = self.weights;
    }

    /// Computes J and W at the expansion point.
    #[inline(always)]
    pub fn about<S: Fused, P: Permute<f64>>(&mut self, pick: P, solving: &Solving<S, B, G>) {
        self.linearise(pick, &solving.point().map(|eight| eight.rounded()));
        let Linearised { elimination, weights, orders, .. } = self;
        elimination.run(pick, solving.rows(), &mut orders.jacobian, weights, &mut orders.gains);
    }

    /// Computes y_(k+1) for these k > 0, from y_k of the moving quantities and the earlier factors.
    #[inline(always)]
    pub fn run<S: Fused, P: Permute<f64>, R: From<f64>>(
        &mut self,
        pick: P,
        places: &Places<G>,
        factors: &Factors<S, G>,
        orders: Range<usize>,
        newest: [P::Eight; B],
        rows: &mut [[R; 8]],
    ) {
        let Linearised { shape, orders: own, .. } = self;
        own.factors.take(factors, orders.start);
        let between = own.begin(pick, shape, orders.start, newest);
        own.run(pick, shape, places, orders, between, rows);
    }

    /// The derivatives of the rates with respect to all quantities at a point: L, plus the weight of each product times
    /// one factor, in the column of the other.
    #[inline(always)]
    fn linearise<P: Permute<f64>>(&mut self, pick: P, point: &[[f64; 8]; B]) {
        let (weights, point) = (self.weights.as_flattened(), point.as_flattened());
        let columns = self.orders.jacobian.as_flattened_mut().iter_mut().zip(self.linear.as_flattened());
        let mut first = 0;
        for ((column, linear), &end) in columns.zip(&self.ends) {
            let mut sums = [pick.all(0.0); B];
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
