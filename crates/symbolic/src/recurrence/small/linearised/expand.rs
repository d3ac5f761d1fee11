//! A small series from its first coefficients on.

use super::Linearised;
use super::matrix::times;
use super::orders::Between;
use crate::recurrence::fused::{Fused, Task};
use crate::recurrence::pick::Pick;
use crate::recurrence::small::MOST_ORDER;
use crate::recurrence::small::factors::CHAINS;
use crate::recurrence::stored::Stored;

/// Expands the solution whose first coefficients stand at the head of the series.
pub(in crate::recurrence::small) struct Expand<'a, S: Fused, const B: usize, const G: usize> {
    pub law: &'a mut Linearised<S, B, G>,
    pub series: &'a mut [S],
    /// From the order after this one on the digits of `f64` do.
    pub fine: usize,
}

impl<S: Fused, const B: usize, const G: usize> Task<S> for Expand<'_, S, B, G> {
    #[inline(always)]
    fn run<P: Pick<S> + Pick<f64>>(self, pick: P) {
        let Expand { law, series, fine } = self;
        let (rows, _) = series.as_chunks_mut::<8>();
        let order = (rows.len() / B).saturating_sub(1).min(MOST_ORDER);
        let first = law.first::<P>(pick, rows);
        let Linearised { shape, orders, rounded, .. } = law;
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

impl<S: Fused, const B: usize, const G: usize> Linearised<S, B, G> {
    /// f at y_0, and its derivatives there.
    #[inline(always)]
    fn first<P: Pick<S>>(&mut self, pick: P, rows: &[[S; 8]]) -> Between<P::Eight, B, G> {
        let begin = self.starts.begin(pick, rows);
        let mut point = [[S::zero(); 8]; B];
        for (point, eight) in point.iter_mut().zip(begin) {
            let stored = pick.store(eight);
            *point = std::array::from_fn(|lane| stored.lane(lane));
        }
        self.solve(&mut point);
        self.linearise(pick, &point);
        self.find_rows(&point);
        let Linearised { rows, elimination, weights, orders, .. } = &mut *self;
        elimination.run(pick, rows, &mut orders.jacobian, weights, &mut orders.gains);
        let nothing = [pick.all(S::zero()); B];
        let mut newest = nothing;
        for (newest, eight) in newest.iter_mut().zip(point) {
            *newest = pick.load(&S::Stored::of(eight));
        }
        let [mut products, b] = self.shape.places.pick(pick, &newest);
        for group in 0..G {
            products[group] = pick.product(products[group], b[group]);
        }
        // f(y_0) itself, then what y_0 brings to the later orders stands in J
        let linear = times(pick, &self.linear, &newest, &self.shape.linear);
        let quadratic = times(pick, &self.weights, &products, &self.shape.weights);
        let mut sums = linear;
        for block in 0..B {
            sums[block] = pick.plus(pick.plus(quadratic[block], pick.load(&self.constants[block].0)), linear[block]);
        }
        Between { sums, rest: nothing, newest, ahead: [[pick.all(S::zero()); G]; CHAINS] }
    }
}
