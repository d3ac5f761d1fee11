//! Steps of the collocation methods: Newton's iteration with a matrix in `f64` and residuals in the scalar type of the
//! run.
//!
//! The unknowns are Z_i = Y_i - y_0. Newton's matrix ([`StageMatrix`]) affects the speed of convergence only, not the
//! limit. In double precision the Jacobian is reused over steps while the iteration converges fast, and the
//! factorisation while the step size hardly changes, as in Hairer and Wanner's RADAU5. In a finer scalar type the
//! matrix has the Jacobians of all stages, renewed where that pays.
//!
//! The error is estimated from the defect of the collocation polynomial ([`DefectSpread`]). A further term accounts for
//! the variation of the defect and of the Jacobian over the step; it is estimated from the smoothness of the solution
//! and the convergence of Newton's iteration. In a finer scalar type each stage has its own Jacobian and the
//! convergence gives no such estimate; the spectral radius of h J then bounds this term more coarsely.

use crate::law::jacobian::Jacobian;
use crate::methods::implicit::collocation::{Collocation, Family};
use crate::methods::implicit::defect_spread::DefectSpread;
use crate::methods::implicit::stage_matrix::StageMatrix;
use crate::newton::SpectralRadius;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Real, Tolerance};

/// The step is shortened after this many iterations.
const MOST_ITERATIONS: usize = 30;
/// A reused Jacobian is renewed after this many iterations, plus two for each stage.
const MOST_KEPT: usize = 6;
/// New Jacobians of all stages are computed if at least this many further iterations are expected.
const PATIENCE: f64 = 8.0;
/// The error of Newton's iteration, as a fraction of the tolerance.
const LEFT_BY_NEWTON: f64 = 0.01;
/// The Jacobian is reused in the next step if the last correction is at most this fraction of the one before.
const KEEPS_JACOBIAN: f64 = 0.01;
/// The convergence rate at which the step size after a failed iteration aims.
const RATE_AIMED_AT: f64 = 0.2;
/// The convergence rate assumed at the first correction.
const FIRST_RATE: f64 = 0.5;
/// The largest convergence rate expected for the next step.
const HIGHEST_RATE: f64 = 0.4;
/// The factorisation and the step size are kept while the next step could be at most longer by this factor.
const KEEPS_FACTORS: f64 = 1.2;

pub(crate) struct Implicit<'a, S> {
    method: Collocation<S>,
    tolerance: Tolerance,
    jacobian: Jacobian<'a>,
    n: usize,
    z: Vec<S>,
    /// Z_i of the last step whose iteration converged, and its size: the predictor of the next step.
    known: Vec<f64>,
    known_step: Option<f64>,
    stage: Vec<S>,
    slopes: Vec<S>,
    /// f at the point where the defect is evaluated.
    probe_slope: Vec<S>,
    correction: Vec<f64>,
    predicted: Vec<f64>,
    matrix: StageMatrix,
    /// The time of the Jacobian common to all stages; then whether the next step must renew it.
    linearised_at: Option<S>,
    stale: bool,
    /// The convergence rate: the ratio of the last two corrections.
    rate: f64,
    /// The step size of the current factorisation.
    factorised: Option<f64>,
    spread: DefectSpread,
    /// The pole parameter g of the error estimate, see [`DefectSpread`].
    pole: f64,
    defect: Vec<f64>,
    plain: Vec<f64>,
    spectrum: SpectralRadius,
    /// The spectral radius of the last Jacobian; only in a scalar type finer than `f64`.
    radius: f64,
    accepted: bool,
    /// Whether the last attempt was accepted.
    accepted_before: bool,
    /// The integral of the spectral radius over the accepted steps, a measure of stiffness; only in a scalar type finer
    /// than `f64`.
    pub turns: f64,
}

impl<'a, S: Real> Implicit<'a, S> {
    pub fn new(family: Family, stages: usize, jacobian: Jacobian<'a>, tolerance: &Tolerance, dimension: usize) -> Self {
        let (n, all) = (dimension, stages * dimension);
        let method = Collocation::<S>::new(family, stages);
        let matrix = method.matrix.iter().map(|row| row.iter().map(|a| a.approx()).collect()).collect();
        let fine = S::EPSILON < f64::EPSILON;
        let own_pole = if fine { 1.0 / stages as f64 } else { DefectSpread::pole(family, stages) };
        let matrix = StageMatrix::new(matrix, n, fine, own_pole);
        let pole = matrix.pole();
        Implicit {
            method,
            tolerance: tolerance.clone(),
            jacobian,
            n,
            z: vec![S::zero(); all],
            known: vec![0.0; all],
            known_step: None,
            stage: vec![S::zero(); n],
            slopes: vec![S::zero(); all],
            probe_slope: vec![S::zero(); n],
            correction: vec![0.0; all],
            predicted: vec![0.0; all],
            matrix,
            spread: DefectSpread::new(family, stages, pole),
            pole,
            linearised_at: None,
            stale: true,
            rate: 0.0,
            factorised: None,
            defect: vec![0.0; n],
            plain: vec![0.0; n],
            spectrum: SpectralRadius::new(n),
            radius: 0.0,
            accepted: false,
            accepted_before: false,
            turns: 0.0,
        }
    }

    /// Predicts the stages of a step of size `step`, as increments `z` from its start, by extrapolation of the last step's polynomial. In the first step
    /// the prediction is zero.
    fn predict(&mut self, step: f64) {
        let n = self.n;
        let Some(last) = self.known_step else {
            self.z.fill(S::zero());
            return;
        };
        // after a rejection the last polynomial begins at the start of this step, otherwise it ends there
        let begin = if self.accepted { 1.0 } else { 0.0 };
        let nodes = &self.method.nodes;
        let node = |j: usize| nodes[j].approx();
        self.predicted.fill(0.0);
        for i in 0..nodes.len() {
            let at = begin + node(i) * step / last;
            for j in 0..nodes.len() {
                // Lagrange polynomials for 0, c_1 .. c_s
                let others = (0..nodes.len()).filter(|k| *k != j);
                let weight = others.fold(at / node(j), |w, k| w * (at - node(k)) / (node(j) - node(k)));
                for c in 0..n {
                    self.predicted[i * n + c] += weight * self.known[j * n + c];
                }
            }
        }
        for c in 0..n {
            let ends = self.method.ends.iter().enumerate();
            let moved = ends.fold(0.0, |sum, (j, d)| sum + d.approx() * self.known[j * n + c]);
            for i in 0..nodes.len() {
                self.predicted[i * n + c] -= begin * moved;
            }
        }
        self.z.iter_mut().zip(&self.predicted).for_each(|(z, predicted)| *z = S::lift(*predicted));
    }

    /// Computes J_j at every stage, or J at the start of the step, and factorises Newton's matrix.
    fn linearise(&mut self, tau: S, y: &[S], step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        let (n, direction) = (self.n, meter.direction.approx());
        let one = self.matrix.is_uncoupled();
        self.linearised_at = None;
        for (j, matrix) in self.matrix.jacobians().enumerate() {
            for ((plain, y), z) in self.plain.iter_mut().zip(y).zip(&self.z[j * n..]) {
                *plain = if one { y.approx() } else { (*y + *z).approx() };
            }
            let at = if one { tau } else { tau + step * self.method.nodes[j] };
            self.jacobian.matrix(meter.time(at).approx(), &self.plain, matrix);
            matrix.iter_mut().for_each(|entry| *entry *= direction);
            meter.count_jacobian();
        }
        if !self.matrix.is_finite() {
            return Err(Cause::Undefined);
        }
        if !one {
            self.radius = self.spectrum.radius(self.matrix.jacobian());
        }
        (self.linearised_at, self.stale) = (Some(tau), false);
        self.factorise(step, meter)
    }

    fn factorise(&mut self, step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        self.factorised = Some(step.approx());
        meter.count_factorisation();
        if self.matrix.factorise(step.approx()) { Ok(()) } else { Err(Cause::Singular) }
    }

    /// Factorises Newton's matrix for a step, unless the current factorisation can be reused.
    fn prepare(&mut self, tau: S, y: &[S], step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        let fresh = self.linearised_at == Some(tau);
        if !self.matrix.is_uncoupled() || self.linearised_at.is_none() || self.stale && !fresh {
            self.linearise(tau, y, step, meter)
        } else if self.factorised != Some(step.approx()) {
            self.factorise(step, meter)
        } else {
            Ok(())
        }
    }

    /// Applies one Newton correction to Z. Returns its size in units of the tolerance.
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
        self.matrix.solve(&mut self.correction);
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

    /// Newton's iteration from the predictor. If it does not converge with a reused Jacobian, it is repeated with a new
    /// one.
    fn solve(&mut self, tau: S, y: &[S], step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        self.predict(step.approx());
        self.prepare(tau, y, step, meter)?;
        let solved = self.iterate(tau, y, step, meter);
        if solved.is_ok() || !self.matrix.is_uncoupled() || self.linearised_at == Some(tau) {
            return solved;
        }
        self.predict(step.approx());
        self.linearise(tau, y, step, meter)?;
        self.iterate(tau, y, step, meter)
    }

    /// Iterates until the error is [`LEFT_BY_NEWTON`] of the tolerance.
    fn iterate(&mut self, tau: S, y: &[S], step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        let kept = self.matrix.is_uncoupled();
        let most = if kept { MOST_KEPT + 2 * self.method.stages() } else { MOST_ITERATIONS };
        let mut last = f64::INFINITY;
        self.rate = 0.0;
        for iteration in 0..most {
            let size = self.correct(tau, y, step, meter);
            if !size.is_finite() {
                return Err(Cause::Undefined);
            }
            if iteration > 0 {
                self.rate = size / last;
            }
            let rate = if iteration > 0 { self.rate } else { FIRST_RATE };
            if size * (rate / (1.0 - rate).max(0.1)).min(1.0) <= LEFT_BY_NEWTON || (rate > 0.5 && size < 0.1) {
                self.stale = rate > KEEPS_JACOBIAN && iteration > 0;
                return Ok(());
            }
            let to_come = (LEFT_BY_NEWTON / size).ln() / rate.ln();
            let in_time = |left: f64| (0.0..left).contains(&to_come);
            if kept && iteration > 0 && !in_time((most - iteration) as f64) {
                return Err(Cause::Newton);
            }
            if rate >= 2.0 || (iteration > 2 && rate >= 0.95) {
                return Err(Cause::Newton);
            }
            if !kept && iteration > 0 && !in_time(PATIENCE) {
                self.linearise(tau, y, step, meter)?;
            }
            last = size;
        }
        Err(Cause::Newton)
    }

    /// The estimated error in units of the tolerance, and its order in the step size.
    fn error(&mut self, y: &[S], after: &[S], step: S) -> (f64, f64) {
        let (n, s) = (self.n, self.method.stages());
        for c in 0..n {
            let probe = self.method.probe.iter().enumerate();
            let slope = probe.fold(S::zero(), |sum, (j, e)| sum + *e * self.z[j * n + c]);
            self.defect[c] = (slope - step * self.probe_slope[c]).approx();
        }
        let plain = self.tolerance.norm(y, after, |c| self.defect[c]);
        let motion = self.z.chunks(n).map(|z| self.tolerance.norm(y, after, |c| z[c].approx())).fold(0.0, f64::max);
        let DefectSpread { degree, filters, small, large, plain: part } = self.spread;
        self.matrix.filter(&mut self.defect);
        let filtered = part * self.tolerance.norm(y, after, |c| self.defect[c]).min(plain);
        let varies = plain / motion.max(f64::MIN_POSITIVE);
        let error = if self.matrix.is_uncoupled() {
            (1..filters).for_each(|_| self.matrix.filter(&mut self.defect));
            (0..=degree).for_each(|_| self.through_modes());
            let pairs = self.defect.iter_mut().zip(&self.plain);
            pairs.for_each(|(defect, before)| *defect = small * before - large * *defect);
            // the convergence rate measures the variation of the Jacobian; a variation linear in time does not
            // contribute since M is orthogonal to it, its square does
            self.tolerance.norm(y, after, |c| self.defect[c]) + filtered * (varies + (2.0 * self.rate).powi(2)).min(1.0)
        } else {
            let half_turn = 0.5 * step.approx() * self.radius;
            let rough = (1..=degree).fold(1.0, |share, k| share * half_turn / (2 * k - 1) as f64);
            filtered * (rough + varies).min(1.0)
        };
        let power = if error > 0.5 * filtered { s + 1 } else { s + 1 + degree };
        (error, power as f64)
    }

    /// Multiplies the defect by w = ((1 - g z)^-1 - 1) / g, and stores the old value in `plain`.
    fn through_modes(&mut self) {
        let pole = self.pole;
        self.plain.copy_from_slice(&self.defect);
        self.matrix.filter(&mut self.defect);
        self.defect.iter_mut().zip(&self.plain).for_each(|(defect, before)| *defect = (*defect - before) / pole);
    }
}

impl<S: Real> Stepper<S> for Implicit<'_, S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        let length = step.approx();
        if let Err(cause) = self.solve(tau, before, step, meter) {
            let factor = match cause {
                Cause::Undefined => 0.25,
                // the variation of the Jacobian is proportional to the step size, the residual after a correction to
                // its square
                Cause::Newton if self.matrix.is_uncoupled() => (RATE_AIMED_AT / self.rate).sqrt().clamp(0.1, 0.5),
                _ => 0.5,
            };
            self.accepted_before = false;
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
        let most = match self.matrix.is_uncoupled() {
            true => (HIGHEST_RATE / self.rate).powf(0.7).clamp(1.0, 5.0),
            false => 5.0,
        };
        let most = if self.accepted_before || self.known_step.is_none() { most } else { 1.0 };
        self.known.iter_mut().zip(&self.z).for_each(|(known, z)| *known = z.approx());
        self.known_step = Some(length);
        self.accepted = error <= 1.0;
        self.accepted_before = self.accepted;
        let factor = (0.9 * error.max(1e-300).powf(-1.0 / power)).clamp(0.2, most);
        let kept = self.matrix.is_uncoupled() && !self.stale && (1.0..KEEPS_FACTORS).contains(&factor);
        let next = if kept { length } else { factor * length };
        if self.accepted {
            self.turns += length * self.radius;
            Attempt::Accepted { next }
        } else {
            let cause = if error.is_nan() { Cause::Undefined } else { Cause::Error };
            Attempt::Rejected { next: if error.is_nan() { 0.25 * length } else { next }, cause }
        }
    }
}
