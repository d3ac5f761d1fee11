//! The numbers of a small right-hand side, by registers of eight.

use super::law::Law;
use super::pattern::{Pattern, RowSet};
use super::solved::Row;
use crate::recurrence::fused::Fused;
use crate::recurrence::pick::{Pick, Shuffle};
use crate::recurrence::stored::Stored;

/// Eight numbers; of `f64` a line of the cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Wide<S: Fused>(pub S::Stored);

impl<S: Fused> Wide<S> {
    pub(super) fn zero() -> Self {
        Wide(S::Stored::of([S::zero(); 8]))
    }

    /// self + times other
    #[inline(always)]
    pub(super) fn plus<P: Pick<S>>(&self, pick: P, other: &Self, times: S) -> Self {
        Wide(pick.store(pick.plus_product(pick.load(&self.0), pick.load(&other.0), pick.all(times))))
    }
}

/// Columns for C groups of eight, each over B groups of rows.
pub(super) type Matrix<S, const B: usize, const C: usize> = [[[Wide<S>; B]; 8]; C];

/// Room for the series to this order and for chains that go too far.
const ROOM: usize = MOST_ORDER + 2 * CHAINS;

/// Sums that run side by side: none waits for the addition before.
pub(super) const CHAINS: usize = 2;

/// So many orders there is room for: more than any tolerance asks for.
pub(in crate::recurrence) const MOST_ORDER: usize = 64;

/// Columns are taken four at a time: a bit for each four that counts in a group of rows, and for each that counts at all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fours<const B: usize> {
    pub groups: [u8; B],
    pub any: u8,
}

impl<const B: usize> Fours<B> {
    fn new(columns: &[RowSet]) -> Self {
        let groups = std::array::from_fn(|group| {
            let counts = |four: &[RowSet]| four.iter().any(|rows| rows >> (8 * group) & 0xff != 0);
            columns.chunks(4).enumerate().fold(0, |bits, (number, four)| bits | u8::from(counts(four)) << number)
        });
        Fours { groups, any: groups.iter().fold(0, |any, group| any | group) }
    }
}

/// The quantities in B groups of eight, the products in G.
#[derive(Clone, Debug)]
pub struct Kernel<S: Fused, const B: usize, const G: usize> {
    pub(super) law: Law,
    /// The coefficients of what is solved for.
    pub(super) values: Vec<S>,
    /// Of `linear`, `weights`, `jacobian` and `gains`.
    pub(super) fours: [Fours<B>; 4],
    pub(super) constants: [Wide<S>; B],
    /// The rates by the quantities, and what is solved for by itself.
    pub(super) linear: Matrix<S, B, B>,
    /// The rates by the products.
    pub(super) weights: Matrix<S, B, G>,
    /// J and W at the point of the last expansion.
    pub(super) jacobian: Matrix<S, B, B>,
    pub(super) gains: Matrix<S, B, G>,
    /// For each quantity its products, with the other factor; and where the next one's begin.
    partners: Vec<(u8, u8)>,
    ends: Vec<u8>,
    /// Which quantities the factors are, among the first sixteen; then among these and the rest.
    factors: [[[Shuffle; 2]; 2]; G],
    /// What is solved for at that point.
    pub(super) rows: Vec<Row<S, B, G>>,
    /// 1/k
    pub(super) reciprocals: [S; MOST_ORDER + 1],
    /// A bit for each quantity that is solved for.
    pub(super) is_solved: [u8; B],
    /// a_j at j.
    pub(super) left: [[Wide<S>; G]; ROOM],
    /// b_j at MOST_ORDER - j.
    pub(super) right: [[Wide<S>; G]; ROOM],
}

impl<S: Fused, const B: usize, const G: usize> Kernel<S, B, G> {
    pub(super) fn new(law: &Law) -> Box<Self> {
        let quantity = |number: usize, side: usize| law.products.get(number).map_or(0, |factors| factors[side]);
        let shuffles = |group: usize, side: usize| -> [Shuffle; 2] {
            let lanes: [usize; 8] = std::array::from_fn(|lane| quantity(8 * group + lane, side));
            let first = std::array::from_fn(|lane| lanes[lane] as u64 % 16);
            let then = std::array::from_fn(|lane| if lanes[lane] < 16 { lane as u64 } else { lanes[lane] as u64 - 8 });
            [first, then]
        };
        let Pattern { linear, weights, jacobian, gains } = Pattern::new(law);
        let (mut partners, mut ends) = (Vec::new(), Vec::new());
        for quantity in 0..law.quantities() {
            for (number, &[a, b]) in law.products.iter().enumerate() {
                partners.extend((a == quantity).then_some((number as u8, b as u8)));
                partners.extend((b == quantity).then_some((number as u8, a as u8)));
            }
            ends.push(partners.len() as u8);
        }
        let fours = [linear, weights, jacobian, gains].map(|columns| Fours::new(&columns));
        let mut is_solved = [0; B];
        (law.moving..law.quantities()).for_each(|quantity| is_solved[quantity / 8] |= 1 << (quantity % 8));
        let zero = Wide::zero();
        Box::new(Kernel {
            law: law.clone(),
            values: Vec::new(),
            fours,
            constants: [zero; B],
            linear: [[[zero; B]; 8]; B],
            weights: [[[zero; B]; 8]; G],
            jacobian: [[[zero; B]; 8]; B],
            gains: [[[zero; B]; 8]; G],
            partners,
            ends,
            factors: std::array::from_fn(|group| [shuffles(group, 0), shuffles(group, 1)]),
            rows: vec![Row::empty(); law.solved.len()],
            reciprocals: std::array::from_fn(|k| if k == 0 { S::zero() } else { S::ratio(1, k as i64) }),
            is_solved,
            left: [[zero; G]; ROOM],
            right: [[zero; G]; ROOM],
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
        self.gains = self.weights;
        self.values = values.to_vec();
    }

    /// The derivatives of the rates at a point by all quantities: L, and each product's weight times the one factor in the
    /// column of the other.
    #[inline(always)]
    pub(super) fn linearise<P: Pick<S>>(&mut self, pick: P, point: &[[S; 8]; B]) {
        let (weights, point) = (self.weights.as_flattened(), point.as_flattened());
        let columns = self.jacobian.as_flattened_mut().iter_mut().zip(self.linear.as_flattened());
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

    /// The factors on one side of all products.
    #[inline(always)]
    pub(super) fn pick<P: Pick<S>>(&self, pick: P, side: usize, from: &[P::Eight; B]) -> [P::Eight; G] {
        let mut picked = [pick.all(S::zero()); G];
        for (picked, shuffles) in picked.iter_mut().zip(&self.factors) {
            let [first, then] = &shuffles[side];
            *picked = pick.shuffle([from[0], from[1 % B]], first);
            if B > 2 {
                *picked = pick.shuffle([*picked, from[2 % B]], then);
            }
        }
        picked
    }
}
