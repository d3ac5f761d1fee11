//! Any method with a constant step, with a projection onto the constraint after each step.

use super::onto::Onto;
use crate::Real;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Stepper};

pub(super) struct Projected<'a, S> {
    inner: Box<dyn Stepper<S> + 'a>,
    onto: Onto<'a, S>,
    rates: Vec<S>,
}

impl<'a, S: Real> Projected<'a, S> {
    pub fn new(inner: Box<dyn Stepper<S> + 'a>, onto: Onto<'a, S>) -> Self {
        let rates = vec![S::zero(); onto.n];
        Projected { inner, onto, rates }
    }
}

impl<S: Real> Stepper<S> for Projected<'_, S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        let attempt = self.inner.attempt(tau, before, step, after, meter);
        if matches!(attempt, Attempt::Rejected { .. }) {
            return attempt;
        }
        self.onto.parts(tau + step, after, &mut self.rates, meter);
        match self.onto.bring(tau + step, after, meter) {
            Ok(()) => attempt,
            Err(cause) => Attempt::Rejected { next: 0.0, cause },
        }
    }

    fn fixed(&self) -> Option<S> {
        self.inner.fixed()
    }
}
