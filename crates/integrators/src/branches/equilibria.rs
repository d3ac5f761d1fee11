//! Equilibria of a law as functions of a parameter, which is its last state.

use super::Curve;
use crate::{Failure, Jacobian, System};

/// The curve f(y, p) = 0 of a law whose last state p is a constant parameter.
pub struct Equilibria<'a> {
    law: &'a dyn System,
    jacobian: Jacobian<'a>,
    rates: Vec<f64>,
    square: Vec<f64>,
}

impl<'a> Equilibria<'a> {
    /// The equilibria of an autonomous law.
    pub fn new(law: &'a dyn System) -> Self {
        let jacobian = Jacobian::of(law);
        let count = crate::Ode::<f64>::dimension(law);
        Equilibria { law, jacobian, rates: vec![0.0; count], square: vec![0.0; count * count] }
    }

    /// The Jacobian df/dy at x, without the parameter, which is the last entry of x: its dimension n, and its n x n entries
    /// in row order.
    pub fn linearised(&mut self, x: &[f64]) -> (usize, Vec<f64>) {
        self.jacobian.matrix(0.0, x, &mut self.square);
        let n = x.len().saturating_sub(1);
        (n, self.square.chunks(x.len().max(1)).take(n).flat_map(|row| row[..n].iter().copied()).collect())
    }
}

impl Curve for Equilibria<'_> {
    fn unknowns(&self) -> usize {
        self.rates.len()
    }

    fn evaluate(&mut self, x: &[f64], residual: &mut [f64], matrix: &mut [f64]) -> Result<(), Failure> {
        crate::Ode::<f64>::rates(self.law, 0.0, x, &mut self.rates);
        self.jacobian.matrix(0.0, x, &mut self.square);
        residual.copy_from_slice(&self.rates[..residual.len()]);
        matrix.copy_from_slice(&self.square[..matrix.len()]);
        Ok(())
    }
}
