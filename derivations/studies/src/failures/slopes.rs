//! The Jacobian of an expensive law by forward differentiation, one evaluation for each column.
//!
//! Eight columns at once are faster only if the law is short enough to be inlined completely.

use field::Tangent;
use integrators::{JacobianFn, Ode};

/// A law, with buffers for one evaluation.
pub struct ByTangents<'a, L> {
    law: &'a L,
    y: Vec<Tangent<f64>>,
    dy: Vec<Tangent<f64>>,
}

impl<'a, L: Ode<Tangent<f64>>> ByTangents<'a, L> {
    /// The Jacobian of an autonomous law.
    pub fn of(law: &'a L) -> Self {
        let none = vec![Tangent::fixed(0.0); law.dimension()];
        ByTangents { law, y: none.clone(), dy: none }
    }
}

impl<L: Ode<Tangent<f64>>> JacobianFn for ByTangents<'_, L> {
    fn matrix(&mut self, _t: f64, y: &[f64], matrix: &mut [f64]) {
        let n = y.len();
        for column in 0..n {
            for (place, (to, from)) in self.y.iter_mut().zip(y).enumerate() {
                *to = if place == column { Tangent::variable(*from) } else { Tangent::fixed(*from) };
            }
            self.law.rates(Tangent::fixed(0.0), &self.y, &mut self.dy);
            for (row, rate) in self.dy.iter().enumerate() {
                matrix[row * n + column] = rate.slope;
            }
        }
    }
}
