//! All orders of a small series, the work of each in registers.
//!
//! For k > 0
//!
//!   f(y)_k = J y_k + W m_k ,    m_k = a_1 b_(k-1) + .. + a_(k-1) b_1 for each product a b ,
//!
//! with J the Jacobian of f at y_0. An order waits for y_k only by way of J; W m_k is summed meanwhile, as soon as y_(k-1) is
//! known. Of what a processor does in one order of a small system most is waiting, and this halves it.

use super::kernel::{CHAINS, Fours, Kernel, MOST_ORDER, Matrix, Wide};
use crate::recurrence::fused::{Fused, Task};
use crate::recurrence::pick::Pick;
use crate::recurrence::stored::Stored;

impl<S: Fused, const B: usize, const G: usize> Kernel<S, B, G> {
    /// Takes a_k and b_k, and sums a_1 b_k + .. + a_k b_1.
    #[inline(always)]
    fn middle<P: Pick<S>>(&mut self, pick: P, k: usize, newest: &[P::Eight; B]) -> [P::Eight; G] {
        let (a, b) = (self.pick(pick, 0, newest), self.pick(pick, 1, newest));
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
}

/// sum_c matrix_c x_c over the columns that count.
#[inline(always)]
fn times<S: Fused, P: Pick<S>, const B: usize, const C: usize>(
    pick: P,
    matrix: &Matrix<S, B, C>,
    x: &[P::Eight; C],
    fours: &Fours<B>,
) -> [P::Eight; B] {
    let mut sums = [[pick.all(S::zero()); B]; 4];
    // written out: as loops they would not be unrolled, and the sums not kept in registers
    four::<S, P, B, C, 0>(pick, &mut sums, matrix, x, fours);
    four::<S, P, B, C, 1>(pick, &mut sums, matrix, x, fours);
    four::<S, P, B, C, 2>(pick, &mut sums, matrix, x, fours);
    four::<S, P, B, C, 3>(pick, &mut sums, matrix, x, fours);
    four::<S, P, B, C, 4>(pick, &mut sums, matrix, x, fours);
    four::<S, P, B, C, 5>(pick, &mut sums, matrix, x, fours);
    let [mut a, b, c, d] = sums;
    for group in 0..B {
        a[group] = pick.plus(pick.plus(a[group], b[group]), pick.plus(c[group], d[group]));
    }
    a
}

/// Adds four columns where they count.
#[inline(always)]
fn four<S: Fused, P: Pick<S>, const B: usize, const C: usize, const FOUR: usize>(
    pick: P,
    sums: &mut [[P::Eight; B]; 4],
    matrix: &Matrix<S, B, C>,
    x: &[P::Eight; C],
    fours: &Fours<B>,
) {
    if FOUR >= 2 * C || fours.any >> FOUR & 1 == 0 {
        return;
    }
    let (columns, x, first) = (&matrix[FOUR / 2 % C], x[FOUR / 2 % C], FOUR % 2 * 4);
    let mut spread = [x; 4];
    for (chain, spread) in spread.iter_mut().enumerate() {
        *spread = pick.spread(x, first + chain);
    }
    let four = &columns[first..first + 4];
    rows::<S, P, B, FOUR, 0>(pick, sums, four, &spread, fours);
    rows::<S, P, B, FOUR, 1>(pick, sums, four, &spread, fours);
    rows::<S, P, B, FOUR, 2>(pick, sums, four, &spread, fours);
}

/// Their rows of one group.
#[inline(always)]
fn rows<S: Fused, P: Pick<S>, const B: usize, const FOUR: usize, const GROUP: usize>(
    pick: P,
    sums: &mut [[P::Eight; B]; 4],
    columns: &[[Wide<S>; B]],
    x: &[P::Eight; 4],
    fours: &Fours<B>,
) {
    if GROUP < B && fours.groups[GROUP % B] >> FOUR & 1 == 1 {
        for ((sum, own), x) in sums.iter_mut().zip(columns).zip(x) {
            sum[GROUP % B] = pick.plus_product(sum[GROUP % B], pick.load(&own[GROUP % B].0), *x);
        }
    }
}

/// Expands the solution whose first coefficients stand at the head of the series.
pub(super) struct Expand<'a, S: Fused, const B: usize, const G: usize> {
    pub kernel: &'a mut Kernel<S, B, G>,
    pub series: &'a mut [S],
}

impl<S: Fused, const B: usize, const G: usize> Task<S> for Expand<'_, S, B, G> {
    #[inline(always)]
    fn run<P: Pick<S>>(self, pick: P) {
        let Expand { kernel, series } = self;
        let (rows, _) = series.as_chunks_mut::<8>();
        let order = (rows.len() / B).saturating_sub(1).min(MOST_ORDER);
        let ([linear_fours, weights_fours, jacobian_fours, gains_fours], solves) =
            (kernel.fours, !kernel.law.solved.is_empty());
        let mut point = [[S::zero(); 8]; B];
        point.copy_from_slice(&rows[..B]);
        if solves {
            kernel.solve(&mut point);
        }
        kernel.linearise(pick, &point);
        if solves {
            kernel.eliminate(pick, &point);
        }
        let mut newest = [pick.all(S::zero()); B];
        for (newest, eight) in newest.iter_mut().zip(point) {
            *newest = pick.load(&S::Stored::of(eight));
        }
        let (a, b) = (kernel.pick(pick, 0, &newest), kernel.pick(pick, 1, &newest));
        kernel.left[..=CHAINS].fill([Wide::zero(); G]);
        let mut first = [pick.all(S::zero()); G];
        for group in 0..G {
            kernel.right[MOST_ORDER][group].0 = pick.store(b[group]);
            first[group] = pick.product(a[group], b[group]);
        }
        // f(y_0) itself, then what y_0 brings to the later orders stands in J
        let linear = times(pick, &kernel.linear, &newest, &linear_fours);
        let quadratic = times(pick, &kernel.weights, &first, &weights_fours);
        let mut sums = linear;
        for block in 0..B {
            sums[block] = pick.plus(pick.plus(quadratic[block], pick.load(&kernel.constants[block].0)), linear[block]);
        }
        let mut rest = [pick.all(S::zero()); B];
        for k in 0..order {
            if k > 0 {
                // y_k = sums / k: the division need not be waited for
                let known = times(pick, &kernel.jacobian, &sums, &jacobian_fours);
                for block in 0..B {
                    sums[block] = pick.plus_product(rest[block], known[block], pick.all(kernel.reciprocals[k]));
                    if solves {
                        newest[block] = pick.blend(kernel.is_solved[block], newest[block], sums[block]);
                    }
                }
                let older = kernel.middle(pick, k, &newest);
                rest = times(pick, &kernel.gains, &older, &gains_fours);
            }
            for block in 0..B {
                newest[block] = pick.product(sums[block], pick.all(kernel.reciprocals[k + 1]));
                let stored = pick.store(newest[block]);
                rows[(k + 1) * B + block] = std::array::from_fn(|lane| stored.lane(lane));
            }
        }
    }
}
