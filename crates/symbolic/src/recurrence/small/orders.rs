//! All orders of a small series, the work of each in registers.
//!
//! For k > 0
//!
//!   f(y)_k = J y_k + r_k ,    r_k = sum_p w_p (a_1 b_(k-1) + .. + a_(k-1) b_1)_p ,
//!
//! with J the Jacobian of f at y_0. An order waits for y_k only by way of J; r_k is summed meanwhile, as soon as y_(k-1) is
//! known. Of what a processor does in one order of a small system most is waiting, and this halves it.

use super::kernel::{CHAINS, Kernel, MOST_ORDER, Wide, ZERO};
use crate::recurrence::fused::Task;
use crate::recurrence::order::add;
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
    fn middle<P: Pick<f64>>(&mut self, pick: P, k: usize, newest: &[[f64; 8]; B]) -> [[f64; 8]; G] {
        let (a, b) = (self.pick(pick, 0, newest), self.pick(pick, 1, newest));
        // a is zero from k on: the last chains may go too far
        let middle = k.saturating_sub(2).next_multiple_of(CHAINS);
        let (a_older, b_older) = (&self.left[2..][..middle], &self.right[MOST_ORDER - k + 1..][..middle]);
        let mut chains = [[[0.0; 8]; CHAINS]; G];
        for (a, b) in a_older.as_chunks::<CHAINS>().0.iter().zip(b_older.as_chunks::<CHAINS>().0) {
            for chain in 0..CHAINS {
                for group in 0..G {
                    let sum = &mut chains[group][chain];
                    *sum = add::<P, f64, 8>(*sum, a[chain][group].0, b[chain][group].0);
                }
            }
        }
        (self.left[k], self.left[k + CHAINS], self.right[MOST_ORDER - k]) = (a, [ZERO; G], b);
        let mut sums = [[0.0; 8]; G];
        for group in 0..G {
            let [first, second] = chains[group];
            let sum = add::<P, f64, 8>(plus(first, second), a[group].0, self.right[MOST_ORDER - 1][group].0);
            sums[group] = if k > 1 { add::<P, f64, 8>(sum, self.left[1][group].0, b[group].0) } else { sum };
        }
        sums
    }
}

/// sum_c matrix_c x_c
#[inline(always)]
fn times<P: Pick<f64>, const B: usize, const C: usize>(
    matrix: &[[[Wide; B]; 8]; C],
    x: &[[f64; 8]; C],
) -> [[f64; 8]; B] {
    let mut sums = [[[0.0; 8]; 4]; B];
    for (columns, eight) in matrix.iter().zip(x) {
        for column in 0..8 {
            for block in 0..B {
                let chain = &mut sums[block][column % 4];
                *chain = add::<P, f64, 8>(*chain, columns[column][block].0, [eight[column]; 8]);
            }
        }
    }
    let mut whole = [[0.0; 8]; B];
    for block in 0..B {
        let [a, b, c, d] = sums[block];
        whole[block] = plus(plus(a, b), plus(c, d));
    }
    whole
}

#[inline(always)]
fn plus(mut a: [f64; 8], b: [f64; 8]) -> [f64; 8] {
    for lane in 0..8 {
        a[lane] += b[lane];
    }
    a
}

#[inline(always)]
fn scaled(mut a: [f64; 8], by: f64) -> [f64; 8] {
    for lane in &mut a {
        *lane *= by;
    }
    a
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
        let mut newest = [[0.0; 8]; B];
        newest.copy_from_slice(&rows[..B]);
        kernel.linearise::<P>(&newest);
        let (a, b) = (kernel.pick(pick, 0, &newest), kernel.pick(pick, 1, &newest));
        kernel.left[..=CHAINS].fill([ZERO; G]);
        kernel.right[MOST_ORDER] = b;
        let mut products = [[0.0; 8]; G];
        for group in 0..G {
            products[group] = add::<P, f64, 8>([0.0; 8], a[group].0, b[group].0);
        }
        // f(y_0) itself, then what y_0 brings to the later orders stands in J
        let linear = times::<P, B, B>(&kernel.linear, &newest);
        let mut sums = times::<P, B, G>(&kernel.weights, &products);
        for block in 0..B {
            sums[block] = plus(plus(sums[block], kernel.constants[block].0), linear[block]);
        }
        let mut rest = [[0.0; 8]; B];
        for k in 0..order {
            if k > 0 {
                sums = times::<P, B, B>(&kernel.jacobian, &newest);
                for block in 0..B {
                    sums[block] = plus(sums[block], rest[block]);
                }
                let older = kernel.middle(pick, k, &newest);
                rest = times::<P, B, G>(&kernel.weights, &older);
            }
            for block in 0..B {
                newest[block] = scaled(sums[block], RECIPROCALS[k + 1]);
                rows[(k + 1) * B + block] = newest[block];
            }
        }
    }
}
