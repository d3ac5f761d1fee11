//! The Jacobian of a law: by its own code, or by forward differentiation with eight columns per evaluation.
//!
//! The rules of differentiation give 0/0 where a square root vanishes, for example for the drag -c |v| v at rest, whose
//! derivatives are zero there. In that case the Jacobian is evaluated slightly later along the motion.

use num_dual::Derivative;

use crate::{DIRECTIONS, Dual8, JacobianFn, Ode, System};

/// Computes df/dy and df/dt of a law. The buffers are allocated once.
pub struct Jacobian<'a> {
    law: &'a dyn Ode<Dual8>,
    y: Vec<Dual8>,
    dy: Vec<Dual8>,
    code: Option<Box<dyn JacobianFn + 'a>>,
    /// The law that gives the direction of motion where the Jacobian is undefined.
    system: Option<&'a dyn System>,
}

/// The time shift (s) along the motion where the Jacobian is undefined at the state. No component of the state moves by
/// more than [`NEAR`] times the largest component.
const FURTHER: f64 = 1e-10;

const NEAR: f64 = 1e-8;

impl<'a> Jacobian<'a> {
    /// The Jacobian by forward differentiation.
    pub fn new(law: &'a dyn Ode<Dual8>) -> Self {
        let zeros = vec![Dual8::from_re(0.0); law.dimension()];
        Jacobian { law, y: zeros.clone(), dy: zeros, code: None, system: None }
    }

    /// The Jacobian by the system's own code where it has one, otherwise by forward differentiation.
    pub fn of(system: &'a dyn System) -> Self {
        Jacobian { code: system.jacobian_fn(), system: Some(system), ..Jacobian::new(system) }
    }

    /// The size in bytes of the machine code of [`Self::matrix`]; `None` where the law is differentiated over dual
    /// numbers.
    pub fn code_size(&self) -> Option<usize> {
        self.code.as_ref()?.code_size()
    }

    /// Writes df/dy at (t, y): `matrix[i * n + j]` = df_i / dy_j.
    pub fn matrix(&mut self, t: f64, y: &[f64], matrix: &mut [f64]) {
        self.matrix_at(t, y, matrix);
        self.or_beside((t, y), matrix, Self::matrix_at);
    }

    /// Writes df/dt at (t, y): `slopes[i]` = df_i / dt.
    pub fn time_derivatives(&mut self, t: f64, y: &[f64], slopes: &mut [f64]) {
        self.time_slopes_at(t, y, slopes);
        self.or_beside((t, y), slopes, Self::time_slopes_at);
    }

    /// Replaces derivatives that are NaN, where the rates are finite, by derivatives slightly later along the motion.
    fn or_beside(
        &mut self,
        (t, y): (f64, &[f64]),
        derivatives: &mut [f64],
        of: impl Fn(&mut Self, f64, &[f64], &mut [f64]),
    ) {
        if derivatives.iter().all(|one| one.is_finite()) {
            return;
        }
        let Some(system) = self.system else { return };
        let mut rates = vec![f64::NAN; y.len()];
        system.rates(t, y, &mut rates);
        let largest = |all: &[f64]| all.iter().fold(0.0, |largest: f64, one| largest.max(one.abs()));
        let (size, fastest) = (largest(y), largest(&rates));
        if rates.iter().all(|rate| rate.is_finite()) && fastest > 0.0 {
            let further = if size > 0.0 { FURTHER.min(NEAR * size / fastest) } else { FURTHER };
            let state: Vec<f64> = y.iter().zip(&rates).map(|(y, rate)| y + further * rate).collect();
            of(self, t, &state, derivatives);
        }
    }

    fn matrix_at(&mut self, t: f64, y: &[f64], matrix: &mut [f64]) {
        if let Some(code) = &mut self.code {
            return code.matrix(t, y, matrix);
        }
        let n = y.len();
        self.load(y);
        for first in (0..n).step_by(DIRECTIONS) {
            let block = DIRECTIONS.min(n - first);
            for k in 0..block {
                self.y[first + k] = variable(y[first + k], k);
            }
            self.law.rates(Dual8::from_re(t), &self.y, &mut self.dy);
            for (row, rate) in matrix.chunks_mut(n).zip(&self.dy) {
                for k in 0..block {
                    row[first + k] = slope(rate, k);
                }
            }
            for k in 0..block {
                self.y[first + k] = Dual8::from_re(y[first + k]);
            }
        }
    }

    fn time_slopes_at(&mut self, t: f64, y: &[f64], slopes: &mut [f64]) {
        if let Some(code) = &mut self.code {
            return code.by_time(t, y, slopes);
        }
        self.load(y);
        self.law.rates(variable(t, 0), &self.y, &mut self.dy);
        for (out, rate) in slopes.iter_mut().zip(&self.dy) {
            *out = slope(rate, 0);
        }
    }

    fn load(&mut self, y: &[f64]) {
        self.y.iter_mut().zip(y).for_each(|(own, y)| *own = Dual8::from_re(*y));
    }
}

/// A dual number with the derivative one along direction k.
pub fn variable(value: f64, k: usize) -> Dual8 {
    Dual8::from_re(value).derivative(k)
}

/// The derivative of a number along direction k.
pub fn slope(number: &Dual8, k: usize) -> f64 {
    let Derivative(slopes) = &number.eps;
    slopes.as_ref().map_or(0.0, |slopes| slopes[k])
}
