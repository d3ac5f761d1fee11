//! A nonlinear nonautonomous test equation with a known solution, to measure the order of methods.

use crate::{Ode, System};
use field::{Over, Scalar};

/// The equation y' = -2 t y^2 with the solution y = 1 / (1 + t^2).
pub(crate) struct Bell;

impl<S: Over<f64> + Scalar> Ode<S> for Bell {
    fn dimension(&self) -> usize {
        1
    }

    fn rates(&self, t: S, y: &[S], dy: &mut [S]) {
        dy[0] = -(t + t) * y[0] * y[0];
    }
}

impl System for Bell {}
