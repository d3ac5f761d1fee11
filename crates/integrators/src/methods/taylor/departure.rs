//! A step from a state where the law has rates but no Taylor series: at a zero of a square root, such as the speed |v|
//! of a body at rest.
//!
//! Near this state the law is smooth along the motion, so that one short step by another method suffices.

use crate::methods::explicit::gragg::GraggBulirschStoer;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Real, Tolerance};

/// The length of the step as a fraction of the proposed step: the cubic interpolant through its ends is then as
/// accurate as the step.
const SHORT: f64 = 1e-5;

/// The step, with the states at its ends.
pub(super) struct Departure<S> {
    method: GraggBulirschStoer<S>,
    /// The time at its beginning.
    from: S,
    length: S,
    /// States at both ends, then the rates there.
    states: [Vec<S>; 2],
    rates: [Vec<S>; 2],
}

impl<S: Real> Departure<S> {
    /// A step for a law with `states` states, not yet attempted.
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

    /// Attempts the step. The first call at a time only requests a short step.
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

    /// The cubic Hermite interpolant at the time `passed` after the beginning.
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
