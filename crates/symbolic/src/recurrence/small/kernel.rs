//! The numbers of a small right-hand side, by registers of eight.

use super::law::Law;
use super::solved::Row;
use crate::recurrence::layout::Lanes;
use crate::recurrence::pick::{Pick, Shuffle};

pub(super) type Wide = Lanes<f64, 8>;
pub(super) const ZERO: Wide = Lanes([0.0; 8]);

impl Wide {
    /// self + times other
    #[inline(always)]
    pub(super) fn plus<P: Pick<f64>>(&self, pick: P, other: &Self, times: f64) -> Self {
        Lanes(pick.store(pick.plus_product(pick.load(&self.0), pick.load(&other.0), pick.load(&[times; 8]))))
    }
}

/// Columns for C groups of eight, each over B groups of rows.
pub(super) type Matrix<const B: usize, const C: usize> = [[[Wide; B]; 8]; C];

/// Room for the series to this order and for chains that go too far.
const ROOM: usize = MOST_ORDER + 2 * CHAINS;

/// Sums that run side by side: none waits for the addition before.
pub(super) const CHAINS: usize = 2;

/// Higher orders are for more digits than `f64` has.
pub(in crate::recurrence) const MOST_ORDER: usize = 64;

/// Columns are taken four at a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fours {
    pub count: usize,
    /// A bit for each four that counts in more rows than the first eight.
    pub far: u8,
}

impl Fours {
    fn new(count: usize, far: impl Iterator<Item = usize>) -> Self {
        Fours { count: count.div_ceil(4), far: far.fold(0, |bits, column| bits | 1 << (column / 4)) }
    }
}

/// The quantities in B groups of eight, the products in G.
#[derive(Clone, Debug)]
pub struct Kernel<const B: usize, const G: usize> {
    pub(super) law: Law,
    /// The coefficients of what is solved for.
    pub(super) values: Vec<f64>,
    /// Of the columns of quantities, of those that move, and of products.
    pub(super) fours: [Fours; 3],
    pub(super) constants: [Wide; B],
    /// The rates by the quantities, and what is solved for by itself.
    pub(super) linear: Matrix<B, B>,
    /// The rates by the products.
    pub(super) weights: Matrix<B, G>,
    /// J and W at the point of the last expansion.
    pub(super) jacobian: Matrix<B, B>,
    pub(super) gains: Matrix<B, G>,
    /// For each quantity its products, with the other factor; and where the next one's begin.
    partners: Vec<(u8, u8)>,
    ends: Vec<u8>,
    /// Which quantities the factors are, among the first sixteen; then among these and the rest.
    factors: [[[Shuffle; 2]; 2]; G],
    /// What is solved for at that point.
    pub(super) rows: Vec<Row<B, G>>,
    /// A bit for each quantity that is solved for.
    pub(super) is_solved: [u8; B],
    /// a_j at j.
    pub(super) left: [[Wide; G]; ROOM],
    /// b_j at MOST_ORDER - j.
    pub(super) right: [[Wide; G]; ROOM],
}

impl<const B: usize, const G: usize> Kernel<B, G> {
    pub(super) fn new(law: &Law) -> Box<Self> {
        let quantity = |number: usize, side: usize| law.products.get(number).map_or(0, |factors| factors[side]);
        let shuffles = |group: usize, side: usize| -> [Shuffle; 2] {
            let lanes: [usize; 8] = std::array::from_fn(|lane| quantity(8 * group + lane, side));
            let first = std::array::from_fn(|lane| lanes[lane] as u64 % 16);
            let then = std::array::from_fn(|lane| if lanes[lane] < 16 { lane as u64 } else { lanes[lane] as u64 - 8 });
            [first, then]
        };
        let (mut partners, mut ends) = (Vec::new(), Vec::new());
        for quantity in 0..law.quantities() {
            for (number, &[a, b]) in law.products.iter().enumerate() {
                partners.extend((a == quantity).then_some((number as u8, b as u8)));
                partners.extend((b == quantity).then_some((number as u8, a as u8)));
            }
            ends.push(partners.len() as u8);
        }
        let far = |product: &usize| law.quadratic.iter().any(|(row, of, _)| of == product && *row >= 8);
        let products = (0..law.products.len()).filter(|product| far(product) || !law.solved.is_empty());
        let factors = products.clone().flat_map(|product| law.products[product]);
        let linear = law.linear.iter().filter(|(row, ..)| *row >= 8).map(|(_, quantity, _)| *quantity);
        let quantities = Fours::new(law.quantities(), linear.chain(factors).chain(law.moving..law.quantities()));
        let fours = [
            quantities,
            Fours { count: law.moving.div_ceil(4), far: if law.solved.is_empty() { quantities.far } else { u8::MAX } },
            Fours::new(law.products.len(), products),
        ];
        let mut is_solved = [0; B];
        (law.moving..law.quantities()).for_each(|quantity| is_solved[quantity / 8] |= 1 << (quantity % 8));
        Box::new(Kernel {
            law: law.clone(),
            values: Vec::new(),
            fours,
            constants: [ZERO; B],
            linear: [[[ZERO; B]; 8]; B],
            weights: [[[ZERO; B]; 8]; G],
            jacobian: [[[ZERO; B]; 8]; B],
            gains: [[[ZERO; B]; 8]; G],
            partners,
            ends,
            factors: std::array::from_fn(|group| [shuffles(group, 0), shuffles(group, 1)]),
            rows: vec![Row::EMPTY; law.solved.len()],
            is_solved,
            left: [[ZERO; G]; ROOM],
            right: [[ZERO; G]; ROOM],
        })
    }

    pub(super) fn set(&mut self, values: &[f64]) {
        let value = |number: u32| values.get(number as usize).copied().unwrap_or(0.0);
        for &(row, number) in &self.law.constants {
            self.constants[row / 8].0[row % 8] = value(number);
        }
        for &(row, column, number) in &self.law.linear {
            self.linear[column / 8][column % 8][row / 8].0[row % 8] = value(number);
        }
        for quantity in self.law.moving..self.law.quantities() {
            self.linear[quantity / 8][quantity % 8][quantity / 8].0[quantity % 8] = 1.0;
        }
        for &(row, product, number) in &self.law.quadratic {
            self.weights[product / 8][product % 8][row / 8].0[row % 8] = value(number);
        }
        self.gains = self.weights;
        self.values = values.to_vec();
    }

    /// The derivatives of the rates at a point by all quantities: L, and each product's weight times the one factor in the
    /// column of the other.
    #[inline(always)]
    pub(super) fn linearise<P: Pick<f64>>(&mut self, pick: P, point: &[[f64; 8]; B]) {
        let mut first = 0;
        for (column, &end) in self.ends.iter().enumerate() {
            let (group, column) = (column / 8 % B, column % 8);
            let mut sums = self.linear[group][column].map(|eight| pick.load(&eight.0));
            for &(product, partner) in self.partners.get(first..usize::from(end)).unwrap_or(&[]) {
                let (product, partner) = (usize::from(product), usize::from(partner));
                let partner = pick.load(&[point[partner / 8 % B][partner % 8]; 8]);
                for (sum, weight) in sums.iter_mut().zip(&self.weights[product / 8 % G][product % 8]) {
                    *sum = pick.plus_product(*sum, pick.load(&weight.0), partner);
                }
            }
            self.jacobian[group][column] = sums.map(|sum| Lanes(pick.store(sum)));
            first = end.into();
        }
    }

    /// The factors on one side of all products.
    #[inline(always)]
    pub(super) fn pick<P: Pick<f64>>(&self, pick: P, side: usize, from: &[P::Eight; B]) -> [P::Eight; G] {
        std::array::from_fn(|group| {
            let [first, then] = &self.factors[group][side];
            let picked = pick.shuffle([from[0], from[1 % B]], first);
            if B > 2 { pick.shuffle([picked, from[2 % B]], then) } else { picked }
        })
    }
}
