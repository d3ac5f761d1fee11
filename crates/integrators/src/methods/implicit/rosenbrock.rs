//! Rodas4: a linearly implicit Rosenbrock pair of order 4(3) with 6 stages, stiffly accurate and L-stable.
//!
//! The method has no Newton iteration. With J = df/dy, g = 1/4 and one factorisation of 1/(h g) I - J the stages U_i
//! solve
//!
//!   (1/(h g) I - J) U_i = f(t + a_i h, y + sum_j A_ij U_j) + sum_j C_ij U_j / h + h d_i df/dt,
//!
//! where the arguments of the last two stages are y_5 = y + sum A_5j U_j and y_6 = y_5 + U_5. The result is y_6 + U_6,
//! and U_6 is the error estimate.
//!
//! Method and coefficients: Hairer and Wanner, Solving Ordinary Differential Equations II (1996), IV.7, code RODAS. The
//! coefficients are known to 16 digits, therefore the method runs in `f64` only.

use crate::Tolerance;
use crate::law::jacobian::Jacobian;
use crate::methods::implicit::linearisation::Linearised;
use crate::newton::Shifted;
use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};

const STAGES: usize = 6;

/// The coefficients in transformed variables, which avoid products with J.
#[derive(Clone, Copy)]
struct Coefficients {
    gamma: f64,
    /// A_ij of stages 2 to 5; stage 6 is y_5 + U_5.
    a: [[f64; 4]; 5],
    /// C_ij.
    c: [[f64; 5]; 6],
    /// The nodes a_i.
    times: [f64; 6],
    /// The coefficients d_i of df/dt.
    drift: [f64; 6],
}

const RODAS4: Coefficients = Coefficients {
    gamma: 0.25,
    a: [
        [0.0; 4],
        [1.544, 0.0, 0.0, 0.0],
        [0.9466785280815826, 0.2557011698983284, 0.0, 0.0],
        [3.314825187068521, 2.896124015972201, 0.9986419139977817, 0.0],
        [1.221224509226641, 6.019134481288629, 12.53708332932087, -0.687886036105895],
    ],
    c: [
        [0.0; 5],
        [-5.6688, 0.0, 0.0, 0.0, 0.0],
        [-2.430093356833875, -0.2063599157091915, 0.0, 0.0, 0.0],
        [-0.1073529058151375, -9.594562251023355, -20.47028614809616, 0.0, 0.0],
        [7.496443313967647, -10.24680431464352, -33.99990352819905, 11.7089089320616, 0.0],
        [8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054],
    ],
    times: [0.0, 0.386, 0.21, 0.63, 1.0, 1.0],
    drift: [0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0],
};

pub(crate) struct Rodas4<'a> {
    coefficients: Coefficients,
    tolerance: Tolerance,
    linear: Linearised<'a>,
    matrix: Shifted,
    stages: [Vec<f64>; STAGES],
    point: Vec<f64>,
    slope: Vec<f64>,
    after_rejection: bool,
}

impl<'a> Rodas4<'a> {
    pub fn new(jacobian: Jacobian<'a>, tolerance: &Tolerance, dimension: usize) -> Self {
        let zeros = || vec![0.0; dimension];
        Rodas4 {
            coefficients: RODAS4,
            tolerance: tolerance.clone(),
            linear: Linearised::new(jacobian, dimension),
            matrix: Shifted::new(dimension),
            stages: std::array::from_fn(|_| zeros()),
            point: zeros(),
            slope: zeros(),
            after_rejection: false,
        }
    }

    /// Factorises 1/(h g) I - J. Returns false if the matrix is singular or not finite.
    fn factorise(&mut self, step: f64, meter: &BudgetedRhs<f64>) -> bool {
        meter.count_factorisation();
        self.matrix.factorise(1.0 / (step * self.coefficients.gamma))
    }

    /// Computes U_i from the argument of f and the earlier stages.
    fn stage(&mut self, i: usize, tau: f64, step: f64, meter: &BudgetedRhs<f64>) {
        let Coefficients { c, times, drift, .. } = &self.coefficients;
        if i == 0 {
            self.slope.copy_from_slice(&self.linear.slope);
        } else {
            meter.rates(tau + times[i] * step, &self.point, &mut self.slope);
        }
        let (before, rest) = self.stages.split_at_mut(i);
        for (k, u) in rest[0].iter_mut().enumerate() {
            let memory: f64 = before.iter().zip(&c[i]).map(|(stage, c)| c * stage[k]).sum();
            *u = self.slope[k] + memory / step + step * drift[i] * self.linear.drift[k];
        }
        self.matrix.solve(&mut rest[0]);
    }
}

impl Stepper<f64> for Rodas4<'_> {
    fn attempt(&mut self, tau: f64, before: &[f64], step: f64, after: &mut [f64], meter: &BudgetedRhs<f64>) -> Attempt {
        if self.linear.at(tau, before, meter) {
            self.matrix.take(&self.linear.matrix);
        }
        if !self.factorise(step, meter) {
            return Attempt::Rejected { next: 0.5 * step, cause: self.linear.unfactorised() };
        }
        for i in 0..STAGES {
            if i < 5 {
                self.point.copy_from_slice(before);
                for (stage, a) in self.stages.iter().zip(&self.coefficients.a[i]).take(i) {
                    self.point.iter_mut().zip(stage).for_each(|(point, u)| *point += a * u);
                }
            } else {
                self.point.iter_mut().zip(&self.stages[4]).for_each(|(point, u)| *point += u);
            }
            self.stage(i, tau, step, meter);
        }
        let last = &self.stages[STAGES - 1];
        for ((after, point), u) in after.iter_mut().zip(&self.point).zip(last) {
            *after = point + u;
        }
        let error = self.tolerance.norm(before, after, |i| last[i]);
        if error.is_nan() {
            self.after_rejection = true;
            return Attempt::Rejected { next: 0.25 * step, cause: Cause::Undefined };
        }
        let most = if self.after_rejection { 1.0 } else { 6.0 };
        let next = step * (0.9 * error.max(1e-10).powf(-0.25)).clamp(0.2, most);
        self.after_rejection = error > 1.0;
        if error <= 1.0 { Attempt::Accepted { next } } else { Attempt::Rejected { next, cause: Cause::Error } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Span;
    use crate::law::bell::Bell;

    /// The error at t = 2 after this many equal steps.
    fn error(coefficients: Coefficients, steps: u32) -> f64 {
        let mut method = Rodas4 { coefficients, ..Rodas4::new(Jacobian::new(&Bell), &Tolerance::both(1e-2), 1) };
        let (span, step) = (Span::new(0.0, 2.0, &[1.0]), 2.0 / f64::from(steps));
        let meter = BudgetedRhs::new(&Bell, &span);
        let (mut y, mut after) = ([1.0], [0.0]);
        for k in 0..steps {
            method.attempt(step * f64::from(k), &y, step, &mut after, &meter);
            y = after;
        }
        (y[0] - 0.2).abs()
    }

    fn order(coefficients: Coefficients) -> f64 {
        (error(coefficients, 100) / error(coefficients, 200)).log2()
    }

    #[test]
    fn the_coefficients_give_order_4_for_a_nonlinear_law_that_depends_on_time() {
        assert!((order(RODAS4) - 4.0).abs() < 0.3, "{}", order(RODAS4));
    }

    #[test]
    fn any_wrong_coefficient_costs_the_order() {
        for i in 1..5 {
            for j in 0..i {
                let mut wrong = RODAS4;
                wrong.a[i][j] += 1e-2;
                assert!(order(wrong) < 3.5, "A {i} {j}: {}", order(wrong));
                let mut wrong = RODAS4;
                wrong.c[i][j] += 1e-2;
                assert!(order(wrong) < 3.5, "C {i} {j}: {}", order(wrong));
            }
            let mut wrong = RODAS4;
            wrong.times[i] += 1e-2;
            assert!(order(wrong) < 3.5, "time {i}: {}", order(wrong));
        }
    }
}
