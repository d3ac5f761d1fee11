//! A small series from its first coefficients on.

use super::kernel::Kernel;
use super::matrix::times;
use super::orders::{Between, MOST_ORDER};
use crate::recurrence::fused::{Fused, Task};
use crate::recurrence::pick::Pick;
use crate::recurrence::stored::Stored;

/// Expands the solution whose first coefficients stand at the head of the series.
pub(super) struct Expand<'a, S: Fused, const B: usize, const G: usize> {
    pub kernel: &'a mut Kernel<S, B, G>,
    pub series: &'a mut [S],
    /// From the order after this one on the digits of `f64` do.
    pub fine: usize,
}

impl<S: Fused, const B: usize, const G: usize> Task<S> for Expand<'_, S, B, G> {
    #[inline(always)]
    fn run<P: Pick<S> + Pick<f64>>(self, pick: P) {
        let Expand { kernel, series, fine } = self;
        let (rows, _) = series.as_chunks_mut::<8>();
        let order = (rows.len() / B).saturating_sub(1).min(MOST_ORDER);
        let first = kernel.first::<P>(pick, rows);
        let Kernel { shape, orders, rounded, .. } = kernel;
        let fine = if S::FINER { fine.min(order) } else { order };
        let between = orders.run(pick, shape, 0..fine, first, rows);
        if S::FINER
            && fine < order
            && let Some(rounded) = rounded
        {
            rounded.take(orders, fine);
            let between = between.rounded::<S, P>(pick);
            rounded.run(pick, shape, fine..order, between, rows);
        }
    }
}

impl<S: Fused, const B: usize, const G: usize> Kernel<S, B, G> {
    /// f at y_0, and its derivatives there.
    #[inline(always)]
    fn first<P: Pick<S>>(&mut self, pick: P, rows: &[[S; 8]]) -> Between<P::Eight, B> {
        let mut point = [[S::zero(); 8]; B];
        point.copy_from_slice(&rows[..B]);
        if self.shape.solves {
            self.solve(&mut point);
        }
        self.linearise(pick, &point);
        if self.shape.solves {
            self.eliminate(pick, &point);
        }
        let nothing = [pick.all(S::zero()); B];
        let mut newest = nothing;
        for (newest, eight) in newest.iter_mut().zip(point) {
            *newest = pick.load(&S::Stored::of(eight));
        }
        let (a, b) = (self.shape.pick(pick, 0, &newest), self.shape.pick(pick, 1, &newest));
        self.orders.begin(pick, &b);
        let mut products = [pick.all(S::zero()); G];
        for group in 0..G {
            products[group] = pick.product(a[group], b[group]);
        }
        // f(y_0) itself, then what y_0 brings to the later orders stands in J
        let linear = times(pick, &self.linear, &newest, &self.shape.linear);
        let quadratic = times(pick, &self.weights, &products, &self.shape.weights);
        let mut sums = linear;
        for block in 0..B {
            sums[block] = pick.plus(pick.plus(quadratic[block], pick.load(&self.constants[block].0)), linear[block]);
        }
        Between { sums, rest: nothing, newest }
    }
}

impl<E: Copy, const B: usize> Between<E, B> {
    #[inline(always)]
    fn rounded<S: Fused, P: Pick<S, Eight = E> + Pick<f64>>(&self, pick: P) -> Between<<P as Pick<f64>>::Eight, B> {
        let zero = Pick::<f64>::all(pick, 0.0);
        let mut rounded = Between { sums: [zero; B], rest: [zero; B], newest: [zero; B] };
        let each = [&mut rounded.sums, &mut rounded.rest, &mut rounded.newest];
        for (own, finer) in each.into_iter().zip([&self.sums, &self.rest, &self.newest]) {
            for (own, finer) in own.iter_mut().zip(finer) {
                *own = Pick::<f64>::load(pick, &Pick::<S>::store(pick, *finer).rounded());
            }
        }
        rounded
    }
}
