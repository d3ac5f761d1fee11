//! The numbers of a small right-hand side of second degree, by registers of eight.

use super::degree::SecondDegree;
use crate::recurrence::layout::Lanes;
use crate::recurrence::order::add;
use crate::recurrence::pick::{Pick, Shuffle};

pub(super) type Wide = Lanes<f64, 8>;
pub(super) const ZERO: Wide = Lanes([0.0; 8]);

/// Room for the series to this order and for chains that go too far.
const ROOM: usize = MOST_ORDER + 2 * CHAINS;

/// Sums that run side by side: none waits for the addition before.
pub(super) const CHAINS: usize = 2;

/// Higher orders are for more digits than `f64` has.
pub(in crate::recurrence) const MOST_ORDER: usize = 64;

/// The quantities in B groups of eight, the products in G.
#[derive(Clone, Debug)]
pub struct Kernel<const B: usize, const G: usize> {
    degree: SecondDegree,
    pub(super) constants: [Wide; B],
    /// L, by columns.
    pub(super) linear: [[[Wide; B]; 8]; B],
    /// w, by columns.
    pub(super) weights: [[[Wide; B]; 8]; G],
    /// J at the point of the last expansion, by columns.
    pub(super) jacobian: [[[Wide; B]; 8]; B],
    /// Which quantities the factors are.
    factors: [[Shuffle; 2]; G],
    /// a_j at j.
    pub(super) left: [[Wide; G]; ROOM],
    /// b_j at MOST_ORDER - j.
    pub(super) right: [[Wide; G]; ROOM],
}

impl<const B: usize, const G: usize> Kernel<B, G> {
    pub(super) fn new(degree: &SecondDegree) -> Box<Self> {
        let shuffle = |group: usize, factor: usize| -> Shuffle {
            let quantity = |lane: usize| degree.products.get(8 * group + lane).map_or(0, |factors| factors[factor]);
            std::array::from_fn(|lane| quantity(lane) as u64)
        };
        Box::new(Kernel {
            degree: degree.clone(),
            constants: [ZERO; B],
            linear: [[[ZERO; B]; 8]; B],
            weights: [[[ZERO; B]; 8]; G],
            jacobian: [[[ZERO; B]; 8]; B],
            factors: std::array::from_fn(|group| [shuffle(group, 0), shuffle(group, 1)]),
            left: [[ZERO; G]; ROOM],
            right: [[ZERO; G]; ROOM],
        })
    }

    pub(super) fn set(&mut self, values: &[f64]) {
        let value = |number: u32| values.get(number as usize).copied().unwrap_or(0.0);
        for &(row, number) in &self.degree.constants {
            self.constants[row / 8].0[row % 8] = value(number);
        }
        for &(row, column, number) in &self.degree.linear {
            self.linear[column / 8][column % 8][row / 8].0[row % 8] = value(number);
        }
        for &(row, product, number) in &self.degree.quadratic {
            self.weights[product / 8][product % 8][row / 8].0[row % 8] = value(number);
        }
    }

    /// J at a point: L, and each product's weight times the one factor in the column of the other.
    #[inline(always)]
    pub(super) fn linearise<P: Pick<f64>>(&mut self, point: &[[f64; 8]; B]) {
        self.jacobian = self.linear;
        for (number, &[a, b]) in self.degree.products.iter().enumerate() {
            let weight = &self.weights[number / 8 % G][number % 8];
            for (of, partner) in [(a, b), (b, a)] {
                let partner = point[partner / 8 % B][partner % 8];
                for (sum, weight) in self.jacobian[of / 8 % B][of % 8].iter_mut().zip(weight) {
                    sum.0 = add::<P, f64, 8>(sum.0, weight.0, [partner; 8]);
                }
            }
        }
    }

    /// The factors on one side of all products.
    #[inline(always)]
    pub(super) fn pick<P: Pick<f64>>(&self, pick: P, side: usize, from: &[[f64; 8]; B]) -> [Wide; G] {
        let mut picked = [ZERO; G];
        for (picked, factors) in picked.iter_mut().zip(&self.factors) {
            picked.0 = pick.shuffle([&from[0], &from[B - 1]], &factors[side]);
        }
        picked
    }
}
