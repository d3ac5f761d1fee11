//! Evaluation of a Taylor series.

use super::fused::{Fused, Task};
use super::pick::Pick;
use super::stored::Stored;

/// The coefficients of a series by orders, each with `width` numbers that begin with the states; coefficients up to the
/// order `fine` have full precision.
pub(super) struct Terms<'a, S> {
    pub series: &'a [S],
    pub width: usize,
    pub states: usize,
    pub order: usize,
    pub fine: usize,
}

/// The evaluation of a series at h, W states at a time.
pub(super) struct Sum<'a, S, const W: usize> {
    pub terms: Terms<'a, S>,
    pub h: S,
    pub out: &'a mut [S],
}

/// The number of partial sums: Horner's scheme alone would wait for the result of each step.
const APART: usize = 4;

impl<S: Fused, const W: usize> Task<S> for Sum<'_, S, W> {
    #[inline(always)]
    fn run<P: Pick<S> + Pick<f64>>(self, pick: P) {
        if S::FINER || W != 8 {
            return self.in_two_parts(pick);
        }
        let Sum { terms: Terms { series, width, states, order, .. }, h, .. } = self;
        let square = h * h;
        let [h, square, fourth] = [h, square, square * square].map(|power| Pick::<S>::all(pick, power));
        let (terms, over) = (order + 1, (order + 1) % APART);
        // groups of eight, and their number in each order
        let (groups, each) = (series.as_chunks::<8>().0, width / 8);
        for (first, out) in (0..states.div_ceil(8)).zip(self.out.chunks_mut(8)) {
            let mut sums = [Pick::<S>::all(pick, S::zero()); APART];
            for (chain, sum) in sums.iter_mut().enumerate().take(over) {
                *sum = Pick::<S>::load(pick, &S::Stored::of(groups[(terms - over + chain) * each + first]));
            }
            for four in groups[..(terms - over) * each].chunks_exact(APART * each).rev() {
                for (chain, sum) in sums.iter_mut().enumerate() {
                    let term = Pick::<S>::load(pick, &S::Stored::of(four[chain * each + first]));
                    *sum = Pick::<S>::plus_product(pick, term, *sum, fourth);
                }
            }
            let [even, odd, more, most] = sums;
            let low = Pick::<S>::plus_product(pick, even, odd, h);
            let high = Pick::<S>::plus_product(pick, more, most, h);
            let sum = Pick::<S>::store(pick, Pick::<S>::plus_product(pick, low, high, square));
            let mut states = [S::zero(); 8];
            for (lane, state) in states.iter_mut().enumerate() {
                *state = sum.lane(lane);
            }
            copy::<S, 8>(&states, out);
        }
    }
}

impl<S: Fused, const W: usize> Sum<'_, S, W> {
    /// Evaluates the rounded terms in `f64`, then the others; eight states at a time, with unnormalised low parts.
    /// Valid for any layout; without rounded terms the first part is empty.
    #[inline(always)]
    fn in_two_parts<P: Pick<S> + Pick<f64>>(self, pick: P) {
        let Terms { series, width, states, order, fine } = self.terms;
        let (rounded, h) = (Pick::<f64>::all(pick, self.h.rounded()), Pick::<S>::all(pick, self.h));
        for (first, out) in (0..states).step_by(8).zip(self.out.chunks_mut(8)) {
            let term = |k: usize| {
                let mut term = [S::zero(); 8];
                copy::<S, 8>(&series[k * width..][first..width.min(first + 8)], &mut term);
                S::Stored::of(term)
            };
            let mut tail = Pick::<f64>::all(pick, 0.0);
            for k in (fine + 1..=order).rev() {
                tail = Pick::<f64>::plus_product(pick, Pick::<f64>::load(pick, &term(k).rounded()), tail, rounded);
            }
            let tail = Pick::<f64>::store(pick, tail).map(S::lift);
            let mut sum = Pick::<S>::load(pick, &S::Stored::of(tail));
            for k in (0..=fine).rev() {
                sum = Pick::<S>::plus_product(pick, Pick::<S>::load(pick, &term(k)), sum, h);
            }
            let sum = Pick::<S>::store(pick, sum);
            let mut states = [S::zero(); 8];
            for (lane, state) in states.iter_mut().enumerate() {
                *state = sum.lane(lane);
            }
            copy::<S, 8>(&states, out);
        }
    }
}

/// Copies a few numbers; a call of a memory copy would take longer.
#[inline(always)]
pub(super) fn copy<S: Copy, const W: usize>(from: &[S], to: &mut [S]) {
    for (to, from) in to.chunks_mut(W).zip(from.chunks(W)) {
        match (<&mut [S; W]>::try_from(&mut *to), <&[S; W]>::try_from(from)) {
            (Ok(to), Ok(from)) => *to = *from,
            _ => {
                let few = to.len().min(from.len());
                for lane in 0..W {
                    if lane < few {
                        to[lane] = from[lane];
                    }
                }
            }
        }
    }
}
