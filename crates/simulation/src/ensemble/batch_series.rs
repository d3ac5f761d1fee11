//! Taylor series of a law for a batch of ensemble members.

use super::one_by_one::one_by_one;
use super::parametric_system::BATCH_SIZE;
use crate::Expandable;
use field::Batch;
use integrators::BatchSeries;
use series::BatchExpansion;

/// The largest number of quantities that fit into the cache, and the largest number supported.
pub(super) const FEW: usize = 256;
pub(super) const MANY: usize = 1 << 16;

/// The Taylor series of [`BATCH_SIZE`] systems of one law, of the given order; `None` where the law has more than
/// `MANY` quantities.
pub fn batch_series(law: &Expandable, order: usize) -> Option<Box<dyn BatchSeries<BATCH_SIZE> + '_>> {
    if law.exponents.is_none() {
        if let Some(series) = law.recurrence.batch_expansion::<BATCH_SIZE, FEW>(order) {
            return Some(Box::new(Series(series)));
        }
        if let Some(series) = law.recurrence.batch_expansion::<BATCH_SIZE, MANY>(order) {
            return Some(Box::new(Series(series)));
        }
    }
    one_by_one(law, order)
}

struct Series<'a, const N: usize>(BatchExpansion<'a, BATCH_SIZE, N>);

impl<const N: usize> BatchSeries<BATCH_SIZE> for Series<'_, N> {
    fn set(&mut self, lane: usize, parameters: &[f64]) {
        self.0.set(lane, parameters);
    }

    fn order(&self) -> usize {
        self.0.order()
    }

    fn expand(&mut self, times: Batch<BATCH_SIZE>, states: &[Batch<BATCH_SIZE>]) {
        self.0.expand(states, times);
    }

    fn coefficients(&self, k: usize) -> &[Batch<BATCH_SIZE>] {
        self.0.coefficients(k)
    }

    fn sum(&self, h: Batch<BATCH_SIZE>, out: &mut [Batch<BATCH_SIZE>]) {
        self.0.sum(h, out);
    }
}
