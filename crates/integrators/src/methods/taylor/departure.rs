//! A step from a point at which the law has rates but no series: at a zero of a root, as the speed |v| of a body at
//! rest.
//!
//! Beside the point the law is smooth along the motion: one short step by another method is enough.

use crate::methods::explicit::gragg::GraggBulirschStoer;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Real, Tolerance};

/// The part of the step at hand that is taken: the cubic through its ends is then as good as the step itself.
const SHORT: f64 = 1e-5;

/// The step with its ends.
pub(super) struct Departure<S> {
    method: GraggBulirschStoer<S>,
    /// The time at which it begins.
    from: S,
    length: S,
    /// States at its ends, and their rates.
    states: [Vec<S>; 2],
    rates: [Vec<S>; 2],
}

impl<S: Real> Departure<S> {
    /// The step of a law with so many states, not tried from anywhere yet.
    pub fn new(tolerance: &Tolerance, states: usize) -> Self {
        let zeros = || [vec![S::zero(); states], vec![S::zero(); states]];
        let nowhere = S::zero() / S::zero();
        Departure {
            method: GraggBulirschStoer::new(tolerance, states),
            from: nowhere,
            length: S::zero(),
            states: zeros(),
            rates: zeros(),
        }
    }

    /// Tries the step; the first try only asks for a short step.
    pub fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        if self.from != tau {
            self.from = tau;
            return Attempt::Rejected { next: SHORT * step.approx(), cause: Cause::Error };
        }
        let attempt = self.method.attempt(tau, before, step, after, meter);
        if matches!(attempt, Attempt::Accepted { .. }) {
            self.length = step;
            self.states[0].copy_from_slice(before);
            self.states[1].copy_from_slice(after);
            meter.rates(tau, before, &mut self.rates[0]);
            meter.rates(tau + step, after, &mut self.rates[1]);
        }
        attempt
    }

    /// The cubic through both ends with their rates.
    pub fn between(&self, passed: S, state: &mut [S]) {
        let part = passed / self.length;
        let rest = S::one() - part;
        let two = S::int(2);
        let ends = self.states[0].iter().zip(&self.states[1]).zip(self.rates[0].iter().zip(&self.rates[1]));
        for (value, ((from, to), (leaves, arrives))) in state.iter_mut().zip(ends) {
            *value = rest * rest * (*from * (S::one() + two * part) + *leaves * passed)
                + part * part * (*to * (S::one() + two * rest) - *arrives * (self.length - passed));
        }
    }
}
