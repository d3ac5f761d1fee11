//! Taylor series by stages of sums and products, for laws of any size.

use super::fused::{Fused, Task};
use super::layout::{CHAINS, Layout, Packed, Rows};
use super::linear_equations::Next;
use super::pick::{Columns, Pick};
use super::plan::Plan;
use std::ops::Range;

/// The stages of a plan, with the numbers they work on.
#[derive(Clone, Debug)]
pub(super) struct Stages<S: Fused, const W: usize, const N: usize> {
    order: usize,
    layout: Layout<S, W>,
    /// The coefficients of the current order of all quantities, by column.
    now: Box<Columns<S, N>>,
    /// Buffer for the next order, so that rates are independent of each other.
    then: Box<Columns<S, N>>,
    /// 1/k for each order.
    reciprocals: Vec<S>,
    /// For a finer type: the stages for the orders for which the digits of `f64` suffice.
    rounded: Option<Box<Stages<f64, W, N>>>,
}

impl<S: Fused, const W: usize, const N: usize> Stages<S, W, N> {
    /// Stages for series of the given order, without coefficients.
    pub fn new(plan: &Plan, order: usize) -> Self {
        let [now, then] = [(); 2].map(|()| Box::new(Columns([S::zero(); N])));
        let reciprocals = (0..=order as i64 + 1).map(|k| if k == 0 { S::zero() } else { S::ratio(1, k) });
        Stages {
            order,
            layout: Layout::new(plan, order),
            now,
            then,
            reciprocals: reciprocals.collect(),
            rounded: S::FINER.then(|| Box::new(Stages::new(plan, order))),
        }
    }

    /// Sets the coefficients.
    pub fn set(&mut self, values: &[S]) {
        self.layout.set(values);
        if let Some(rounded) = &mut self.rounded {
            let values: Vec<f64> = values.iter().map(|value| value.rounded()).collect();
            rounded.set(&values);
        }
    }

    /// Computes the coefficients after each of these orders, and writes them into the rows of the series.
    #[inline(always)]
    fn run<P: Pick<S>, R: From<S>>(&mut self, pick: P, orders: Range<usize>, series: &mut [R], width: usize) {
        let Stages { order, layout, now, then, reciprocals, .. } = self;
        for k in orders {
            for stage in &mut layout.stages {
                let Rows { first, blocks } = &stage.sums;
                for (place, block) in blocks.iter().enumerate() {
                    let sum = block.sums::<P, N>(k, now);
                    now.0[first + place * W..][..W].copy_from_slice(&sum);
                }
                for group in &mut stage.groups {
                    let products = group.products(pick, k, *order, now);
                    now.0[group.first..][..W].copy_from_slice(&products);
                }
                if stage.has_implicit {
                    stage.implicit(k, &mut now.0);
                }
                if let Some(series) = &mut stage.linear {
                    series.read(|column| now.0[column % N]);
                    S::run(Next { series, k }, 1);
                    series.write(k, |column, unknown| now.0[column % N] = unknown);
                }
            }
            // x_(k+1) = (x')_k / (k + 1)
            let (next, reciprocal) = (&mut series[(k + 1) * width..][..width], reciprocals[k + 1]);
            let rows = then.0.chunks_exact_mut(W).zip(next.chunks_exact_mut(W));
            for (block, (then, next)) in layout.rates.blocks.iter().zip(rows) {
                let mut sum = block.sums::<P, N>(k, now);
                for rate in &mut sum {
                    *rate *= reciprocal;
                }
                then.copy_from_slice(&sum);
                for lane in 0..W {
                    next[lane] = R::from(sum[lane]);
                }
            }
            std::mem::swap(now, then);
        }
    }
}

impl<const W: usize, const N: usize> Stages<f64, W, N> {
    /// Copies the first `orders` orders from a finer type, rounded.
    #[inline(always)]
    fn take<S: Fused>(&mut self, layout: &Layout<S, W>, now: &Columns<S, N>, orders: usize) {
        self.layout.take(layout, orders, self.order);
        for (own, finer) in self.now.0.iter_mut().zip(&now.0) {
            *own = finer.rounded();
        }
    }
}

/// Expands the solution whose first coefficients are in the first row of the series.
pub(super) struct Expand<'a, S: Fused, const W: usize, const N: usize> {
    pub stages: &'a mut Stages<S, W, N>,
    pub series: &'a mut [S],
    /// The length of one order in the series.
    pub width: usize,
    /// Coefficients above this order need only the digits of `f64`.
    pub fine: usize,
}

impl<S: Fused, const W: usize, const N: usize> Task<S> for Expand<'_, S, W, N> {
    #[inline(always)]
    fn run<P: Pick<S> + Pick<f64>>(self, pick: P) {
        let Expand { stages, series, width, fine } = self;
        for group in stages.layout.stages.iter_mut().flat_map(|stage| &mut stage.groups) {
            group.left[..CHAINS].fill(Packed::zero());
        }
        for (now, first) in stages.now.0.chunks_exact_mut(W).zip(series[..width].chunks_exact(W)) {
            now.copy_from_slice(first);
        }
        stages.run(pick, 0..fine, series, width);
        let Stages { order, layout, now, rounded, .. } = stages;
        if S::FINER
            && fine < *order
            && let Some(rounded) = rounded
        {
            rounded.take(layout, now, fine);
            rounded.run(pick, fine..*order, series, width);
        }
    }
}
