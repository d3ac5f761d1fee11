//! Order and step size control of an extrapolation method: it minimises the work per unit of time.
//!
//! After Deuflhard (Numer. Math. 41, 1983; SIAM Review 27, 1985); Hairer, Norsett and Wanner I, II.9; Hairer and Wanner
//! II, IV.9. Row j of the table is a run with n_j substeps. The error of row j is |T_{j,j} - T_{j,j-1}|, which is
//! proportional to the power 2 j - 1 of the step size, since the basic methods have expansions in squares. The power is
//! 2 j - 2 for methods whose rows end with a damping mean: the mean leaves a term in the square of the smallest substep
//! in every row.

use crate::run::stepping::{Attempt, Cause};

/// The state of the order control. Rows and columns are numbered from 1, as in the formulas.
pub(crate) struct Columns {
    /// The column at which convergence is expected.
    target: usize,
    /// The numbers of substeps n_j.
    substeps: Vec<usize>,
    /// The work of rows 1 to j, in evaluations.
    costs: Vec<f64>,
    /// The optimal step size for each column, and its work per unit of time.
    steps: Vec<f64>,
    efforts: Vec<f64>,
    after_rejection: bool,
    /// Whether the rows end with a damping mean. A step is then rejected at the last row only: for stiff laws the
    /// errors of coarse rows say little about those of fine rows, which damp more components.
    damped: bool,
}

impl Columns {
    /// `costs[j - 1]` is the work of rows 1 to j.
    pub fn new(substeps: Vec<usize>, costs: Vec<f64>, target: usize) -> Self {
        let most = substeps.len();
        let target = target.clamp(2, most - 1);
        Columns {
            target,
            substeps,
            costs,
            steps: vec![0.0; most + 1],
            efforts: vec![0.0; most + 1],
            after_rejection: false,
            damped: false,
        }
    }

    /// The last row of the next attempt.
    pub fn last(&self) -> usize {
        (self.target + 1).min(self.substeps.len())
    }

    /// The order of the next attempt.
    pub fn order(&self) -> u32 {
        2 * self.target as u32
    }

    /// n_j.
    pub fn substeps(&self, j: usize) -> usize {
        self.substeps[j - 1]
    }

    /// Marks a method whose rows end with a damping mean: its steps are rejected at the last row only.
    pub fn damped(self) -> Self {
        Columns { damped: true, ..self }
    }

    /// Records the error of row j >= 2, divided by the tolerance. Returns the result of the attempt of length `step`, or
    /// `None` if a further row must be computed.
    pub fn judge(&mut self, j: usize, error: f64, step: f64) -> Option<Attempt> {
        if !error.is_finite() {
            return Some(self.fail(step, Cause::Undefined));
        }
        let (least, most) = (0.02_f64.powf(self.power(j)), 50.0);
        let shrink = (error / 0.65).powf(self.power(j)) / 0.94;
        self.steps[j] = step * (1.0 / shrink.max(1e-3)).clamp(least / 4.0, most);
        self.efforts[j] = self.costs[j - 1] / self.steps[j];
        let last = self.last();
        if j + 1 < self.target {
            return None;
        }
        if error <= 1.0 {
            return Some(Attempt::Accepted { next: self.after_success(j) });
        }
        if self.damped {
            return (j == last).then(|| Attempt::Rejected { next: self.after_failure(), cause: Cause::Error });
        }
        // each further row reduces the error by at least this factor; otherwise convergence is impossible
        let gain = |to: usize| (j + 1..=to).map(|k| self.ratio(k)).product::<f64>();
        if error <= gain(last) {
            return None;
        }
        let hoped = error / gain(self.target);
        let factor = (0.94 * (0.65 / hoped).powf(self.power(self.target))).clamp(0.1, 0.7);
        self.after_rejection = true;
        Some(Attempt::Rejected { next: factor * step, cause: Cause::Error })
    }

    /// Rejects a step that has no result.
    pub fn fail(&mut self, step: f64, cause: Cause) -> Attempt {
        self.after_rejection = true;
        Attempt::Rejected { next: step / 4.0, cause }
    }

    /// (n_k / n_1)^2.
    fn ratio(&self, k: usize) -> f64 {
        (self.substeps(k) as f64 / self.substeps(1) as f64).powi(2)
    }

    /// Sets the order, and returns the step size, after convergence at column `reached`.
    fn after_success(&mut self, reached: usize) -> f64 {
        let (most, target, w) = (self.substeps.len(), self.target, &self.efforts);
        let cost = |j: usize| self.costs[j - 1];
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
        let (target, step) =
            if self.after_rejection { (best.min(reached), rise.min(self.steps[reached])) } else { (best, rise) };
        (self.target, self.after_rejection) = (target.max(2), false);
        step
    }

    /// Sets the order, and returns the step size, after the whole table did not converge.
    fn after_failure(&mut self) -> f64 {
        if self.target > 2 && self.efforts[self.target - 1] < 0.8 * self.efforts[self.target] {
            self.target -= 1;
        }
        self.after_rejection = true;
        self.steps[self.target]
    }

    /// The exponent of the error of row j in the step size control.
    fn power(&self, j: usize) -> f64 {
        1.0 / (2 * j - if self.damped { 2 } else { 1 }) as f64
    }
}
