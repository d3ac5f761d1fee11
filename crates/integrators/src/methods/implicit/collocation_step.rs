//! The steps of the collocation methods: Newton's iteration with a matrix in `f64`, residuals in the field of the run.
//!
//! The unknowns are Z_i = Y_i - y_0. Newton's matrix ([`StageMatrix`]) decides how fast the iteration converges, never its limit:
//! the residuals are those of the run's field. In double precision its Jacobian is kept over steps while the iteration converges
//! fast, and its factors while the step hardly changes, as in Hairer and Wanner's RADAU5; in a finer field it holds the
//! Jacobians of all stages, renewed where that pays.
//!
//! The error is estimated from the defect of the collocation polynomial ([`DefectSpread`]). The variation of the defect and of the Jacobian over
//! the step adds a part, measured by the smoothness of the solution and by the convergence of Newton's iteration. In a finer field every stage
//! has its own Jacobian, and convergence measures nothing; there the spectral radius of h J bounds the error, more widely.

use crate::law::jacobian::Jacobian;
use crate::methods::implicit::collocation::{Collocation, Family};
use crate::methods::implicit::defect_spread::DefectSpread;
use crate::methods::implicit::stage_matrix::StageMatrix;
use crate::newton::SpectralRadius;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Real, Tolerance};

/// Iterations after which a step is shortened.
const MOST_ITERATIONS: usize = 30;
/// The number of iterations with a kept Jacobian after which it is renewed, and two more for each stage.
const MOST_KEPT: usize = 6;
/// Iterations still to come that make fresh Jacobians pay.
const PATIENCE: f64 = 8.0;
/// The share of the tolerance that Newton's iteration may leave as error.
const LEFT_BY_NEWTON: f64 = 0.01;
/// The Jacobian is kept for the next step if the last correction is at most this part of the one before it.
const KEEPS_JACOBIAN: f64 = 0.01;
/// The ratio of two corrections at which the step after a failed iteration aims.
const RATE_AIMED_AT: f64 = 0.2;
/// The ratio assumed at the first correction, before there is one.
const FIRST_RATE: f64 = 0.5;
/// The largest ratio that the next step may be expected to have.
const HIGHEST_RATE: f64 = 0.4;
/// The factors, and the step with them, are kept while the next step could be at most so many times as long.
const KEEPS_FACTORS: f64 = 1.2;

pub(crate) struct Implicit<'a, S> {
    method: Collocation<S>,
    tolerance: Tolerance,
    jacobian: Jacobian<'a>,
    n: usize,
    z: Vec<S>,
    /// Z_i of the last step whose iteration converged, and its length: the predictor of the next.
    known: Vec<f64>,
    known_step: Option<f64>,
    stage: Vec<S>,
    slopes: Vec<S>,
    /// The slope at the point where the defect is evaluated.
    probe_slope: Vec<S>,
    correction: Vec<f64>,
    predicted: Vec<f64>,
    matrix: StageMatrix,
    /// The point of the one Jacobian of all stages, and whether the next step takes another.
    linearised_at: Option<S>,
    stale: bool,
    /// The ratio of the last correction to the one before it.
    rate: f64,
    /// The step for which the factors were made.
    factorised: Option<f64>,
    spread: DefectSpread,
    /// g
    pole: f64,
    defect: Vec<f64>,
    plain: Vec<f64>,
    spectrum: SpectralRadius,
    /// The spectral radius of the last Jacobian, in a field finer than `f64`.
    radius: f64,
    accepted: bool,
    /// Whether the last attempt was accepted.
    accepted_before: bool,
    /// The integral of the spectral radius over the accepted steps, in a field finer than `f64`: a measure of stiffness.
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

    /// Starts Newton from the last step's polynomial, extrapolated; from rest in the first step.
    fn predict(&mut self, step: f64) {
        let n = self.n;
        let Some(last) = self.known_step else {
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

    /// J_j at every stage, or the one J of a step at its start, and the factors of Newton's matrix.
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

    /// Makes Newton's matrix for a step, unless the present one serves.
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

    /// Newton's iteration from the predicted stages; once more with a Jacobian of this step where it does not converge with a kept
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

    /// Newton's iteration to a small part of the tolerance.
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

    /// The error in units of the tolerance, and its order in the step size.
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
            // the ratio of corrections shows how much the Jacobian varies; a change in proportion to the time is hidden from M, its square
            // is not
            self.tolerance.norm(y, after, |c| self.defect[c]) + filtered * (varies + (2.0 * self.rate).powi(2)).min(1.0)
        } else {
            let half_turn = 0.5 * step.approx() * self.radius;
            let rough = (1..=degree).fold(1.0, |share, k| share * half_turn / (2 * k - 1) as f64);
            filtered * (rough + varies).min(1.0)
        };
        let power = if error > 0.5 * filtered { s + 1 } else { s + 1 + degree };
        (error, power as f64)
    }

    /// Multiplies the defect by w = ((1 - g z)^-1 - 1) / g, and keeps the old value.
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
                // the Jacobian changes in proportion to the step, and the residual of a correction as its square
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
