//! The factors of all products, order by order, and their Cauchy sums.

use super::law::Law;
use super::round::round;
use crate::fused::Fused;
use crate::small::permutation::{Permute, Shuffle};
use crate::small::wide::Wide;

/// The highest supported order.
pub(crate) const MOST_ORDER: usize = 64;

/// The number of sums computed concurrently, to hide latency.
pub(super) const CHAINS: usize = 2;

pub(super) type Chains<E, const G: usize> = [[E; G]; CHAINS];

/// 1/k for each order: y_(k+1) = f(y)_k / (k+1).
pub(super) fn reciprocals<S: Fused>() -> [S; MOST_ORDER + 1] {
    std::array::from_fn(|k| if k == 0 { S::zero() } else { S::ratio(1, k as i64) })
}

/// The quantities that are factors of G groups of eight products.
#[derive(Clone, Debug)]
pub(super) struct Places<const G: usize> {
    /// For each side: permutations of the first sixteen quantities, then of these and the rest.
    shuffles: [[[Shuffle; 2]; 2]; G],
}

impl<const G: usize> Places<G> {
    pub fn new(law: &Law) -> Self {
        let quantity = |number: usize, side: usize| law.products.get(number).map_or(0, |factors| factors[side]);
        let shuffles = |group: usize, side: usize| -> [Shuffle; 2] {
            let lanes: [usize; 8] = std::array::from_fn(|lane| quantity(8 * group + lane, side));
            let first = std::array::from_fn(|lane| lanes[lane] as u64 % 16);
            let then = std::array::from_fn(|lane| if lanes[lane] < 16 { lane as u64 } else { lanes[lane] as u64 - 8 });
            [Shuffle(first), Shuffle(then)]
        };
        Places { shuffles: std::array::from_fn(|group| [shuffles(group, 0), shuffles(group, 1)]) }
    }

    /// The factors a and b of all products, gathered from all quantities.
    #[inline(always)]
    pub fn pick<S: Fused, P: Permute<S>, const B: usize>(&self, pick: P, from: &[P::Eight; B]) -> [[P::Eight; G]; 2] {
        let mut picked = [[pick.all(S::zero()); G]; 2];
        for (side, picked) in picked.iter_mut().enumerate() {
            // unrolled by hand: the compiler would not always unroll a loop, and would keep the factors in memory
            picked[0] = self.eight(pick, [0, side], from);
            if G > 1 {
                picked[1 % G] = self.eight(pick, [1, side], from);
            }
            if G > 2 {
                picked[2 % G] = self.eight(pick, [2, side], from);
            }
        }
        picked
    }

    #[inline(always)]
    fn eight<S: Fused, P: Permute<S>, const B: usize>(
        &self,
        pick: P,
        [group, side]: [usize; 2],
        from: &[P::Eight; B],
    ) -> P::Eight {
        let [first, then] = &self.shuffles[group][side];
        let eight = pick.shuffle([from[0], from[1 % B]], first);
        if B > 2 { pick.shuffle([eight, from[2 % B]], then) } else { eight }
    }
}

/// The factors of all orders so far.
#[derive(Clone, Debug)]
pub(super) struct Factors<S: Fused, const G: usize> {
    /// a_j at index j.
    left: [[Wide<S>; G]; MOST_ORDER + 1],
    /// b_j at index MOST_ORDER - j.
    right: [[Wide<S>; G]; MOST_ORDER + 1],
}

impl<S: Fused, const G: usize> Factors<S, G> {
    pub fn new() -> Self {
        let zero = [Wide::zero(); G];
        Factors { left: [zero; MOST_ORDER + 1], right: [zero; MOST_ORDER + 1] }
    }

    /// Stores a_k and b_k.
    #[inline(always)]
    pub fn keep<P: Permute<S>>(&mut self, pick: P, k: usize, [a, b]: &[[P::Eight; G]; 2]) {
        for group in 0..G {
            self.left[k][group].0 = pick.store(a[group]);
            self.right[MOST_ORDER - k][group].0 = pick.store(b[group]);
        }
    }

    /// a_k and b_k of a group.
    #[inline(always)]
    pub fn at<P: Permute<S>>(&self, pick: P, k: usize, group: usize) -> [P::Eight; 2] {
        [pick.load(&self.left[k][group].0), pick.load(&self.right[MOST_ORDER - k][group].0)]
    }

    /// The sum a_i b_(k-1) + a_(i+1) b_(k-2) + .. + a_(k-1) b_i, as two independent partial sums.
    ///
    /// A factor loaded for one order is used for the next one too: `ahead` has the sum of every second order except its
    /// two end terms. Orders must be computed in sequence, starting before i.
    #[inline(always)]
    pub fn older<P: Permute<S>>(
        &self,
        pick: P,
        i: usize,
        k: usize,
        ahead: &mut Chains<P::Eight, G>,
    ) -> Chains<P::Eight, G> {
        if (i + k) % 2 == 1 {
            let [sums, next] = self.two(pick, i, k);
            *ahead = next;
            return sums;
        }
        let mut sums = *ahead;
        if k > i + 1 {
            for (sums, [left, right]) in sums.iter_mut().zip([[i, k - 1], [k - 1, i]]) {
                for (group, sum) in sums.iter_mut().enumerate() {
                    let (a, b) = (&self.left[left][group].0, &self.right[MOST_ORDER - right][group].0);
                    *sum = pick.plus_product(*sum, pick.load(a), pick.load(b));
                }
            }
        }
        sums
    }

    /// The sum of this order, and the inner part of the next one: a_(i+1) b_(k-1) + .. + a_(k-1) b_(i+1).
    #[inline(always)]
    fn two<P: Permute<S>>(&self, pick: P, i: usize, k: usize) -> [Chains<P::Eight, G>; 2] {
        let nothing = pick.all(S::zero());
        let (mut sums, mut next, mut before) = ([[nothing; G]; CHAINS], [[nothing; G]; CHAINS], [nothing; G]);
        let ((a, a_last), (b, _)) =
            (self.left[i.min(k)..k].as_chunks::<CHAINS>(), self.right[MOST_ORDER + 1 - k..].as_chunks::<CHAINS>());
        for (a, b) in a.iter().zip(b) {
            for chain in 0..CHAINS {
                for group in 0..G {
                    let (a, b) = (pick.load(&a[chain][group].0), pick.load(&b[chain][group].0));
                    sums[chain][group] = pick.plus_product(sums[chain][group], a, b);
                    next[chain][group] = pick.plus_product(next[chain][group], a, before[group]);
                    before[group] = b;
                }
            }
        }
        for a in a_last {
            for group in 0..G {
                let (a, b) = (pick.load(&a[group].0), pick.load(&self.right[MOST_ORDER - i][group].0));
                sums[0][group] = pick.plus_product(sums[0][group], a, b);
                next[0][group] = pick.plus_product(next[0][group], a, before[group]);
            }
        }
        [sums, next]
    }
}

impl<const G: usize> Factors<f64, G> {
    /// Copies the first `orders` orders from a finer type, rounded; order 0 is used by no sum.
    #[inline(always)]
    pub fn take<S: Fused>(&mut self, finer: &Factors<S, G>, orders: usize) {
        let (left, right) = (1..orders.max(1), MOST_ORDER + 1 - orders.max(1)..MOST_ORDER);
        round(&mut self.left[left.clone()], &finer.left[left]);
        round(&mut self.right[right.clone()], &finer.right[right]);
    }
}
