//! The first-order error of a reduced model along a run of the full one.
//!
//! Let e = y - Y(z) be the distance of the full motion from the lifted reduced one, and d = dY/dt + Y_z f - F(Y) the
//! defect (the residual of the full law along the lifted motion) at the states along the full run. Then
//!
//!   e' = F_y e - d .
//!
//! Over a step h, with the Jacobian J at its midpoint, the new error is exp(h J) e - h phi_1(h J) d. All reduced models
//! share these matrices; a step then costs each model two evaluations of its law and two of the full law.

use crate::model_reduction::loss_weights::{Knot, cubic};
use crate::model_reduction::reduced_model::Lifted;
use integrators::{Jacobian, Ode};
use nalgebra::{DMatrix, DVector};
use simulation::Law;

/// The time over which a lift is differentiated, as a fraction of the step.
const BESIDE: f64 = 1e-4;
/// The number of steps of this propagation for one step of the run.
const FINER: usize = 1;

/// The fraction of an interval over which a cubic is differentiated numerically.
const SLOPE: f64 = 1e-3;
/// The estimate is credible if the defect changes by less than this fraction between the full motion and the reduced
/// one.
const BELIEVED: f64 = 0.5;
/// A run resolves a state if the cubic's rate is accurate to this fraction of the size.
const MISSED: f64 = 0.1;

/// A run of the full law with the transition matrices of its steps.
pub struct Weights {
    /// The initial time and state.
    start: (f64, Vec<f64>),
    steps: Vec<Step>,
}

/// The distance of the full motion from the lifted reduced one at a time, with the full state.
pub struct Distance<'a> {
    pub time: f64,
    pub state: &'a [f64],
    pub error: Vec<f64>,
}

struct Step {
    /// The length of the step, and the time and state at its midpoint.
    middle: (f64, f64, Vec<f64>),
    /// The time and state at the end of the step.
    end: (f64, Vec<f64>),
    /// The matrix exp(h J).
    whole: DMatrix<f64>,
    /// The matrix h phi_1(h J).
    integral: DMatrix<f64>,
}

impl Weights {
    /// The matrices along times and states of a run, including the start; `None` where a Jacobian is undefined, or the
    /// run has too few points for interpolation.
    pub fn along(law: &dyn Law, run: &[(f64, Vec<f64>)]) -> Option<Self> {
        let start = run.first()?.clone();
        let n = start.1.len();
        let mut jacobian = Jacobian::of(law);
        let mut rows = vec![0.0; n * n];
        let knot = |(time, state): &(f64, Vec<f64>)| {
            let mut rates = vec![0.0; n];
            law.rates(*time, state, &mut rates);
            (*time, state.clone(), rates)
        };
        let knots: Vec<_> = run.iter().map(knot).collect();
        let size = |i: usize| knots.iter().map(|(_, _, rates)| rates[i].abs()).fold(0.0, f64::max);
        let sizes: Vec<f64> = (0..n).map(size).collect();
        let mut steps = Vec::new();
        for ends in knots.windows(2).filter(|ends| ends[1].0 > ends[0].0) {
            let [begin, end] = [&ends[0], &ends[1]];
            let h = (end.0 - begin.0) / FINER as f64;
            for part in 0..FINER {
                let at = |share: f64| {
                    let share = (part as f64 + share) / FINER as f64;
                    (begin.0 + share * (end.0 - begin.0), cubic(begin, end, share))
                };
                let (time, state) = at(0.5);
                if !follows(law, [begin, end], (part as f64 + 0.5) / FINER as f64, (time, &state), &sizes) {
                    return None;
                }
                jacobian.matrix(time, &state, &mut rows);
                // exp of (h J, h; 0, 0) is (exp(h J), h phi_1(h J); 0, 1)
                let mut both = DMatrix::zeros(2 * n, 2 * n);
                both.view_mut((0, 0), (n, n)).copy_from(&(DMatrix::from_row_slice(n, n, &rows) * h));
                both.view_mut((0, n), (n, n)).copy_from(&(DMatrix::identity(n, n) * h));
                if !both.iter().all(|entry| entry.is_finite()) {
                    return None;
                }
                let both = both.exp();
                steps.push(Step {
                    middle: (h, time, state),
                    end: at(1.0),
                    whole: both.view((0, 0), (n, n)).into_owned(),
                    integral: both.view((0, n), (n, n)).into_owned(),
                });
            }
        }
        Some(Weights { start, steps })
    }

    /// The cost, in evaluations, of the matrices along a number of states and of the errors of a number of reduced
    /// models.
    pub fn cost(law: &dyn Law, states: usize, models: usize) -> u64 {
        let share = match (Jacobian::of(law).code_size(), law.code_size()) {
            (Some(own), Some(code)) if code > 0 => own as f64 / code as f64,
            _ => Ode::<f64>::dimension(law) as f64,
        };
        // for each step: its Jacobian, the rates at its midpoint and end; four evaluations for each model
        ((share + 2.0 + 4.0 * models as f64) * (FINER * states) as f64) as u64
    }

    /// The error e along the run; `None` where the defect is undefined, or differs too much at the reduced motion y -
    /// e, so that the first order is meaningless.
    pub fn errors(&self, lower: &Lifted<'_>, law: &dyn Law) -> Option<Vec<Distance<'_>>> {
        let (time, state) = &self.start;
        let mut error = DVector::from_vec(lower.above(*time, state, lower.start));
        let sizes: Vec<f64> = (0..state.len()).map(|i| self.size(i)).collect();
        let norm = |v: &DVector<f64>| v.iter().zip(&sizes).map(|(v, size)| v.abs() / size).sum::<f64>();
        let (mut whole_defect, mut change) = (0.0, 0.0);
        let mut found = vec![Distance { time: *time, state, error: error.as_slice().to_vec() }];
        for Step { middle: (h, time, state), end, whole, integral } in &self.steps {
            let at = |state: &[f64]| DVector::from_vec(lower.defect(law, (*time, BESIDE * h), state));
            let smaller: Vec<f64> = state.iter().zip(error.iter()).map(|(y, e)| y - e).collect();
            let (defect, other) = (at(state), at(&smaller));
            whole_defect += norm(&(integral * &defect));
            change += norm(&(integral * (other - &defect)));
            error = whole * error - integral * defect;
            if !error.iter().all(|value| value.is_finite()) {
                return None;
            }
            found.push(Distance { time: end.0, state: &end.1, error: error.as_slice().to_vec() });
        }
        (change <= BELIEVED * whole_defect).then_some(found)
    }

    /// The largest absolute value of a state along the run; one where it vanishes.
    fn size(&self, state: usize) -> f64 {
        let all = self.steps.iter().map(|step| step.end.1[state].abs());
        let size = all.fold(self.start.1[state].abs(), f64::max);
        if size > 0.0 { size } else { 1.0 }
    }
}

/// Whether the derivative of the cubic through both ends agrees with the law at a fraction of the interval.
fn follows(law: &dyn Law, [begin, end]: [&Knot; 2], share: f64, (time, state): (f64, &[f64]), sizes: &[f64]) -> bool {
    let mut rates = vec![0.0; state.len()];
    law.rates(time, state, &mut rates);
    let span = end.0 - begin.0;
    let [after, before] = [share + SLOPE, share - SLOPE].map(|share| cubic(begin, end, share));
    let slope = |i: usize| (after[i] - before[i]) / (2.0 * SLOPE * span);
    (0..state.len()).all(|i| (slope(i) - rates[i]).abs() <= MISSED * sizes[i])
}
