//! A law whose runs are projected onto its constraints and integrals of motion.

use crate::law::compiled_law::Law;
use field::DoubleDouble;
use integrators::{
    Composed, Divisors, Dual8, JacobianFn, Ode, Projection, Splitting, StepBounds, System, TaylorSeries, Variations,
};
use std::sync::Arc;

/// A law with a projection onto its constraints and integrals of motion.
pub struct ProjectedLaw {
    law: Arc<dyn Law>,
    projection: Arc<dyn Projection<f64> + Send + Sync>,
}

impl ProjectedLaw {
    /// A law with a projection. The state of the law begins with the components that are projected.
    pub fn new(law: Arc<dyn Law>, projection: Arc<dyn Projection<f64> + Send + Sync>) -> Self {
        ProjectedLaw { law, projection }
    }
}

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl Ode<$field> for ProjectedLaw {
            fn dimension(&self) -> usize {
                Ode::<$field>::dimension(&*self.law)
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                self.law.rates(t, y, dy);
            }
        }
    )*};
}
runs!(f64, Dual8, DoubleDouble);

impl System for ProjectedLaw {
    fn code_size(&self) -> Option<usize> {
        self.law.code_size()
    }

    fn projection(&self) -> Option<&dyn Projection<f64>> {
        Some(&*self.projection)
    }

    fn divisors(&self) -> Option<&dyn Divisors> {
        self.law.divisors()
    }

    fn step_bounds(&self, from: f64, to: f64) -> StepBounds {
        self.law.step_bounds(from, to)
    }

    fn taylor(&self) -> Option<Box<dyn TaylorSeries<f64> + '_>> {
        self.law.taylor()
    }

    fn taylor_variations(&self) -> Option<Box<dyn TaylorSeries<Variations> + '_>> {
        self.law.taylor_variations()
    }

    fn taylor_exact(&self) -> Option<Box<dyn TaylorSeries<DoubleDouble> + '_>> {
        self.law.taylor_exact()
    }

    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        self.law.jacobian_fn()
    }

    fn composed(&self, splitting: Splitting) -> Option<Box<dyn Composed<f64> + '_>> {
        self.law.composed(splitting)
    }

    fn composed_exact(&self, splitting: Splitting) -> Option<Box<dyn Composed<DoubleDouble> + '_>> {
        self.law.composed_exact(splitting)
    }
}
