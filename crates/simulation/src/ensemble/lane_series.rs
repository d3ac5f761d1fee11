//! The series of a recurrence in lanes, for ensembles.

use super::one_by_one::one_by_one;
use super::parametric_system::LANES;
use crate::Expandable;
use field::Batch;
use integrators::LaneSeries;
use series::Abreast;

/// The number of quantities that still lie near the processor, and that of the largest law.
pub(super) const FEW: usize = 256;
pub(super) const MANY: usize = 1 << 16;

/// The series of [`LANES`] systems of one law, to this order; `None` where there are more quantities than `MANY`.
pub fn lane_series(law: &Expandable, order: usize) -> Option<Box<dyn LaneSeries<LANES> + '_>> {
    if law.exponents.is_none() {
        if let Some(series) = law.recurrence.abreast::<LANES, FEW>(order) {
            return Some(Box::new(Series(series)));
        }
        if let Some(series) = law.recurrence.abreast::<LANES, MANY>(order) {
            return Some(Box::new(Series(series)));
        }
    }
    one_by_one(law, order)
}

struct Series<'a, const N: usize>(Abreast<'a, LANES, N>);

impl<const N: usize> LaneSeries<LANES> for Series<'_, N> {
    fn set(&mut self, lane: usize, parameters: &[f64]) {
        self.0.set(lane, parameters);
    }

    fn order(&self) -> usize {
        self.0.order()
    }

    fn expand(&mut self, times: Batch<LANES>, states: &[Batch<LANES>]) {
        self.0.expand(states, times);
    }

    fn coefficients(&self, k: usize) -> &[Batch<LANES>] {
        self.0.coefficients(k)
    }

    fn sum(&self, h: Batch<LANES>, out: &mut [Batch<LANES>]) {
        self.0.sum(h, out);
    }
}
