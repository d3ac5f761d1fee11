//! The steps of the collocation methods: Newton with stage Jacobians in `f64`, residuals in the field of the run.
//!
//! The unknowns are Z_i = Y_i - y_0. Newton's matrix I - h A (x) J_j holds the Jacobian of every stage, so the first
//! corrections converge almost quadratically; kept over the later ones it gains its own digits with each. Its
//! accuracy decides how fast the iteration converges, never where to: the residuals are those of the run's field.
//!
//! The error follows from the defect of the collocation polynomial u, d = u' - f(u), at the end of the step for Gauss, at its
//! start for Radau IIA, whose end is a node. Over the step it spreads as the nodal polynomial M. By Alekseev and Groebner the end is wrong by h int M Phi d, and M is orthogonal to
//! all polynomials below degree m (s for Gauss, s - 1 for Radau IIA): only the m-th Legendre coefficient of Phi d counts.
//! Its share is at most 1 (stiff: the order falls to that of the stages) and is estimated from the spectral radius of h J
//! and from the smoothness of the solution itself. As in Hairer and Wanner's RADAU5 the defect passes (I - h g J)^-1.

use crate::law::jacobian::Jacobian;
use crate::methods::implicit::collocation::{Collocation, Family};
use crate::newton::Lu;
use crate::newton::SpectralRadius;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Real, Tolerance};

/// Iterations after which a step is shortened.
const MOST_ITERATIONS: usize = 30;
/// Iterations still to come that make fresh Jacobians pay.
const PATIENCE: f64 = 8.0;
/// What Newton may leave of the tolerance.
const LEFT_BY_NEWTON: f64 = 0.01;

pub(crate) struct Implicit<'a, S> {
    method: Collocation<S>,
    tolerance: Tolerance,
    jacobian: Jacobian<'a>,
    n: usize,
    /// Z_i of the last step that was computed, and its length: the predictor of the next.
    z: Vec<S>,
    z_step: Option<f64>,
    stage: Vec<S>,
    slopes: Vec<S>,
    /// The slope where the defect is looked at.
    probe_slope: Vec<S>,
    correction: Vec<f64>,
    predicted: Vec<f64>,
    /// J_j of the stages, by rows.
    jacobians: Vec<f64>,
    newton: Lu,
    filter: Lu,
    defect: Vec<f64>,
    plain: Vec<f64>,
    spectrum: SpectralRadius,
    /// The spectral radius at the last step whose error was looked at.
    radius: f64,
    accepted: bool,
    /// The integral of the spectral radius over the accepted steps: how much there was to follow.
    pub turns: f64,
}

impl<'a, S: Real> Implicit<'a, S> {
    pub fn new(family: Family, stages: usize, jacobian: Jacobian<'a>, tolerance: &Tolerance, dimension: usize) -> Self {
        let (n, all) = (dimension, stages * dimension);
        Implicit {
            method: Collocation::new(family, stages),
            tolerance: tolerance.clone(),
            jacobian,
            n,
            z: vec![S::zero(); all],
            z_step: None,
            stage: vec![S::zero(); n],
            slopes: vec![S::zero(); all],
            probe_slope: vec![S::zero(); n],
            correction: vec![0.0; all],
            predicted: vec![0.0; all],
            jacobians: vec![0.0; stages * n * n],
            newton: Lu::new(all),
            filter: Lu::new(n),
            defect: vec![0.0; n],
            plain: vec![0.0; n],
            spectrum: SpectralRadius::new(n),
            radius: 0.0,
            accepted: false,
            turns: 0.0,
        }
    }

    /// Starts Newton from the last step's polynomial, extrapolated; from rest in the first step.
    fn predict(&mut self, step: f64) {
        let n = self.n;
        let Some(last) = self.z_step else {
            self.z.fill(S::zero());
            return;
        };
        // after a rejection the old polynomial starts where the new one does, otherwise where it ends
        let begin = if self.accepted { 1.0 } else { 0.0 };
        let nodes = &self.method.nodes;
        let node = |j: usize| nodes[j].approx();
        self.predicted.fill(0.0);
        for i in 0..nodes.len() {
            let at = begin + node(i) * step / last;
            for j in 0..nodes.len() {
                // the Lagrange polynomial of 0, c_1 .. c_s, which is 1 at c_j
                let others = (0..nodes.len()).filter(|k| *k != j);
                let weight = others.fold(at / node(j), |w, k| w * (at - node(k)) / (node(j) - node(k)));
                for c in 0..n {
                    self.predicted[i * n + c] += weight * self.z[j * n + c].approx();
                }
            }
        }
        for c in 0..n {
            let ends = self.method.ends.iter().enumerate();
            let moved = ends.fold(0.0, |sum, (j, d)| sum + d.approx() * self.z[j * n + c].approx());
            for i in 0..nodes.len() {
                self.predicted[i * n + c] -= begin * moved;
            }
        }
        self.z.iter_mut().zip(&self.predicted).for_each(|(z, predicted)| *z = S::lift(*predicted));
    }

    /// J_j at every stage, and the factors of Newton's matrix.
    fn linearise(&mut self, tau: S, y: &[S], step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        let (n, direction) = (self.n, meter.direction.approx());
        for (j, matrix) in self.jacobians.chunks_mut(n * n).enumerate() {
            for ((plain, y), z) in self.plain.iter_mut().zip(y).zip(&self.z[j * n..]) {
                *plain = (*y + *z).approx();
            }
            let t = meter.time(tau + step * self.method.nodes[j]).approx();
            self.jacobian.matrix(t, &self.plain, matrix);
            matrix.iter_mut().for_each(|entry| *entry *= direction);
            meter.count_jacobian();
        }
        for (row, entries) in self.newton.rows().enumerate() {
            let (i, c) = (row / n, row % n);
            for (j, (part, jacobian)) in entries.chunks_mut(n).zip(self.jacobians.chunks(n * n)).enumerate() {
                let factor = -(step * self.method.matrix[i][j]).approx();
                part.iter_mut().zip(&jacobian[c * n..]).for_each(|(entry, slope)| *entry = factor * slope);
            }
            entries[row] += 1.0;
        }
        if !self.jacobians.iter().all(|slope| slope.is_finite()) {
            return Err(Cause::Undefined);
        }
        meter.count_factorisation();
        if self.newton.factorise() { Ok(()) } else { Err(Cause::Singular) }
    }

    /// One correction of Z; its size in units of the tolerance.
    fn correct(&mut self, tau: S, y: &[S], step: S, meter: &BudgetedRhs<S>) -> f64 {
        let n = self.n;
        for (j, slope) in self.slopes.chunks_mut(n).enumerate() {
            for ((stage, y), z) in self.stage.iter_mut().zip(y).zip(&self.z[j * n..]) {
                *stage = *y + *z;
            }
            meter.rates(tau + step * self.method.nodes[j], &self.stage, slope);
            slope.iter_mut().for_each(|slope| *slope *= step);
        }
        for (i, row) in self.method.matrix.iter().enumerate() {
            for c in 0..n {
                let sum =
                    row.iter().enumerate().fold(-self.z[i * n + c], |sum, (j, a)| sum + *a * self.slopes[j * n + c]);
                self.correction[i * n + c] = sum.approx();
            }
        }
        self.newton.solve(&mut self.correction);
        let mut size = 0.0_f64;
        for (z, correction) in self.z.chunks_mut(n).zip(self.correction.chunks(n)) {
            for c in 0..n {
                z[c] += S::lift(correction[c]);
            }
            let part = self.tolerance.norm(y, y, |c| correction[c]);
            size = if part.is_nan() { part } else { size.max(part) };
        }
        size
    }

    /// Newton's iteration to a small part of the tolerance.
    fn iterate(&mut self, tau: S, y: &[S], step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        self.linearise(tau, y, step, meter)?;
        let mut last = f64::INFINITY;
        let mut rate = 0.5;
        for iteration in 0..MOST_ITERATIONS {
            let size = self.correct(tau, y, step, meter);
            if !size.is_finite() {
                return Err(Cause::Undefined);
            }
            if iteration > 0 {
                rate = size / last;
            }
            if size * (rate / (1.0 - rate).max(0.1)).min(1.0) <= LEFT_BY_NEWTON || (rate > 0.5 && size < 0.1) {
                return Ok(());
            }
            if rate >= 2.0 || (iteration > 2 && rate >= 0.95) {
                return Err(Cause::Newton);
            }
            let to_come = (LEFT_BY_NEWTON / size).ln() / rate.ln();
            if iteration > 0 && !(0.0..PATIENCE).contains(&to_come) {
                self.linearise(tau, y, step, meter)?;
            }
            last = size;
        }
        Err(Cause::Newton)
    }

    /// The error in units of the tolerance, and the power of the step that it goes with.
    fn error(&mut self, y: &[S], after: &[S], step: S) -> (f64, f64) {
        let (n, s) = (self.n, self.method.stages());
        for c in 0..n {
            let probe = self.method.probe.iter().enumerate();
            let slope = probe.fold(S::zero(), |sum, (j, e)| sum + *e * self.z[j * n + c]);
            self.defect[c] = (slope - step * self.probe_slope[c]).approx();
        }
        let plain = self.tolerance.norm(y, after, |c| self.defect[c]);
        let motion = self.z.chunks(n).map(|z| self.tolerance.norm(y, after, |c| z[c].approx())).fold(0.0, f64::max);
        let gentle = step.approx() / s as f64;
        for (i, row) in self.filter.rows().enumerate() {
            let slopes = &self.jacobians[i * n..][..n];
            row.iter_mut().zip(slopes).for_each(|(entry, slope)| *entry = -gentle * slope);
            row[i] += 1.0;
        }
        if self.filter.factorise() {
            self.filter.solve(&mut self.defect);
        }
        let filtered = self.tolerance.norm(y, after, |c| self.defect[c]).min(plain);
        let (degree, norm) = match self.method.family {
            Family::Gauss => (s, 2 * s + 1),
            Family::RadauIIA => (s - 1, 2 * (2 * s - 1)),
        };
        self.radius = self.spectrum.radius(&self.jacobians[..n * n]);
        let half_turn = 0.5 * step.approx() * self.radius;
        let rough = (1..=degree).fold(1.0, |share, k| share * half_turn / (2 * k - 1) as f64);
        let share = (rough + plain / motion.max(f64::MIN_POSITIVE)).min(1.0);
        let power = if share > 0.5 { s + 1 } else { s + 1 + degree };
        (filtered * share / norm as f64, power as f64)
    }
}

impl<S: Real> Stepper<S> for Implicit<'_, S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        let length = step.approx();
        self.predict(length);
        if let Err(cause) = self.iterate(tau, before, step, meter) {
            (self.z_step, self.accepted) = (None, false);
            let factor = if cause == Cause::Undefined { 0.25 } else { 0.5 };
            return Attempt::Rejected { next: factor * length, cause };
        }
        for (c, (after, before)) in after.iter_mut().zip(before).enumerate() {
            let ends = self.method.ends.iter().enumerate();
            *after = ends.fold(*before, |sum, (j, d)| sum + *d * self.z[j * self.n + c]);
        }
        match self.method.family {
            Family::Gauss => meter.rates(tau + step, after, &mut self.probe_slope),
            Family::RadauIIA => meter.rates(tau, before, &mut self.probe_slope),
        }
        let (error, power) = self.error(before, after, step);
        let most = if self.accepted || self.z_step.is_none() { 5.0 } else { 1.0 };
        self.z_step = Some(length);
        self.accepted = error <= 1.0;
        let next = length * (0.9 * error.max(1e-300).powf(-1.0 / power)).clamp(0.2, most);
        if self.accepted {
            self.turns += length * self.radius;
            Attempt::Accepted { next }
        } else {
            let cause = if error.is_nan() { Cause::Undefined } else { Cause::Error };
            Attempt::Rejected { next: if error.is_nan() { 0.25 * length } else { next }, cause }
        }
    }
}
