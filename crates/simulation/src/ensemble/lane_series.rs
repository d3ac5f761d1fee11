//! The series of a recurrence in lanes, as an ensemble asks for it.

use super::one_by_one::one_by_one;
use crate::Expandable;
use field::Lanes;
use integrators::LaneSeries;
use series::Abreast;

/// Quantities that still lie near the processor, and those of the largest law.
pub(super) const FEW: usize = 256;
pub(super) const MANY: usize = 1 << 16;

/// The series of L systems of one law, to this order; `None` where there are more quantities than `MANY`.
pub fn lane_series<const L: usize>(law: &Expandable, order: usize) -> Option<Box<dyn LaneSeries<L> + '_>> {
    if law.exponents.is_some() {
        return one_by_one(law, order);
    }
    if let Some(series) = law.recurrence.abreast::<L, FEW>(order) {
        return Some(Box::new(Series(series)));
    }
    law.recurrence.abreast::<L, MANY>(order).map(|series| Box::new(Series(series)) as Box<dyn LaneSeries<L>>)
}

struct Series<'a, const L: usize, const N: usize>(Abreast<'a, L, N>);

impl<const L: usize, const N: usize> LaneSeries<L> for Series<'_, L, N> {
    fn set(&mut self, lane: usize, parameters: &[f64]) {
        self.0.set(lane, parameters);
    }

    fn order(&self) -> usize {
        self.0.order()
    }

    fn expand(&mut self, times: Lanes<L>, states: &[Lanes<L>]) {
        self.0.expand(states, times);
    }

    fn coefficients(&self, k: usize) -> &[Lanes<L>] {
        self.0.coefficients(k)
    }

    fn sum(&self, h: Lanes<L>, out: &mut [Lanes<L>]) {
        self.0.sum(h, out);
    }
}
