//! One order of the series: sums, products, quotients and square roots from known coefficients.

use super::fused::Fused;
use super::layout::{Block, CHAINS, Group, Implicit, Laid, Packed};
use super::pick::{Columns, Pick};
use field::Analytic;

/// sum + a b.
#[inline(always)]
pub(super) fn add<P: Pick<S>, S: Fused, const W: usize>(mut sum: [S; W], a: [S; W], b: [S; W]) -> [S; W] {
    for lane in 0..W {
        sum[lane] = sum[lane].plus_product(a[lane], b[lane], P::FUSED);
    }
    sum
}

#[inline(always)]
pub(super) fn together<S: Fused, const W: usize>([mut a, b, mut c, d]: [[S; W]; CHAINS]) -> [S; W] {
    for lane in 0..W {
        a[lane] += b[lane];
        c[lane] += d[lane];
        a[lane] += c[lane];
    }
    a
}

impl<S: Fused, const W: usize> Block<S, W> {
    /// The sums of order k.
    #[inline(always)]
    pub fn sums<P: Pick<S>, const N: usize>(&self, k: usize, now: &Columns<S, N>) -> [S; W] {
        let mut sums = [[S::zero(); W]; CHAINS];
        if k == 0 {
            sums[0] = self.constants.0;
        }
        for (columns, factors) in self.columns.iter().zip(&self.factors) {
            for chain in 0..CHAINS {
                let x = now.0[columns[chain] as usize % N];
                sums[chain] = add::<P, S, W>(sums[chain], factors[chain].0, [x; W]);
            }
        }
        together(sums)
    }
}

impl<S: Fused, const W: usize> Group<S, W> {
    /// The products sum_j a_j b_(k-j), with a_k and b_k from the columns; older terms are summed independently of them.
    #[inline(always)]
    pub fn products<P: Pick<S>, const N: usize>(
        &mut self,
        pick: P,
        k: usize,
        order: usize,
        now: &Columns<S, N>,
    ) -> [S; W] {
        let [a, b] = &self.factors;
        let (newest_a, newest_b) = (pick.pick(now, a), pick.pick(now, b));
        let (left, right) = (&mut self.left[..], &mut self.right[order - k..]);
        // a is zero from k on, b beyond its end: the last chains may exceed the range
        let middle = k.saturating_sub(1).next_multiple_of(CHAINS);
        let mut sums = [[S::zero(); W]; CHAINS];
        for (a, b) in left[1..=middle].chunks_exact(CHAINS).zip(right[1..=middle].chunks_exact(CHAINS)) {
            for chain in 0..CHAINS {
                sums[chain] = add::<P, S, W>(sums[chain], a[chain].0, b[chain].0);
            }
        }
        let mut sum = together(sums);
        left[k + CHAINS] = Packed::zero();
        (left[k], right[0]) = (Packed(newest_a), Packed(newest_b));
        if k > 0 {
            sum = add::<P, S, W>(sum, left[0].0, newest_b);
        }
        add::<P, S, W>(sum, newest_a, right[k].0)
    }
}

impl<S: Analytic, const W: usize> Laid<S, W> {
    /// Computes quotients, roots and linear equations. They are rare and kept out of the loop over the orders, which
    /// stays short.
    #[inline(never)]
    pub fn implicit(&mut self, k: usize, now: &mut [S]) {
        for each in &mut self.quotients {
            now[each.column] = each.quotient(k, each.above.map(|above| now[above]), now[each.of]);
        }
        self.roots.iter_mut().for_each(|each| now[each.column] = each.root(k, now[each.of]));
    }
}

impl<S: Analytic> Implicit<S> {
    /// The quotient q_k from (q b)_k = a_k with q_0 = a_0 / b_0; the reciprocal for `above` = `None`.
    pub fn quotient(&mut self, k: usize, above: Option<S>, below: S) -> S {
        self.series[k][1] = below;
        let result = if k == 0 {
            self.inverse = S::one() / below;
            above.map_or(self.inverse, |above| above / below)
        } else {
            let pairs = self.series[..k].iter().zip(self.series[1..=k].iter().rev());
            let known = pairs.fold(S::zero(), |sum, (q, b)| sum + q[0] * b[1]);
            above.map_or(-known, |above| above - known) * self.inverse
        };
        self.series[k][0] = result;
        result
    }

    /// The root r_k from (r r)_k = a_k, where r_0 is the nonnegative root of a_0.
    pub fn root(&mut self, k: usize, newest: S) -> S {
        let result = if k == 0 {
            newest.sqrt()
        } else {
            let pairs = self.series[1..k].iter().zip(self.series[1..k].iter().rev());
            let known = pairs.fold(S::zero(), |sum, (p, q)| sum + p[0] * q[0]);
            (newest - known) / (self.series[0][0] + self.series[0][0])
        };
        self.series[k][0] = result;
        result
    }
}
