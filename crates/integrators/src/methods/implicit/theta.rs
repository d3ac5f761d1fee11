//! Backward Euler and the implicit midpoint rule with a constant step, for stiff laws.
//!
//! The methods have one stage, Y = y + c h f(t + c h, Y), and the result y + (Y - y) / c:
//! * backward Euler, c = 1: order 1, L-stable;
//! * the implicit midpoint rule, c = 1/2: order 2, A-stable, symmetric, symplectic (Gauss with one stage).

use crate::Real;
use crate::law::jacobian::Jacobian;
use crate::newton::{Newton, Shifted};
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};

pub(crate) struct Theta<'a, S> {
    pub step: S,
    /// The node c.
    node: S,
    jacobian: Jacobian<'a>,
    matrix: Vec<f64>,
    newton_matrix: Shifted,
    stage: Vec<S>,
    slope: Vec<S>,
    plain: Vec<f64>,
    correction: Vec<f64>,
}

impl<'a, S: Real> Theta<'a, S> {
    pub fn new(step: S, node: S, jacobian: Jacobian<'a>, dimension: usize) -> Self {
        Theta {
            step,
            node,
            jacobian,
            matrix: vec![0.0; dimension * dimension],
            newton_matrix: Shifted::new(dimension),
            stage: vec![S::zero(); dimension],
            slope: vec![S::zero(); dimension],
            plain: vec![0.0; dimension],
            correction: vec![0.0; dimension],
        }
    }

    /// Factorises 1/(c h) I - J at the stage.
    fn linearise(&mut self, tau: S, reach: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        self.plain.iter_mut().zip(&self.stage).for_each(|(plain, y)| *plain = y.approx());
        self.jacobian.matrix(meter.time(tau).approx(), &self.plain, &mut self.matrix);
        meter.count_jacobian();
        self.matrix.iter_mut().for_each(|slope| *slope *= meter.direction.approx());
        if !self.matrix.iter().all(|slope| slope.is_finite()) {
            return Err(Cause::Undefined);
        }
        meter.count_factorisation();
        self.newton_matrix.take(&self.matrix);
        if self.newton_matrix.factorise(reach.approx().recip()) { Ok(()) } else { Err(Cause::Singular) }
    }

    /// Newton's iteration for the stage, from its present value.
    fn iterate(&mut self, tau: S, before: &[S], reach: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        let mut newton = Newton::new();
        loop {
            if newton.wants_matrix() {
                self.linearise(tau, reach, meter)?;
            }
            meter.rates(tau, &self.stage, &mut self.slope);
            for (c, correction) in self.correction.iter_mut().enumerate() {
                *correction = ((before[c] + reach * self.slope[c] - self.stage[c]) / reach).approx();
            }
            self.newton_matrix.solve(&mut self.correction);
            let mut scale = 0.0_f64;
            for (y, correction) in self.stage.iter_mut().zip(&self.correction) {
                *y += S::lift(*correction);
                scale = scale.max(y.approx().abs());
            }
            let size = self.correction.iter().fold(0.0_f64, |size, c| if c.is_nan() { *c } else { size.max(c.abs()) });
            if newton.corrected::<S>(size, scale)? {
                return Ok(());
            }
        }
    }
}

impl<S: Real> Stepper<S> for Theta<'_, S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        let reach = step * self.node;
        self.stage.copy_from_slice(before);
        if let Err(cause) = self.iterate(tau + reach, before, reach, meter) {
            return Attempt::Rejected { next: 0.0, cause };
        }
        for ((after, before), stage) in after.iter_mut().zip(before).zip(&self.stage) {
            *after = *before + (*stage - *before) / self.node;
        }
        Attempt::Accepted { next: 0.0 }
    }

    fn fixed(&self) -> Option<S> {
        Some(self.step)
    }
}
