//! The law at the start of sliding from rest in space.
//!
//! The direction of sliding changes within the time in which its initial speed doubles. The first step is shorter than this time, so that
//! a method resolves the change. A Taylor series has no correct digits there, since v/|v| divides by a number that is small relative to
//! the rate of v.

use super::Current;
use field::DoubleDouble;
use integrators::{Divisors, Dual8, JacobianFn, Ode, Projection, StepBounds, System};
use simulation::Law;
use std::sync::Arc;

/// The longest first step as a fraction of the time in which the speed doubles.
const SHORT: f64 = 0.1;

/// The law for the current mode, and its longest first step, s. If a contact begins to slide, the law has no Taylor series.
pub(super) fn from_rest(current: &Current, law: Arc<dyn Law>) -> (Arc<dyn Law>, Option<f64>) {
    let doubling = current.glides.iter().flatten().filter_map(|glide| glide.doubling());
    match doubling.reduce(f64::min) {
        None => (law, None),
        Some(time) => (Arc::new(WithoutSeries(law)), Some(SHORT * time)),
    }
}

/// A law without Taylor series.
struct WithoutSeries(Arc<dyn Law>);

macro_rules! runs {
    ($($field:ty),*) => {$(
        impl Ode<$field> for WithoutSeries {
            fn dimension(&self) -> usize {
                Ode::<$field>::dimension(&*self.0)
            }

            fn rates(&self, t: $field, y: &[$field], dy: &mut [$field]) {
                self.0.rates(t, y, dy);
            }
        }
    )*};
}
runs!(f64, Dual8, DoubleDouble);

impl System for WithoutSeries {
    fn divisors(&self) -> Option<&dyn Divisors> {
        self.0.divisors()
    }

    fn step_bounds(&self, from: f64, to: f64) -> StepBounds {
        self.0.step_bounds(from, to)
    }

    fn jacobian_fn(&self) -> Option<Box<dyn JacobianFn + '_>> {
        self.0.jacobian_fn()
    }

    fn projection(&self) -> Option<&dyn Projection<f64>> {
        self.0.projection()
    }
}
