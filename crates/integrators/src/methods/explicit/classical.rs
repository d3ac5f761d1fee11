//! Euler's method and the classical Runge-Kutta method with a constant step.

use crate::Real;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Stepper};
use field::Scalar;

/// Explicit Euler, y + h f(t, y): order 1 (Euler 1768).
pub(crate) struct Euler<S> {
    pub step: S,
    slope: Vec<S>,
}

impl<S: Real> Euler<S> {
    pub fn new(step: S, dimension: usize) -> Self {
        Euler { step, slope: vec![S::zero(); dimension] }
    }
}

impl<S: Real> Stepper<S> for Euler<S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        euler_step(|t, y, dy| meter.rates(t, y, dy), tau, before, step, &mut self.slope, after);
        Attempt::Accepted { next: 0.0 }
    }

    fn fixed(&self) -> Option<S> {
        Some(self.step)
    }
}

/// The classical Runge-Kutta method of order 4 (Kutta 1901). A step ends in y + h/6 (k1 + 2 k2 + 2 k3 + k4) with
///
///   k1 = f(t, y) ,   k2 = f(t + h/2, y + h/2 k1) ,   k3 = f(t + h/2, y + h/2 k2) ,   k4 = f(t + h, y + h k3) .
pub(crate) struct RungeKutta4<S> {
    pub step: S,
    slopes: [Vec<S>; 4],
    stage: Vec<S>,
}

impl<S: Real> RungeKutta4<S> {
    pub fn new(step: S, dimension: usize) -> Self {
        let zeros = || vec![S::zero(); dimension];
        RungeKutta4 { step, slopes: std::array::from_fn(|_| zeros()), stage: zeros() }
    }
}

impl<S: Real> Stepper<S> for RungeKutta4<S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        let rates = |t, y: &[S], dy: &mut [S]| meter.rates(t, y, dy);
        runge_kutta_4_step(rates, tau, before, step, &mut self.slopes, &mut self.stage, after);
        Attempt::Accepted { next: 0.0 }
    }

    fn fixed(&self) -> Option<S> {
        Some(self.step)
    }
}

/// One step of the explicit Euler method from `before` at the time `tau`, over any scalar type; `slope` is a buffer for
/// f.
pub fn euler_step<S: Scalar>(
    mut rates: impl FnMut(S, &[S], &mut [S]),
    tau: S,
    before: &[S],
    step: S,
    slope: &mut [S],
    after: &mut [S],
) {
    rates(tau, before, slope);
    advance(before, step, slope, after);
}

/// One step of the classical Runge-Kutta method, over any scalar type; `k1` .. `k4` and `stage` are buffers for the
/// slopes and their arguments.
pub fn runge_kutta_4_step<S: Scalar>(
    mut rates: impl FnMut(S, &[S], &mut [S]),
    tau: S,
    before: &[S],
    step: S,
    [k1, k2, k3, k4]: &mut [Vec<S>; 4],
    stage: &mut [S],
    after: &mut [S],
) {
    let half = step.half();
    rates(tau, before, k1);
    advance(before, half, k1, stage);
    rates(tau + half, stage, k2);
    advance(before, half, k2, stage);
    rates(tau + half, stage, k3);
    advance(before, step, k3, stage);
    rates(tau + step, stage, k4);
    let sixth = step * S::ratio(1, 6);
    for i in 0..after.len() {
        let middle = k2[i] + k3[i];
        after[i] = before[i] + sixth * (k1[i] + middle + middle + k4[i]);
    }
}

/// to = from + step * slope.
pub(crate) fn advance<S: Scalar>(from: &[S], step: S, slope: &[S], to: &mut [S]) {
    for ((to, from), slope) in to.iter_mut().zip(from).zip(slope) {
        *to = *from + step * *slope;
    }
}
