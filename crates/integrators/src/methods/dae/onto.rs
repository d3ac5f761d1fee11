//! Projection onto the constraint along given columns: y + B d with g(t, y + B d) = 0.

use super::Index2Dae;
use crate::law::jacobian::{slope, variable};
use crate::newton::Lu;
use crate::newton::Newton;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::Cause;
use crate::{DIRECTIONS, Dual8, Real};

/// Newton's iteration for d with the exact derivative of g, until rounding stops its progress.
pub(super) struct Onto<'a, S> {
    pub law: &'a dyn Index2Dae<S>,
    varied: &'a dyn Index2Dae<Dual8>,
    pub n: usize,
    pub m: usize,
    /// The m columns of B, each with n entries.
    pub columns: Vec<S>,
    /// The displacement coefficients d.
    pub moved: Vec<S>,
    g: Vec<S>,
    y: Vec<Dual8>,
    slopes: Vec<Dual8>,
    /// The n columns of g_y, row by row.
    rows: Vec<f64>,
    correction: Vec<f64>,
    lu: Lu,
}

impl<'a, S: Real> Onto<'a, S> {
    pub fn new(law: &'a dyn Index2Dae<S>, varied: &'a dyn Index2Dae<Dual8>) -> Self {
        let (n, m) = law.sizes();
        let zero = Dual8::from_re(0.0);
        Onto {
            law,
            varied,
            n,
            m,
            columns: vec![S::zero(); n * m],
            moved: vec![S::zero(); m],
            g: vec![S::zero(); m],
            y: vec![zero; n],
            slopes: vec![zero; m],
            rows: vec![0.0; n * m],
            correction: vec![0.0; m],
            lu: Lu::new(m),
        }
    }

    /// Computes f, in `rates`, and B at the state y and the time `tau` of the run; NaN if the budget is exhausted.
    pub fn parts(&mut self, tau: S, y: &[S], rates: &mut [S], meter: &BudgetedRhs<S>) {
        if !meter.charge(1) {
            rates.fill(S::lift(f64::NAN));
            return;
        }
        self.law.parts(meter.time(tau), y, rates, &mut self.columns);
        rates.iter_mut().chain(&mut self.columns).for_each(|part| *part *= meter.direction);
    }

    /// Replaces y by y + B d. Without constraints y is unchanged.
    pub fn bring(&mut self, tau: S, y: &mut [S], meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        if self.m == 0 {
            return Ok(());
        }
        let t = meter.time(tau);
        self.moved.fill(S::zero());
        let mut newton = Newton::new();
        loop {
            self.law.constraints(t, y, &mut self.g);
            meter.count_constraints();
            if newton.wants_matrix() {
                self.linearise(t.approx(), y, meter)?;
            }
            let n = self.n;
            self.correction.iter_mut().zip(&self.g).for_each(|(d, g)| *d = -g.approx());
            self.lu.solve(&mut self.correction);
            let (mut size, mut scale) = (0.0_f64, 0.0_f64);
            for (c, y) in y.iter_mut().enumerate() {
                let columns = self.columns.chunks(n).zip(&self.correction);
                let change = columns.fold(S::zero(), |sum, (column, d)| sum + column[c] * S::lift(*d));
                *y += change;
                let change = change.approx().abs();
                size = if change.is_nan() { change } else { size.max(change) };
                scale = scale.max(y.approx().abs());
            }
            self.moved.iter_mut().zip(&self.correction).for_each(|(moved, d)| *moved += S::lift(*d));
            if newton.corrected::<S>(size, scale)? {
                return Ok(());
            }
        }
    }

    /// Factorises g_y B at (t, y).
    fn linearise(&mut self, t: f64, y: &[S], meter: &BudgetedRhs<S>) -> Result<(), Cause> {
        self.derive(t, y);
        for (row, entries) in self.rows.chunks(self.n).zip(self.lu.rows()) {
            for (entry, column) in entries.iter_mut().zip(self.columns.chunks(self.n)) {
                *entry = row.iter().zip(column).map(|(a, b)| a * b.approx()).sum();
            }
        }
        meter.count_factorisation();
        if self.lu.factorise() { Ok(()) } else { Err(Cause::Singular) }
    }

    /// Computes g_y at (t, y).
    fn derive(&mut self, t: f64, y: &[S]) {
        let n = self.n;
        self.y.iter_mut().zip(y).for_each(|(own, y)| *own = Dual8::from_re(y.approx()));
        for first in (0..n).step_by(DIRECTIONS) {
            let block = first..n.min(first + DIRECTIONS);
            block.clone().for_each(|c| self.y[c] = variable(y[c].approx(), c - first));
            self.varied.constraints(Dual8::from_re(t), &self.y, &mut self.slopes);
            for (row, g) in self.rows.chunks_mut(n).zip(&self.slopes) {
                block.clone().for_each(|c| row[c] = slope(g, c - first));
            }
            block.for_each(|c| self.y[c] = Dual8::from_re(y[c].approx()));
        }
    }
}
