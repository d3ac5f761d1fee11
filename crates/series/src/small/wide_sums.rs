//! Sums of quantities and products, c + L y + W m, eight rows at a time.
//!
//! A turn adds one term to each of eight rows: each row selects its own factor from two registers, by one permutation
//! for all rows. The number of turns is that of the terms in the longest row, which is smaller than the number of
//! columns.

use super::law::Sums;
use crate::fused::Fused;
use crate::small::permutation::{Permute, Shuffle};
use crate::small::wide::Wide;
use crate::stored::Stored;

/// The number of pairs of registers: two of quantities, two of products.
const PAIRS: usize = 4;

/// One term of each of eight rows: their coefficients, and the permutation that selects their factors.
#[derive(Clone, Debug)]
struct Turn<S: Fused> {
    weights: Wide<S>,
    of: Shuffle,
}

/// Sums over B groups of eight quantities and G groups of products.
#[derive(Clone, Debug)]
pub(super) struct WideSums<S: Fused, const B: usize, const G: usize> {
    constants: [Wide<S>; B],
    /// The diagonal coefficients: all linear decays are one product.
    own: [Wide<S>; B],
    turns: [[Vec<Turn<S>>; PAIRS]; B],
}

/// A term off the diagonal: its row, its turn within a pair of registers, the place in the pair, and the index of the
/// coefficient.
struct Term {
    row: usize,
    pair: usize,
    turn: usize,
    place: usize,
    number: u32,
}

impl<S: Fused, const B: usize, const G: usize> WideSums<S, B, G> {
    /// Buffers for the coefficients.
    pub fn new(sums: &Sums) -> Self {
        const { assert!(B <= 3 && G <= 3, "one pair of quantities and one more, and so of products") };
        let mut turns: [[Vec<Turn<S>>; PAIRS]; B] = std::array::from_fn(|_| std::array::from_fn(|_| Vec::new()));
        for Term { row, pair, turn, place, .. } in terms(sums) {
            let turns = &mut turns[row / 8][pair];
            // rows with fewer terms add zero times the first place
            turns.resize(turns.len().max(turn + 1), Turn { weights: Wide::zero(), of: Shuffle([0; 8]) });
            turns[turn].of.0[row % 8] = place as u64;
        }
        WideSums { constants: [Wide::zero(); B], own: [Wide::zero(); B], turns }
    }

    /// Sets the coefficients.
    pub fn set(&mut self, sums: &Sums, value: impl Fn(u32) -> S) {
        for &(row, number) in &sums.constants {
            self.constants[row / 8].0.set(row % 8, value(number));
        }
        for &(row, _, number) in sums.linear.iter().filter(|(row, column, _)| row == column) {
            self.own[row / 8].0.set(row % 8, value(number));
        }
        for Term { row, pair, turn, number, .. } in terms(sums) {
            self.turns[row / 8][pair][turn].weights.0.set(row % 8, value(number));
        }
    }

    /// The constants c, which enter order 0 only.
    #[inline(always)]
    pub fn constants<P: Permute<S>>(&self, pick: P) -> [P::Eight; B] {
        let mut constants = [pick.all(S::zero()); B];
        for (constant, own) in constants.iter_mut().zip(&self.constants) {
            *constant = pick.load(&own.0);
        }
        constants
    }

    /// start + L y + W m.
    #[inline(always)]
    pub fn of<P: Permute<S>>(
        &self,
        pick: P,
        start: &[P::Eight; B],
        y: &[P::Eight; B],
        m: &[P::Eight; G],
    ) -> [P::Eight; B] {
        let nothing = pick.all(S::zero());
        let mut all = *start;
        for group in 0..B {
            let mut sums = [pick.product(y[group], pick.load(&self.own[group].0)), start[group], nothing, nothing];
            let [few, more, products, others] = &self.turns[group];
            add(pick, &mut sums, few, [y[0], y[1 % B]]);
            if B > 2 {
                add(pick, &mut sums, more, [y[2 % B]; 2]);
            }
            if G > 0 {
                add(pick, &mut sums, products, [m[0], m[1 % G]]);
            }
            if G > 2 {
                add(pick, &mut sums, others, [m[2 % G]; 2]);
            }
            all[group] = pick.plus(pick.plus(sums[0], sums[1]), pick.plus(sums[2], sums[3]));
        }
        all
    }
}

/// Adds turns to four sums in rotation, to hide latency.
#[inline(always)]
fn add<S: Fused, P: Permute<S>>(pick: P, sums: &mut [P::Eight; 4], turns: &[Turn<S>], from: [P::Eight; 2]) {
    let (fours, rest) = turns.as_chunks::<4>();
    for four in fours {
        sums[0] = with(pick, sums[0], &four[0], from);
        sums[1] = with(pick, sums[1], &four[1], from);
        sums[2] = with(pick, sums[2], &four[2], from);
        sums[3] = with(pick, sums[3], &four[3], from);
    }
    // unrolled by hand: the compiler would not unroll a loop, and would keep the sums in memory
    if let Some(turn) = rest.first() {
        sums[2] = with(pick, sums[2], turn, from);
    }
    if let Some(turn) = rest.get(1) {
        sums[3] = with(pick, sums[3], turn, from);
    }
    if let Some(turn) = rest.get(2) {
        sums[1] = with(pick, sums[1], turn, from);
    }
}

#[inline(always)]
fn with<S: Fused, P: Permute<S>>(pick: P, sum: P::Eight, turn: &Turn<S>, from: [P::Eight; 2]) -> P::Eight {
    pick.plus_product(sum, pick.load(&turn.weights.0), pick.shuffle(from, &turn.of))
}

fn terms(sums: &Sums) -> impl Iterator<Item = Term> {
    let linear = sums.linear.iter().filter(|(row, column, _)| row != column);
    let linear = linear.map(|&(row, quantity, number)| (row, quantity / 16, quantity % 16, number));
    let products = sums.quadratic.iter().map(|&(row, product, number)| (row, 2 + product / 16, product % 16, number));
    let mut before: Vec<[usize; PAIRS]> = Vec::new();
    linear.chain(products).map(move |(row, pair, place, number)| {
        before.resize(before.len().max(row + 1), [0; PAIRS]);
        let turn = before[row][pair];
        before[row][pair] += 1;
        Term { row, pair, turn, place, number }
    })
}
