//! Bader-Deuflhard: extrapolation of the linearly implicit midpoint rule with variable order and step size, for stiff
//! laws.
//!
//! The method has no Newton iteration. With J = df/dy and f_t = df/dt at the step's start, h = H/n and z = y - y_0 the
//! rule is
//!
//!   (I - h J) D_0 = h f(y_0) + h^2 f_t,  D_k = D_{k-1} + 2 (I - h J)^-1 (h f(y_k) - D_{k-1}),  z_{k+1} = z_k + D_k,
//!
//! and the result of a row is the mean T = (z_{n-3} + 3 z_{n-1} + 3 z_{n+1} + z_{n+3})/8. Its error has an expansion in
//! even powers of h (Bader and Deuflhard, Numer. Math. 41, 1983). It is extrapolated over
//! n_j = 6, 10, 14, 22, 34, 50, 70, 98. The mean adds an error 3/2 h^2 y'' of one substep: k rows have the order
//! 2 k - 1. A step needs one Jacobian, a row one factorisation.
//!
//! Reason for the mean of four points: a component that decays as exp(-r t) with r h >> 1 changes its sign at every
//! second substep and hardly decays, z_{k+1} = -(1 - 2/(r h)) z_{k-1}; the first substep leaves h^3 y'''/3 of it. The
//! mean of two points by Bader and Deuflhard reduces this by the factor 1/(r h), and the row by exp(-n^2/(r H)).
//! Expanded in n^2 this contains the term H y'''/(3 r^2), equal in all rows, which extrapolation cannot remove. The
//! mean of four points has the factor 1/(r h)^3 instead, which leaves y'''/(3 r^3).
//!
//! Hairer and Wanner, Solving Ordinary Differential Equations II (1996), IV.9.

use crate::Tolerance;
use crate::law::jacobian::Jacobian;
use crate::methods::extrapolation_control::Columns;
use crate::methods::implicit::linearisation::Linearised;
use crate::newton::Shifted;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};

/// The numbers of substeps n_j.
const SUBSTEPS: [usize; 8] = [6, 10, 14, 22, 34, 50, 70, 98];
/// The number of substeps beyond the end of the step that the mean of a row uses.
const BEYOND: usize = 3;
/// The work of a Jacobian, and of a factorisation, in substeps; measured with 15 states.
const JACOBIAN: f64 = 5.0;
const FACTORISATION: f64 = 4.0;

pub(crate) struct BaderDeuflhard<'a> {
    tolerance: Tolerance,
    columns: Columns,
    /// The factors 1 / ((n_j / n_{j-k})^2 - 1), by row and k.
    factors: Vec<Vec<f64>>,
    /// The last row of the table, T_{j,1} .., minus y_0: the difference keeps the digits of small increments.
    table: Vec<Vec<f64>>,
    linear: Linearised<'a>,
    matrix: Shifted,
    y: Vec<f64>,
    /// z_k and D_k.
    z: Vec<f64>,
    difference: Vec<f64>,
    change: Vec<f64>,
    /// The mean T.
    mean: Vec<f64>,
}

impl<'a> BaderDeuflhard<'a> {
    pub fn new(jacobian: Jacobian<'a>, tolerance: &Tolerance, dimension: usize) -> Self {
        let zeros = || vec![0.0; dimension];
        let row = |j: usize| FACTORISATION + (SUBSTEPS[j] + BEYOND) as f64;
        let costs = (0..SUBSTEPS.len()).map(|j| JACOBIAN + (0..=j).map(row).sum::<f64>()).collect();
        let factor = |j: usize, k: usize| 1.0 / ((SUBSTEPS[j] as f64 / SUBSTEPS[j - k] as f64).powi(2) - 1.0);
        let guess = (-0.6 * tolerance.relative.log10() + 0.5) as usize;
        BaderDeuflhard {
            tolerance: tolerance.clone(),
            columns: Columns::new(SUBSTEPS.to_vec(), costs, guess).damped(),
            factors: (0..SUBSTEPS.len()).map(|j| (1..=j).map(|k| factor(j, k)).collect()).collect(),
            table: SUBSTEPS.map(|_| zeros()).to_vec(),
            linear: Linearised::new(jacobian, dimension),
            matrix: Shifted::new(dimension),
            y: zeros(),
            z: zeros(),
            difference: zeros(),
            change: zeros(),
            mean: zeros(),
        }
    }

    /// The order of the first attempt.
    pub fn first_order(&self) -> u32 {
        self.columns.order()
    }

    /// Computes the Jacobian at the start of a step, unless this was done for a rejected attempt.
    fn linearise(&mut self, tau: f64, before: &[f64], meter: &BudgetedRhs<f64>) {
        if self.linear.at(tau, before, meter) {
            self.matrix.take(&self.linear.matrix);
        }
    }

    /// Factorises 1/h I - J.
    fn factorise(&mut self, h: f64, meter: &BudgetedRhs<f64>) -> Result<(), Cause> {
        meter.count_factorisation();
        if self.matrix.factorise(1.0 / h) {
            return Ok(());
        }
        Err(self.linear.unfactorised())
    }

    /// Computes row j of the table: the linearly implicit rule, then the extrapolations.
    fn row(&mut self, j: usize, tau: f64, before: &[f64], step: f64, meter: &BudgetedRhs<f64>) -> Result<(), Cause> {
        let (n, substeps) = (before.len(), self.columns.substeps(j));
        let h = step / substeps as f64;
        self.factorise(h, meter)?;
        for ((change, slope), drift) in self.difference.iter_mut().zip(&self.linear.slope).zip(&self.linear.drift) {
            *change = slope + h * drift;
        }
        self.matrix.solve(&mut self.difference);
        self.z.copy_from_slice(&self.difference);
        self.mean.fill(0.0);
        for k in 1..=substeps + BEYOND {
            let weight = match k.abs_diff(substeps) {
                BEYOND => 0.125,
                1 => 0.375,
                _ => 0.0,
            };
            if weight > 0.0 {
                self.mean.iter_mut().zip(&self.z).for_each(|(mean, z)| *mean += weight * z);
            }
            if k == substeps + BEYOND {
                break;
            }
            for ((y, start), z) in self.y.iter_mut().zip(before).zip(&self.z) {
                *y = start + z;
            }
            meter.rates(tau + h * k as f64, &self.y, &mut self.change);
            for (change, difference) in self.change.iter_mut().zip(&self.difference) {
                *change -= difference / h;
            }
            self.matrix.solve(&mut self.change);
            for ((z, difference), change) in self.z.iter_mut().zip(&mut self.difference).zip(&self.change) {
                *difference += 2.0 * change;
                *z += *difference;
            }
        }
        for i in 0..n {
            let mut entry = self.mean[i];
            for (column, factor) in self.table.iter_mut().zip(&self.factors[j - 1]) {
                // the table still holds T_{j-1,k} here
                let better = entry + (entry - column[i]) * factor;
                column[i] = entry;
                entry = better;
            }
            self.table[j - 1][i] = entry;
        }
        Ok(())
    }
}

impl Stepper<f64> for BaderDeuflhard<'_> {
    fn attempt(&mut self, tau: f64, before: &[f64], step: f64, after: &mut [f64], meter: &BudgetedRhs<f64>) -> Attempt {
        self.linearise(tau, before, meter);
        for j in 1..=self.columns.last() {
            if let Err(cause) = self.row(j, tau, before, step, meter) {
                return self.columns.fail(step, cause);
            }
            let best = &self.table[j - 1];
            for ((after, before), gained) in after.iter_mut().zip(before).zip(best) {
                *after = before + gained;
            }
            if j > 1 {
                let lower = &self.table[j - 2];
                let error = self.tolerance.norm(before, after, |i| best[i] - lower[i]);
                if let Some(attempt) = self.columns.judge(j, error, step) {
                    return attempt;
                }
            }
        }
        self.columns.fail(step, Cause::Error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::bell::Bell;
    use crate::{Ode, Span, System};
    use field::{Over, Scalar};

    /// The error at t = 2 after equal steps with a fixed number of rows.
    fn error(rows: usize, steps: u32, spoil: impl Fn(&mut BaderDeuflhard)) -> f64 {
        let mut method = BaderDeuflhard::new(Jacobian::new(&Bell), &Tolerance::both(1e-2), 1);
        spoil(&mut method);
        let (span, step) = (Span::new(0.0, 2.0, &[1.0]), 2.0 / f64::from(steps));
        let meter = BudgetedRhs::new(&Bell, &span);
        let mut y = [1.0];
        for k in 0..steps {
            let tau = step * f64::from(k);
            method.linearise(tau, &y, &meter);
            for j in 1..=rows {
                assert!(method.row(j, tau, &y, step, &meter).is_ok());
            }
            y[0] += method.table[rows - 1][0];
        }
        (y[0] - 0.2).abs()
    }

    fn order(rows: usize, steps: u32, spoil: impl Fn(&mut BaderDeuflhard) + Copy) -> f64 {
        (error(rows, steps, spoil) / error(rows, 2 * steps, spoil)).log2()
    }

    #[test]
    fn so_many_rows_have_one_order_less_than_twice_their_number() {
        for (rows, steps) in [(1, 512), (2, 64), (3, 32)] {
            let (measured, theory) = (order(rows, steps, |_| ()), 2.0 * rows as f64 - 1.0);
            assert!((measured - theory).abs() < 0.4, "{rows} rows: {measured:.2}, theory {theory}");
        }
    }

    #[test]
    fn a_wrong_weight_costs_the_order() {
        for (j, k) in [(1, 0), (2, 0), (2, 1)] {
            let measured = order(3, 32, |method| method.factors[j][k] *= 1.001);
            assert!(measured < 4.5, "weight {j} {k}: {measured:.2}");
        }
    }

    /// A system with a stiff component: x and y move on the unit circle, and z follows x with the rate constant RATE.
    struct Follower;

    const RATE: f64 = 1e4;

    impl<S: Over<f64> + Scalar> Ode<S> for Follower {
        fn dimension(&self) -> usize {
            3
        }

        fn rates(&self, _t: S, y: &[S], dy: &mut [S]) {
            (dy[0], dy[1]) = (-y[1], y[0]);
            dy[2] = S::lift(RATE) * (y[0] - y[2]);
        }
    }

    impl System for Follower {}

    /// The error is smaller than H/(3 r^2) = 1e-9, which a mean of two points would leave in every row.
    #[test]
    fn what_follows_at_once_is_extrapolated_too() {
        let slow = RATE * RATE + 1.0;
        let follower = |t: f64| (RATE * RATE * t.cos() + RATE * t.sin()) / slow;
        let (start, step) = ([1.0, 0.0, follower(0.0)], 0.3);
        let span = Span::new(0.0, step, &start);
        let meter = BudgetedRhs::new(&Follower, &span);
        let mut method = BaderDeuflhard::new(Jacobian::new(&Follower), &Tolerance::both(1e-2), 3);
        method.linearise(0.0, &start, &meter);
        for j in 1..=6 {
            assert!(method.row(j, 0.0, &start, step, &meter).is_ok());
        }
        let error = start[2] + method.table[5][2] - follower(step);
        assert!(error.abs() < 1e-11, "{error:e}");
    }
}
