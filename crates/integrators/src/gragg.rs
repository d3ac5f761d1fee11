//! Gragg-Bulirsch-Stoer: extrapolation of the modified midpoint rule, variable order and step, over any field.
//!
//! Gragg's rule with n substeps of length h = H/n and his smoothing,
//! z_1 = y + h f(y), z_{m+1} = z_{m-1} + 2 h f(z_m), T = (z_{n-1} + z_n + h f(z_n)) / 2,
//! has an error in even powers of h (Gragg 1965), so that Aitken and Neville's table over n_j = 2, 4, 6, ...
//! T_{j,k+1} = T_{j,k} + (T_{j,k} - T_{j-1,k}) / ((n_j / n_{j-k})^2 - 1)
//! gains two orders a column (Bulirsch and Stoer 1966). Order and step are chosen together, as the pair with the least
//! work per unit of time (Deuflhard 1983; Hairer, Norsett and Wanner I, II.9).

use crate::classical::advance;
use crate::drive::{Attempt, Cause, Stepper};
use crate::meter::Meter;
use crate::{Real, Tolerance};

/// The most columns that pay: order 18 in `f64`, 32 in double-double.
fn most_columns<S: Real>() -> usize {
    if S::EPSILON > 1e-20 { 9 } else { 16 }
}

/// The method with its table. Column and row numbers count from 1, as in the formulas.
pub(crate) struct GraggBulirschStoer<S> {
    tolerance: Tolerance,
    /// The column at which convergence is expected.
    column: usize,
    /// Divisors 1 / ((n_j / n_{j-k})^2 - 1), by row and k.
    factors: Vec<Vec<S>>,
    /// The last row of the table, T_{j,1} ..: overwritten row by row.
    table: Vec<Vec<S>>,
    first_slope: Vec<S>,
    slope_at: Option<S>,
    previous: Vec<S>,
    current: Vec<S>,
    slope: Vec<S>,
    /// The best step for each column, and its work per unit of time.
    steps: Vec<f64>,
    efforts: Vec<f64>,
    after_rejection: bool,
}

/// Substeps of row j.
fn substeps(j: usize) -> usize {
    2 * j
}

/// Evaluations for all rows up to j.
fn cost(j: usize) -> f64 {
    (1 + j * (j + 1)) as f64
}

impl<S: Real> GraggBulirschStoer<S> {
    pub fn new(tolerance: &Tolerance, dimension: usize) -> Self {
        let most = most_columns::<S>();
        let zeros = || vec![S::zero(); dimension];
        let factor = |j: usize, k: usize| {
            let (fine, coarse) = (substeps(j).pow(2) as i64, substeps(j - k).pow(2) as i64);
            S::ratio(coarse, fine - coarse)
        };
        let guess = (-0.6 * tolerance.relative.log10() + 1.5) as usize;
        GraggBulirschStoer {
            tolerance: tolerance.clone(),
            column: guess.clamp(2, most - 1),
            factors: (1..=most).map(|j| (1..j).map(|k| factor(j, k)).collect()).collect(),
            table: (0..most).map(|_| zeros()).collect(),
            first_slope: zeros(),
            slope_at: None,
            previous: zeros(),
            current: zeros(),
            slope: zeros(),
            steps: vec![0.0; most + 1],
            efforts: vec![0.0; most + 1],
            after_rejection: false,
        }
    }

    /// The order at which the first step will be tried.
    pub fn first_order(&self) -> u32 {
        2 * self.column as u32
    }

    /// One row: Gragg's rule into the first column, then the extrapolations.
    fn row(&mut self, j: usize, tau: S, before: &[S], step: S, meter: &Meter<S>) {
        let n = substeps(j);
        let h = step / S::int(n as i64);
        self.previous.copy_from_slice(before);
        advance(before, h, &self.first_slope, &mut self.current);
        for m in 1..n {
            meter.rates(tau + h * S::int(m as i64), &self.current, &mut self.slope);
            for ((previous, current), slope) in self.previous.iter_mut().zip(&mut self.current).zip(&self.slope) {
                let next = *previous + (h + h) * *slope;
                *previous = std::mem::replace(current, next);
            }
        }
        meter.rates(tau + step, &self.current, &mut self.slope);
        let factors = &self.factors[j - 1];
        for i in 0..before.len() {
            let mut entry = (self.previous[i] + self.current[i] + h * self.slope[i]).half();
            for k in 1..j {
                // the table holds T_{j-1,k} still: replaced once it was used
                let better = entry + (entry - self.table[k - 1][i]) * factors[k - 1];
                self.table[k - 1][i] = entry;
                entry = better;
            }
            self.table[j - 1][i] = entry;
        }
    }

    /// The error of row j, and what it says about the best step at this column.
    fn judge(&mut self, j: usize, before: &[S], step: f64) -> f64 {
        let (lower, best) = (&self.table[j - 2], &self.table[j - 1]);
        let error = self.tolerance.norm(before, best, |i| (best[i] - lower[i]).approx());
        let power = 1.0 / (2 * j - 1) as f64;
        let (least, most) = (0.02_f64.powf(power), 50.0);
        let shrink = (error / 0.65).powf(power) / 0.94;
        let factor = (1.0 / shrink.max(1e-3)).clamp(least / 4.0, most);
        self.steps[j] = step * factor;
        self.efforts[j] = cost(j) / self.steps[j];
        error
    }

    /// Order and step after success at column `reached`.
    fn after_success(&mut self, reached: usize) -> f64 {
        let (most, target, w) = (self.table.len(), self.column, &self.efforts);
        let mut best = reached.min(target);
        if reached == 2 {
            best = if self.after_rejection { 2 } else { 3.min(most - 1) };
        } else if reached <= target {
            if w[reached - 1] < 0.8 * w[reached] {
                best = reached - 1;
            } else if w[reached] < 0.9 * w[reached - 1] {
                best = (reached + 1).min(most - 1);
            }
        } else {
            best = reached - 1;
            if reached > 3 && w[reached - 2] < 0.8 * w[reached - 1] {
                best = reached - 2;
            }
            if w[reached] < 0.9 * w[best] {
                best = reached.min(most - 1);
            }
        }
        let rise = if best <= reached { self.steps[best] } else { self.steps[reached] * cost(best) / cost(reached) };
        let (column, step) =
            if self.after_rejection { (best.min(reached), rise.min(self.steps[reached])) } else { (best, rise) };
        (self.column, self.after_rejection) = (column.max(2), false);
        step
    }

    /// Order and step after the table up to column `reached` did not converge.
    fn after_failure(&mut self, reached: usize) -> f64 {
        self.column = self.column.min(reached).max(2);
        if self.column > 2 && self.efforts[self.column - 1] < 0.8 * self.efforts[self.column] {
            self.column -= 1;
        }
        self.after_rejection = true;
        self.steps[self.column]
    }
}

impl<S: Real> Stepper<S> for GraggBulirschStoer<S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &Meter<S>) -> Attempt {
        if self.slope_at != Some(tau) {
            meter.rates(tau, before, &mut self.first_slope);
            self.slope_at = Some(tau);
        }
        let last = (self.column + 1).min(self.table.len());
        self.row(1, tau, before, step, meter);
        for j in 2..=last {
            self.row(j, tau, before, step, meter);
            let error = self.judge(j, before, step.approx());
            if !error.is_finite() {
                self.after_rejection = true;
                return Attempt::Rejected { next: step.approx() / 4.0, cause: Cause::Undefined };
            }
            if error <= 1.0 && j + 1 >= self.column {
                after.copy_from_slice(&self.table[j - 1]);
                return Attempt::Accepted { next: self.after_success(j) };
            }
            // each further column shrinks the error at least so: hopeless if that is not enough
            let gain =
                |to: usize| (j + 1..=to).map(|k| (substeps(k) as f64 / substeps(1) as f64).powi(2)).product::<f64>();
            if j + 1 >= self.column && error > gain(last) {
                let hoped = error / gain(self.column);
                let power = 1.0 / (2 * self.column - 1) as f64;
                self.after_rejection = true;
                let factor = (0.94 * (0.65 / hoped).powf(power)).clamp(0.1, 0.7);
                return Attempt::Rejected { next: factor * step.approx(), cause: Cause::Error };
            }
        }
        Attempt::Rejected { next: self.after_failure(last), cause: Cause::Error }
    }
}
