//! A law that is neither linear nor autonomous, with its solution, for measuring the order of methods.

use crate::{Ode, System};
use field::{Over, Scalar};

/// y' = -2 t y^2 from y(0) = 1: y = 1 / (1 + t^2).
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
