//! All orders of a small series, the work of each in registers.
//!
//! For k > 0
//!
//!   f(y)_k = J y_k + W m_k ,    m_k = a_1 b_(k-1) + .. + a_(k-1) b_1 for each product a b ,
//!
//! with J the Jacobian of f at y_0. An order waits for y_k only by way of J; W m_k is summed meanwhile, as soon as y_(k-1) is
//! known. Of what a processor does in one order of a small system most is waiting, and this halves it.

use super::kernel::{CHAINS, Fours, Kernel, MOST_ORDER, Matrix, Wide, ZERO};
use crate::recurrence::fused::Task;
use crate::recurrence::layout::Lanes;
use crate::recurrence::pick::Pick;

/// 1/k
const RECIPROCALS: [f64; MOST_ORDER + 1] = {
    let mut reciprocals = [0.0; MOST_ORDER + 1];
    let mut k = 1;
    while k <= MOST_ORDER {
        reciprocals[k] = 1.0 / k as f64;
        k += 1;
    }
    reciprocals
};

impl<const B: usize, const G: usize> Kernel<B, G> {
    /// Takes a_k and b_k, and sums a_1 b_k + .. + a_k b_1.
    #[inline(always)]
    fn middle<P: Pick<f64>>(&mut self, pick: P, k: usize, newest: &[P::Eight; B]) -> [P::Eight; G] {
        let (a, b) = (self.pick(pick, 0, newest), self.pick(pick, 1, newest));
        // a is zero from k on: the last chains may go too far
        let middle = k.saturating_sub(2).next_multiple_of(CHAINS);
        let (a_older, b_older) = (&self.left[2..][..middle], &self.right[MOST_ORDER - k + 1..][..middle]);
        let mut chains = [[pick.load(&ZERO.0); G]; CHAINS];
        for (a, b) in a_older.as_chunks::<CHAINS>().0.iter().zip(b_older.as_chunks::<CHAINS>().0) {
            for chain in 0..CHAINS {
                for group in 0..G {
                    let factors = [a[chain][group], b[chain][group]].map(|eight| pick.load(&eight.0));
                    chains[chain][group] = pick.plus_product(chains[chain][group], factors[0], factors[1]);
                }
            }
        }
        self.left[k] = a.map(|eight| Lanes(pick.store(eight)));
        self.left[k + CHAINS] = [ZERO; G];
        self.right[MOST_ORDER - k] = b.map(|eight| Lanes(pick.store(eight)));
        let [first, second] = chains;
        std::array::from_fn(|group| {
            let (oldest_a, oldest_b) = (&self.left[1][group].0, &self.right[MOST_ORDER - 1][group].0);
            let sum = pick.plus_product(pick.plus(first[group], second[group]), a[group], pick.load(oldest_b));
            if k > 1 { pick.plus_product(sum, pick.load(oldest_a), b[group]) } else { sum }
        })
    }
}

/// sum_c matrix_c x_c over so many fours of columns.
#[inline(always)]
fn times<P: Pick<f64>, const B: usize, const C: usize>(
    pick: P,
    matrix: &Matrix<B, C>,
    x: &[P::Eight; C],
    fours: Fours,
) -> [P::Eight; B] {
    let mut sums = [[pick.load(&ZERO.0); B]; 4];
    // written out: as loops they would not be unrolled, and the sums not kept in registers
    four::<P, B, C, 0>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 1>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 2>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 3>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 4>(pick, &mut sums, matrix, x, fours);
    four::<P, B, C, 5>(pick, &mut sums, matrix, x, fours);
    let [a, b, c, d] = sums;
    std::array::from_fn(|block| pick.plus(pick.plus(a[block], b[block]), pick.plus(c[block], d[block])))
}

/// Adds four columns, if there are so many.
#[inline(always)]
fn four<P: Pick<f64>, const B: usize, const C: usize, const FOUR: usize>(
    pick: P,
    [a, b, c, d]: &mut [[P::Eight; B]; 4],
    matrix: &Matrix<B, C>,
    x: &[P::Eight; C],
    fours: Fours,
) {
    if FOUR >= 2 * C || FOUR >= fours.count {
        return;
    }
    let (columns, x, first) = (&matrix[FOUR / 2 % C], x[FOUR / 2 % C], FOUR % 2 * 4);
    let x = [0, 1, 2, 3].map(|chain| pick.spread(x, first + chain));
    if B == 1 || fours.far >> FOUR & 1 == 0 {
        column(pick, &mut a[..1], &columns[first], x[0]);
        column(pick, &mut b[..1], &columns[first + 1], x[1]);
        column(pick, &mut c[..1], &columns[first + 2], x[2]);
        column(pick, &mut d[..1], &columns[first + 3], x[3]);
    } else {
        column(pick, a, &columns[first], x[0]);
        column(pick, b, &columns[first + 1], x[1]);
        column(pick, c, &columns[first + 2], x[2]);
        column(pick, d, &columns[first + 3], x[3]);
    }
}

#[inline(always)]
fn column<P: Pick<f64>>(pick: P, sums: &mut [P::Eight], column: &[Wide], x: P::Eight) {
    for (sum, own) in sums.iter_mut().zip(column) {
        *sum = pick.plus_product(*sum, pick.load(&own.0), x);
    }
}

/// Expands the solution whose first coefficients stand at the head of the series.
pub(super) struct Expand<'a, const B: usize, const G: usize> {
    pub kernel: &'a mut Kernel<B, G>,
    pub series: &'a mut [f64],
}

impl<const B: usize, const G: usize> Task<f64> for Expand<'_, B, G> {
    #[inline(always)]
    fn run<P: Pick<f64>>(self, pick: P) {
        let Expand { kernel, series } = self;
        let (rows, _) = series.as_chunks_mut::<8>();
        let order = (rows.len() / B).saturating_sub(1).min(MOST_ORDER);
        let ([quantities, moving, products], solves) = (kernel.fours, !kernel.law.solved.is_empty());
        let mut point = [[0.0; 8]; B];
        point.copy_from_slice(&rows[..B]);
        if solves {
            kernel.solve(&mut point);
        }
        kernel.linearise(pick, &point);
        if solves {
            kernel.eliminate(pick, &point);
        }
        let mut newest = point.map(|eight| pick.load(&eight));
        let (a, b) = (kernel.pick(pick, 0, &newest), kernel.pick(pick, 1, &newest));
        kernel.left[..=CHAINS].fill([ZERO; G]);
        kernel.right[MOST_ORDER] = b.map(|eight| Lanes(pick.store(eight)));
        let first: [P::Eight; G] = std::array::from_fn(|group| pick.product(a[group], b[group]));
        // f(y_0) itself, then what y_0 brings to the later orders stands in J
        let linear = times(pick, &kernel.linear, &newest, quantities);
        let quadratic = times(pick, &kernel.weights, &first, products);
        let mut sums: [P::Eight; B] = std::array::from_fn(|block| {
            pick.plus(pick.plus(quadratic[block], pick.load(&kernel.constants[block].0)), linear[block])
        });
        let mut rest = [pick.load(&ZERO.0); B];
        for k in 0..order {
            if k > 0 {
                // y_k = sums / k: the division need not be waited for
                let known = times(pick, &kernel.jacobian, &sums, moving);
                for block in 0..B {
                    sums[block] = pick.plus_product(rest[block], known[block], pick.load(&[RECIPROCALS[k]; 8]));
                    if solves {
                        newest[block] = pick.blend(kernel.is_solved[block], newest[block], sums[block]);
                    }
                }
                let older = kernel.middle(pick, k, &newest);
                rest = times(pick, &kernel.gains, &older, products);
            }
            for block in 0..B {
                newest[block] = pick.product(sums[block], pick.load(&[RECIPROCALS[k + 1]; 8]));
                rows[(k + 1) * B + block] = pick.store(newest[block]);
            }
        }
    }
}
