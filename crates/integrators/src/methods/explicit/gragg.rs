//! Gragg-Bulirsch-Stoer: extrapolation of the modified midpoint rule with variable order and step size, over any scalar
//! type.
//!
//! Gragg's rule with n substeps of length h = H/n, followed by his smoothing, is
//!
//!   z_1 = y + h f(y) ,   z_{m+1} = z_{m-1} + 2 h f(z_m) ,   T = (z_{n-1} + z_n + h f(z_n)) / 2 .
//!
//! Its error has an expansion in even powers of h (Gragg 1965). Therefore the table of Aitken and Neville over
//! n_j = 2, 4, 6, ...,
//!
//!   T_{j,k+1} = T_{j,k} + (T_{j,k} - T_{j-1,k}) / ((n_j / n_{j-k})^2 - 1) ,
//!
//! gains two orders per column (Bulirsch and Stoer 1966).

use crate::methods::explicit::classical::advance;
use crate::methods::extrapolation_control::Columns;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{Real, Tolerance};

/// The largest number of columns that pays: order 18 in `f64`, 32 in double-double.
fn most_columns<S: Real>() -> usize {
    if S::EPSILON > 1e-20 { 9 } else { 16 }
}

/// The method with its extrapolation table. Columns and rows are numbered from 1, as in the formulas.
pub(crate) struct GraggBulirschStoer<S> {
    tolerance: Tolerance,
    columns: Columns,
    /// The factors 1 / ((n_j / n_{j-k})^2 - 1), by row and k.
    factors: Vec<Vec<S>>,
    /// The last row of the table, T_{j,1} ...
    table: Vec<Vec<S>>,
    first_slope: Vec<S>,
    slope_at: Option<S>,
    previous: Vec<S>,
    current: Vec<S>,
    slope: Vec<S>,
}

/// The number of substeps of row j.
fn substeps(j: usize) -> usize {
    2 * j
}

/// The number of evaluations for rows 1 to j.
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
            columns: Columns::new((1..=most).map(substeps).collect(), (1..=most).map(cost).collect(), guess),
            factors: (1..=most).map(|j| (1..j).map(|k| factor(j, k)).collect()).collect(),
            table: (0..most).map(|_| zeros()).collect(),
            first_slope: zeros(),
            slope_at: None,
            previous: zeros(),
            current: zeros(),
            slope: zeros(),
        }
    }

    /// The order of the first attempt.
    pub fn first_order(&self) -> u32 {
        self.columns.order()
    }

    /// Computes row j of the table: Gragg's rule, then the extrapolations.
    fn row(&mut self, j: usize, tau: S, before: &[S], step: S, meter: &BudgetedRhs<S>) {
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
                // the table still holds T_{j-1,k} here
                let better = entry + (entry - self.table[k - 1][i]) * factors[k - 1];
                self.table[k - 1][i] = entry;
                entry = better;
            }
            self.table[j - 1][i] = entry;
        }
    }
}

impl<S: Real> Stepper<S> for GraggBulirschStoer<S> {
    fn attempt(&mut self, tau: S, before: &[S], step: S, after: &mut [S], meter: &BudgetedRhs<S>) -> Attempt {
        if self.slope_at != Some(tau) {
            meter.rates(tau, before, &mut self.first_slope);
            self.slope_at = Some(tau);
        }
        self.row(1, tau, before, step, meter);
        for j in 2..=self.columns.last() {
            self.row(j, tau, before, step, meter);
            let (lower, best) = (&self.table[j - 2], &self.table[j - 1]);
            let error = self.tolerance.norm(before, best, |i| (best[i] - lower[i]).approx());
            if let Some(attempt) = self.columns.judge(j, error, step.approx()) {
                after.copy_from_slice(best);
                return attempt;
            }
        }
        self.columns.fail(step.approx(), Cause::Error)
    }
}
