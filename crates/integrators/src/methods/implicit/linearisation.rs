//! Linearisation of a law at the start of a step, for linearly implicit methods.

use crate::law::jacobian::Jacobian;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::Cause;

/// J = df/dy, f_t = df/dt and f at the start of a step; reused after a rejection.
pub(crate) struct Linearised<'a> {
    jacobian: Jacobian<'a>,
    /// J, row by row.
    pub matrix: Vec<f64>,
    /// The derivative f_t.
    pub drift: Vec<f64>,
    /// The rates f.
    pub slope: Vec<f64>,
    at: Option<f64>,
}

impl<'a> Linearised<'a> {
    pub fn new(jacobian: Jacobian<'a>, dimension: usize) -> Self {
        let zeros = || vec![0.0; dimension];
        Linearised { jacobian, matrix: vec![0.0; dimension * dimension], drift: zeros(), slope: zeros(), at: None }
    }

    /// Linearises the law at the start of a step. Returns false if this was done already.
    pub fn at(&mut self, tau: f64, y: &[f64], meter: &BudgetedRhs<f64>) -> bool {
        if self.at == Some(tau) {
            return false;
        }
        let t = meter.time(tau);
        self.jacobian.matrix(t, y, &mut self.matrix);
        // for runs backwards in time f and t change their sign: df/dy does too, df/dt does not
        self.matrix.iter_mut().for_each(|entry| *entry *= meter.direction);
        self.jacobian.time_derivatives(t, y, &mut self.drift);
        meter.count_jacobian();
        meter.rates(tau, y, &mut self.slope);
        self.at = Some(tau);
        true
    }

    /// The reason why a matrix made of J could not be factorised.
    pub fn unfactorised(&self) -> Cause {
        if self.matrix.iter().all(|entry| entry.is_finite()) { Cause::Singular } else { Cause::Undefined }
    }
}
