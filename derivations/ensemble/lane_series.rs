//! The series of a recurrence in lanes, as an ensemble asks for it.

use field::Lanes;
use integrators::LaneSeries;
use symbolic::{Abreast, Recurrence};

/// Quantities that still lie near the processor, and those of the largest law.
const FEW: usize = 256;
const MANY: usize = 1 << 16;

/// The series of L systems of one recurrence, to this order; `None` where there are more quantities than `MANY`.
pub fn lane_series<const L: usize>(recurrence: &Recurrence, order: usize) -> Option<Box<dyn LaneSeries<L> + '_>> {
    if let Some(series) = recurrence.abreast::<L, FEW>(order) {
        return Some(Box::new(Series(series)));
    }
    recurrence.abreast::<L, MANY>(order).map(|series| Box::new(Series(series)) as Box<dyn LaneSeries<L>>)
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
