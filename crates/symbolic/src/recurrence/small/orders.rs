//! All orders of a small series after the first, the work of each in registers.
//!
//! For k > 0
//!
//!   f(y)_k = J y_k + W m_k ,    m_k = a_1 b_(k-1) + .. + a_(k-1) b_1 for each product a b ,
//!
//! with J the Jacobian of f at y_0. An order waits for y_k only by way of J; W m_k is summed meanwhile, as soon as y_(k-1) is
//! known. Of what a processor does in one order of a small system most is waiting, and this halves it.

use super::law::Law;
use super::matrix::{Fours, Matrix, Wide, times};
use super::pattern::Pattern;
use crate::recurrence::fused::Fused;
use crate::recurrence::pick::{Pick, Shuffle};
use crate::recurrence::stored::Stored;
use std::ops::Range;

/// So many orders there is room for: more than any tolerance asks for.
pub(in crate::recurrence) const MOST_ORDER: usize = 64;

/// Sums that run side by side: none waits for the addition before.
const CHAINS: usize = 2;

/// Room for the series to this order and for chains that go too far.
const ROOM: usize = MOST_ORDER + 2 * CHAINS;

/// What is where, whatever the numbers are.
#[derive(Clone, Debug)]
pub(super) struct Shape<const B: usize, const G: usize> {
    pub linear: Fours<B>,
    pub weights: Fours<B>,
    jacobian: Fours<B>,
    gains: Fours<B>,
    /// Which quantities the factors are, among the first sixteen; then among these and the rest.
    factors: [[[Shuffle; 2]; 2]; G],
    /// A bit for each quantity that is solved for, and whether there is any.
    is_solved: [u8; B],
    pub solves: bool,
}

impl<const B: usize, const G: usize> Shape<B, G> {
    pub fn new(law: &Law, pattern: &Pattern) -> Self {
        let quantity = |number: usize, side: usize| law.products.get(number).map_or(0, |factors| factors[side]);
        let shuffles = |group: usize, side: usize| -> [Shuffle; 2] {
            let lanes: [usize; 8] = std::array::from_fn(|lane| quantity(8 * group + lane, side));
            let first = std::array::from_fn(|lane| lanes[lane] as u64 % 16);
            let then = std::array::from_fn(|lane| if lanes[lane] < 16 { lane as u64 } else { lanes[lane] as u64 - 8 });
            [Shuffle(first), Shuffle(then)]
        };
        let mut is_solved = [0; B];
        (law.moving..law.quantities()).for_each(|quantity| is_solved[quantity / 8] |= 1 << (quantity % 8));
        Shape {
            linear: Fours::new(&pattern.linear),
            weights: Fours::new(&pattern.weights),
            jacobian: Fours::new(&pattern.jacobian),
            gains: Fours::new(&pattern.gains),
            factors: std::array::from_fn(|group| [shuffles(group, 0), shuffles(group, 1)]),
            is_solved,
            solves: !law.solved.is_empty(),
        }
    }

    /// The factors on one side of all products.
    #[inline(always)]
    pub fn pick<S: Fused, P: Pick<S>>(&self, pick: P, side: usize, from: &[P::Eight; B]) -> [P::Eight; G] {
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

/// Between two orders: f(y)_(k-1), what is known of f(y)_k without y_k, and y_k.
#[derive(Clone, Copy)]
pub(super) struct Between<E, const B: usize> {
    pub sums: [E; B],
    pub rest: [E; B],
    pub newest: [E; B],
}

/// The law at the point of an expansion, and the factors so far.
#[derive(Clone, Debug)]
pub(super) struct Orders<S: Fused, const B: usize, const G: usize> {
    /// J and W.
    pub jacobian: Matrix<S, B, B>,
    pub gains: Matrix<S, B, G>,
    /// 1/k
    reciprocals: [S; MOST_ORDER + 1],
    /// a_j at j.
    left: [[Wide<S>; G]; ROOM],
    /// b_j at MOST_ORDER - j.
    right: [[Wide<S>; G]; ROOM],
}

impl<S: Fused, const B: usize, const G: usize> Orders<S, B, G> {
    pub fn new() -> Self {
        let zero = Wide::zero();
        Orders {
            jacobian: [[[zero; B]; 8]; B],
            gains: [[[zero; B]; 8]; G],
            reciprocals: std::array::from_fn(|k| if k == 0 { S::zero() } else { S::ratio(1, k as i64) }),
            left: [[zero; G]; ROOM],
            right: [[zero; G]; ROOM],
        }
    }

    /// Takes the factors of order 0.
    #[inline(always)]
    pub fn begin<P: Pick<S>>(&mut self, pick: P, b: &[P::Eight; G]) {
        self.left[..=CHAINS].fill([Wide::zero(); G]);
        for (own, b) in self.right[MOST_ORDER].iter_mut().zip(b) {
            own.0 = pick.store(*b);
        }
    }

    /// Takes a_k and b_k, and sums a_1 b_k + .. + a_k b_1.
    #[inline(always)]
    fn middle<P: Pick<S>>(&mut self, pick: P, k: usize, [a, b]: [[P::Eight; G]; 2]) -> [P::Eight; G] {
        // a is zero from k on: the last chains may go too far
        let middle = k.saturating_sub(2).next_multiple_of(CHAINS);
        let (a_older, b_older) = (&self.left[2..][..middle], &self.right[MOST_ORDER - k + 1..][..middle]);
        let mut chains = [[pick.all(S::zero()); G]; CHAINS];
        for (a, b) in a_older.as_chunks::<CHAINS>().0.iter().zip(b_older.as_chunks::<CHAINS>().0) {
            for chain in 0..CHAINS {
                for group in 0..G {
                    let (a, b) = (pick.load(&a[chain][group].0), pick.load(&b[chain][group].0));
                    chains[chain][group] = pick.plus_product(chains[chain][group], a, b);
                }
            }
        }
        self.left[k + CHAINS] = [Wide::zero(); G];
        let mut sums = chains[0];
        for group in 0..G {
            self.left[k][group].0 = pick.store(a[group]);
            self.right[MOST_ORDER - k][group].0 = pick.store(b[group]);
            let (oldest_a, oldest_b) = (&self.left[1][group].0, &self.right[MOST_ORDER - 1][group].0);
            let both = pick.plus(chains[0][group], chains[1][group]);
            sums[group] = pick.plus_product(both, a[group], pick.load(oldest_b));
            if k > 1 {
                sums[group] = pick.plus_product(sums[group], pick.load(oldest_a), b[group]);
            }
        }
        sums
    }

    /// Finds y_(k+1) for these k, into the rows of the series.
    #[inline(always)]
    pub fn run<P: Pick<S>, R: From<S>>(
        &mut self,
        pick: P,
        shape: &Shape<B, G>,
        orders: Range<usize>,
        Between { mut sums, mut rest, mut newest }: Between<P::Eight, B>,
        rows: &mut [[R; 8]],
    ) -> Between<P::Eight, B> {
        for k in orders {
            if k > 0 {
                // y_k = sums / k: the division need not be waited for
                let known = times(pick, &self.jacobian, &sums, &shape.jacobian);
                for block in 0..B {
                    sums[block] = pick.plus_product(rest[block], known[block], pick.all(self.reciprocals[k]));
                    if shape.solves {
                        newest[block] = pick.blend(shape.is_solved[block], newest[block], sums[block]);
                    }
                }
                let factors = [shape.pick(pick, 0, &newest), shape.pick(pick, 1, &newest)];
                let older = self.middle(pick, k, factors);
                rest = times(pick, &self.gains, &older, &shape.gains);
            }
            for block in 0..B {
                newest[block] = pick.product(sums[block], pick.all(self.reciprocals[k + 1]));
                let stored = pick.store(newest[block]);
                rows[(k + 1) * B + block] = std::array::from_fn(|lane| R::from(stored.lane(lane)));
            }
        }
        Between { sums, rest, newest }
    }
}

impl<const B: usize, const G: usize> Orders<f64, B, G> {
    /// Takes over from a finer field after so many orders.
    #[inline(always)]
    pub fn take<S: Fused>(&mut self, finer: &Orders<S, B, G>, orders: usize) {
        round(self.jacobian.as_flattened_mut(), finer.jacobian.as_flattened());
        round(self.gains.as_flattened_mut(), finer.gains.as_flattened());
        round(&mut self.left[..orders + CHAINS], &finer.left[..orders + CHAINS]);
        let (first, end) = (MOST_ORDER + 1 - orders, MOST_ORDER + 1);
        round(&mut self.right[first..end], &finer.right[first..end]);
    }
}

#[inline(always)]
fn round<S: Fused, const N: usize>(own: &mut [[Wide<f64>; N]], finer: &[[Wide<S>; N]]) {
    for (own, finer) in own.as_flattened_mut().iter_mut().zip(finer.as_flattened()) {
        own.0 = finer.0.rounded();
    }
}
