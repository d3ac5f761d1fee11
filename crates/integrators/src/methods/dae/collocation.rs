//! Collocation for DAEs of index 2: Z_i = h sum_j a_ij (f + B z)(Y_j), 0 = g(Y_i), by Newton's iteration in all Z_i and
//! z_i.
//!
//! Newton's matrix consists of the Jacobians of the stages in `f64`, by forward differentiation. The residuals are
//! computed in the scalar type of the run. Newton's iteration continues until rounding stops its progress.

use super::Whole;
use super::onto::Onto;
use crate::law::jacobian::Jacobian;
use crate::methods::implicit::collocation::{Collocation, Family};
use crate::newton::Lu;
use crate::newton::Newton;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Dual8, Real};

pub(super) struct Collocated<'a, S> {
    method: Collocation<S>,
    step: S,
    onto: Onto<'a, S>,
    jacobian: Jacobian<'a>,
    /// (Z_i, z_i), stage by stage. At the start of a step: the values of the previous step, as a predictor.
    unknowns: Vec<S>,
    /// (Y_j, z_j) of one stage.
    stage: Vec<S>,
    /// (f + B z, g) of the stages.
    rates: Vec<S>,
    jacobians: Vec<f64>,
    plain: Vec<f64>,
    correction: Vec<f64>,
    lu: Lu,
}

impl<'a, S: Real> Collocated<'a, S> {
    pub fn new(family: Family, stages: usize, step: S, slopes: &'a Whole<'a, Dual8>, onto: Onto<'a, S>) -> Self {
        let one = onto.n + onto.m;
        let all = stages * one;
        Collocated {
            method: Collocation::new(family, stages),
            step,
            onto,
            jacobian: Jacobian::new(slopes),
            unknowns: vec![S::zero(); all],
            stage: vec![S::zero(); one],
            rates: vec![S::zero(); all],
            jacobians: vec![0.0; all * one],
            plain: vec![0.0; one],
            correction: vec![0.0; all],
            lu: Lu::new(all),
        }
    }

    /// Computes the residuals at the current stages, and the Jacobians if `jacobians` is set.
    fn evaluate(&mut self, tau: S, before: &[S], step: S, jacobians: bool, meter: &BudgetedRhs<S>) {
        let (n, one) = (self.onto.n, self.stage.len());
        for (j, rates) in self.rates.chunks_mut(one).enumerate() {
            self.stage.copy_from_slice(&self.unknowns[j * one..][..one]);
            self.stage[..n].iter_mut().zip(before).for_each(|(stage, before)| *stage += *before);
            let at = tau + step * self.method.nodes[j];
            meter.rates(at, &self.stage, rates);
            if !jacobians {
                continue;
            }
            self.plain.iter_mut().zip(&self.stage).for_each(|(plain, y)| *plain = y.approx());
            let matrix = &mut self.jacobians[j * one * one..][..one * one];
            self.jacobian.matrix(meter.time(at).approx(), &self.plain, matrix);
            matrix.iter_mut().for_each(|entry| *entry *= meter.direction.approx());
            meter.count_jacobian();
        }
    }

    /// Factorises Newton's matrix.
    fn linearise(&mut self, step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        let (n, one) = (self.onto.n, self.stage.len());
        if !self.jacobians.iter().all(|slope| slope.is_finite()) {
            return Err(Cause::Undefined);
        }
        for (row, entries) in self.lu.rows().enumerate() {
            let (i, c) = (row / one, row % one);
            for (j, (part, jacobian)) in entries.chunks_mut(one).zip(self.jacobians.chunks(one * one)).enumerate() {
                let factor = match c < n {
                    true => -(step * self.method.matrix[i][j]).approx(),
                    false if i == j => -1.0,
                    false => 0.0,
                };
                part.iter_mut().zip(&jacobian[c * one..]).for_each(|(entry, slope)| *entry = factor * slope);
            }
            if c < n {
                entries[row] += 1.0;
            }
        }
        meter.count_factorisation();
        if self.lu.factorise() { Ok(()) } else { Err(Cause::Singular) }
    }

    /// Sets up and solves Newton's equations for a correction.
    fn solve(&mut self, step: S) {
        let (n, one) = (self.onto.n, self.stage.len());
        for (row, correction) in self.correction.iter_mut().enumerate() {
            let (i, c) = (row / one, row % one);
            *correction = if c < n {
                let moved = self.method.matrix[i].iter().zip(self.rates.chunks(one));
                moved.fold(-self.unknowns[row], |sum, (a, rates)| sum + step * *a * rates[c]).approx()
            } else {
                self.rates[row].approx()
            };
        }
        self.lu.solve(&mut self.correction);
    }

    fn iterate(&mut self, tau: S, before: &[S], step: S, meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        let (n, one) = (self.onto.n, self.stage.len());
        let scale = before.iter().fold(0.0_f64, |scale, y| scale.max(y.approx().abs()));
        let mut newton = Newton::new();
        loop {
            let renewed = newton.wants_matrix();
            self.evaluate(tau, before, step, renewed, meter);
            if renewed {
                self.linearise(step, meter)?;
            }
            self.solve(step);
            self.unknowns.iter_mut().zip(&self.correction).for_each(|(u, d)| *u += S::lift(*d));
            // the multipliers are accurate only to the rounding of y over h, so that only y is tested for convergence
            let moved = self.correction.chunks(one).flat_map(|stage| &stage[..n]);
            let size = moved.fold(0.0_f64, |size, d| if d.is_nan() { *d } else { size.max(d.abs()) });
            // relative to the state at the end of a step that begins at the origin
            let steps = self.unknowns.chunks(one).flat_map(|stage| &stage[..n]);
            let scale = steps.fold(scale, |scale, z| scale.max(z.approx().abs()));
            if newton.corrected::<S>(size, scale)? {
                return Ok(());
            }
        }
    }
}

impl<S: Real> Stepper<S> for Collocated<'_, S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        let (n, one) = (self.onto.n, self.stage.len());
        self.unknowns.chunks_mut(one).for_each(|stage| stage[..n].fill(S::zero()));
        let solved = self.iterate(tau, before, step, meter);
        let ends = || self.method.ends.iter().zip(self.unknowns.chunks(one));
        for (c, (after, before)) in after.iter_mut().zip(before).enumerate() {
            *after = ends().fold(*before, |sum, (d, stage)| sum + *d * stage[c]);
        }
        let brought = solved.and_then(|()| match self.method.family {
            Family::RadauIIA => Ok(()),
            Family::Gauss => {
                self.onto.parts(tau + step, after, &mut self.stage[..n], meter);
                self.onto.bring(tau + step, after, meter)
            }
        });
        match brought {
            Ok(()) => Attempt::Accepted { next: 0.0 },
            Err(cause) => Attempt::Rejected { next: 0.0, cause },
        }
    }

    fn fixed(&self) -> Option<S> {
        Some(self.step)
    }
}
