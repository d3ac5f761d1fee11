//! The numbers of a small right-hand side, by registers of eight.

use super::law::Law;
use super::matrix::{Matrix, Wide};
use super::orders::{Orders, Shape};
use super::pattern::Pattern;
use super::solved::Row;
use crate::recurrence::fused::Fused;
use crate::recurrence::pick::Pick;
use crate::recurrence::stored::Stored;

/// The quantities in B groups of eight, the products in G.
#[derive(Clone, Debug)]
pub struct Kernel<S: Fused, const B: usize, const G: usize> {
    pub(super) law: Law,
    /// The coefficients of what is solved for.
    pub(super) values: Vec<S>,
    pub(super) shape: Shape<B, G>,
    pub(super) constants: [Wide<S>; B],
    /// The rates by the quantities, and what is solved for by itself.
    pub(super) linear: Matrix<S, B, B>,
    /// The rates by the products.
    pub(super) weights: Matrix<S, B, G>,
    /// For each quantity its products, with the other factor; and where the next one's begin.
    partners: Vec<(u8, u8)>,
    ends: Vec<u8>,
    /// What is solved for at that point.
    pub(super) rows: Vec<Row<S, B, G>>,
    pub(super) orders: Orders<S, B, G>,
    /// Of a finer field: the orders for which the digits of `f64` do.
    pub(super) rounded: Option<Box<Orders<f64, B, G>>>,
}

impl<S: Fused, const B: usize, const G: usize> Kernel<S, B, G> {
    pub(super) fn new(law: &Law) -> Box<Self> {
        let pattern = Pattern::new(law);
        let (mut partners, mut ends) = (Vec::new(), Vec::new());
        for quantity in 0..law.quantities() {
            for (number, &[a, b]) in law.products.iter().enumerate() {
                partners.extend((a == quantity).then_some((number as u8, b as u8)));
                partners.extend((b == quantity).then_some((number as u8, a as u8)));
            }
            ends.push(partners.len() as u8);
        }
        let zero = Wide::zero();
        Box::new(Kernel {
            law: law.clone(),
            values: Vec::new(),
            shape: Shape::new(law, &pattern),
            constants: [zero; B],
            linear: [[[zero; B]; 8]; B],
            weights: [[[zero; B]; 8]; G],
            partners,
            ends,
            rows: vec![Row::empty(); law.solved.len()],
            orders: Orders::new(),
            rounded: S::FINER.then(|| Box::new(Orders::new())),
        })
    }

    pub(super) fn set(&mut self, values: &[S]) {
        let value = |number: u32| values.get(number as usize).copied().unwrap_or(S::zero());
        for &(row, number) in &self.law.constants {
            self.constants[row / 8].0.set(row % 8, value(number));
        }
        for &(row, column, number) in &self.law.linear {
            self.linear[column / 8][column % 8][row / 8].0.set(row % 8, value(number));
        }
        for quantity in self.law.moving..self.law.quantities() {
            self.linear[quantity / 8][quantity % 8][quantity / 8].0.set(quantity % 8, S::one());
        }
        for &(row, product, number) in &self.law.quadratic {
            self.weights[product / 8][product % 8][row / 8].0.set(row % 8, value(number));
        }
        self.orders.gains = self.weights;
        self.values = values.to_vec();
    }

    /// The derivatives of the rates at a point by all quantities: L, and each product's weight times the one factor in the
    /// column of the other.
    #[inline(always)]
    pub(super) fn linearise<P: Pick<S>>(&mut self, pick: P, point: &[[S; 8]; B]) {
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
