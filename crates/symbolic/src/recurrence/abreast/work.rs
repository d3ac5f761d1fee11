//! All orders of a series, and its sum: what is compiled for each set of instructions.

use super::Abreast;
use field::Lanes;
use pulp::{Simd, WithSimd};

/// All orders, compiled once for each set of instructions.
pub(super) struct Expand<'a, 'b, 'c, const L: usize, const N: usize, const FUSED: bool> {
    pub abreast: &'a mut Abreast<'b, L, N>,
    pub states: &'c [Lanes<L>],
    pub time: Lanes<L>,
}

impl<const L: usize, const N: usize, const FUSED: bool> Expand<'_, '_, '_, L, N, FUSED> {
    #[inline(always)]
    pub fn run(self) {
        let Abreast { order, stages, rates, now, series, width, factors, length, points, inputs, circle, .. } =
            self.abreast;
        let n = self.abreast.states.min(self.states.len());
        inputs[..n].copy_from_slice(&self.states[..n]);
        let mut moving = self.abreast.states;
        if self.abreast.time {
            inputs[moving] = self.time;
            moving += 1;
        }
        series[..moving].copy_from_slice(&inputs[..moving]);
        if !circle.is_empty() {
            points.evaluate(inputs, circle);
            series[moving..][..circle.len()].copy_from_slice(circle);
        }
        for k in 0..*order {
            let (known, next) = series.split_at_mut((k + 1) * *width);
            now[..*width].copy_from_slice(&known[k * *width..]);
            for stage in &mut *stages {
                stage.sums.sums::<FUSED, N>(k, now, |now, place, sum| now[place] = sum);
                for (place, slot) in &stage.factors {
                    let factor = &mut factors[usize::from(*slot) * *length..][..*length];
                    // nothing is known of what is newer
                    (factor[k], factor[k + 1]) = (now[usize::from(*place) % N], Lanes::all(0.0));
                }
                for product in &mut stage.products {
                    let [a, b] = [product.a, product.b].map(|slot| &factors[usize::from(slot) * *length..][..k + 2]);
                    let value = if k % 2 == 0 {
                        let [value, next] = two_orders::<L, FUSED>(a, &b[..=k]);
                        product.next = next;
                        value
                    } else {
                        product.next.plus_product(a[0], b[k], FUSED).plus_product(a[k], b[0], FUSED)
                    };
                    now[usize::from(product.place) % N] = value;
                }
                stage.reciprocals.iter_mut().for_each(|each| each.reciprocal(k, &mut now[..]));
                stage.roots.iter_mut().for_each(|each| each.root(k, &mut now[..]));
            }
            // x_(k+1) = (x')_k / (k + 1)
            let reciprocal = Lanes::all(1.0 / (k + 1) as f64);
            let next = &mut next[..*width];
            rates.sums::<FUSED, N>(k, now, |_, place, sum| next[place] = sum * reciprocal);
        }
    }
}

/// Sums that run side by side: none waits for the addition before.
pub(super) const CHAINS: usize = 4;

/// sum_j a_j b_(k-j), and of the next order what the same numbers give: sum_j a_(j+1) b_(k-j), where a_(k+1) is zero.
#[inline(always)]
fn two_orders<const L: usize, const FUSED: bool>(a: &[Lanes<L>], b: &[Lanes<L>]) -> [Lanes<L>; 2] {
    let zero = Lanes::all(0.0);
    let (mut sums, mut nexts) = ([zero; CHAINS], [zero; CHAINS]);
    let mut newer = a[1..=b.len()].chunks_exact(CHAINS);
    let mut older = b.rchunks_exact(CHAINS);
    let mut first = a[0];
    for (x, y) in (&mut newer).zip(&mut older) {
        let before = [first, x[0], x[1], x[2]];
        for chain in 0..CHAINS {
            sums[chain] = sums[chain].plus_product(before[chain], y[CHAINS - 1 - chain], FUSED);
            nexts[chain] = nexts[chain].plus_product(x[chain], y[CHAINS - 1 - chain], FUSED);
        }
        first = x[CHAINS - 1];
    }
    // the few that are left: an index that is not known beforehand would bring all sums into memory
    for (x, y) in newer.remainder().iter().zip(older.remainder().iter().rev()) {
        sums[0] = sums[0].plus_product(first, *y, FUSED);
        nexts[0] = nexts[0].plus_product(*x, *y, FUSED);
        first = *x;
    }
    let together = |[a, b, c, d]: [Lanes<L>; CHAINS]| (a + b) + (c + d);
    [together(sums), together(nexts)]
}

impl<const L: usize, const N: usize> WithSimd for Expand<'_, '_, '_, L, N, true> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.run();
    }
}

pub(super) struct Sum<'a, const L: usize, const FUSED: bool> {
    pub series: &'a [Lanes<L>],
    pub width: usize,
    pub h: Lanes<L>,
    pub out: &'a mut [Lanes<L>],
}

impl<const L: usize, const FUSED: bool> Sum<'_, L, FUSED> {
    #[inline(always)]
    pub fn run(self) {
        for (block, out) in self.out.chunks_mut(CHAINS).enumerate() {
            let mut sums = [Lanes::all(0.0); CHAINS];
            for row in self.series.chunks_exact(self.width).rev() {
                let terms = &row[block * CHAINS..][..CHAINS];
                for chain in 0..CHAINS {
                    sums[chain] = terms[chain].plus_product(sums[chain], self.h, FUSED);
                }
            }
            out.iter_mut().zip(sums).for_each(|(out, sum)| *out = sum);
        }
    }
}

impl<const L: usize> WithSimd for Sum<'_, L, true> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        self.run();
    }
}
