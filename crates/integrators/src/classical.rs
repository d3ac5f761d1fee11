//! The two classics with a constant step: the baseline of every chart.

use crate::Real;
use crate::drive::{Attempt, Stepper};
use crate::meter::Meter;

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
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &Meter<S>) -> Attempt {
        meter.rates(tau, before, &mut self.slope);
        advance(before, step, &self.slope, after);
        Attempt::Accepted { next: 0.0 }
    }

    fn fixed(&self) -> Option<S> {
        Some(self.step)
    }
}

/// The classical Runge-Kutta method of order 4 (Kutta 1901):
/// k1 = f(t, y), k2 = f(t + h/2, y + h/2 k1), k3 = f(t + h/2, y + h/2 k2), k4 = f(t + h, y + h k3),
/// y + h/6 (k1 + 2 k2 + 2 k3 + k4).
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
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &Meter<S>) -> Attempt {
        let half = step.half();
        let [k1, k2, k3, k4] = &mut self.slopes;
        meter.rates(tau, before, k1);
        advance(before, half, k1, &mut self.stage);
        meter.rates(tau + half, &self.stage, k2);
        advance(before, half, k2, &mut self.stage);
        meter.rates(tau + half, &self.stage, k3);
        advance(before, step, k3, &mut self.stage);
        meter.rates(tau + step, &self.stage, k4);
        let sixth = step * S::ratio(1, 6);
        for i in 0..after.len() {
            let middle = k2[i] + k3[i];
            after[i] = before[i] + sixth * (k1[i] + middle + middle + k4[i]);
        }
        Attempt::Accepted { next: 0.0 }
    }

    fn fixed(&self) -> Option<S> {
        Some(self.step)
    }
}

/// to = from + step * slope.
pub(crate) fn advance<S: Real>(from: &[S], step: S, slope: &[S], to: &mut [S]) {
    for ((to, from), slope) in to.iter_mut().zip(from).zip(slope) {
        *to = *from + step * *slope;
    }
}
