//! Dormand and Prince's explicit Runge-Kutta pairs 5(4) and 8(5,3), with Hairer, Norsett and Wanner's step size control.
//!
//! With k_1 = f(t, y) and k_i = f(t + c_i h, y + h sum_j a_ij k_j), a step of length h ends in y_1 = y + h sum_i b_i k_i. Its error is
//! estimated by h sum_i e_i k_i; the pair 8(5,3) has a second estimate, h sum_i d_i k_i, of lower order. A step is accepted where the
//! root mean square of its error, in units of the tolerance, is at most 1.
//!
//! Method, coefficients and control: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I (1993),
//! II.4, II.5 and II.10, codes DOPRI5 and DOP853; the pair 8(5,3) with the predictive control of Gustafsson (1994). The
//! coefficients are known to 30 digits at most, therefore the pairs run in `f64` only. Other crates are not used:
//! `ode_solvers` 0.6 has c_12 = 0 instead of 1 in 8(5,3) and needs another version of nalgebra;
//! `differential-equations` 0.7 evaluates 15 slopes per step instead of 12, or 7 instead of 6, for an unused dense
//! output, and takes states of static size only.

mod pairs;
mod stiffness;

use crate::run::budgeted_rhs::BudgetedRhs;
use crate::run::stepping::{Attempt, Cause, Stepper};
use crate::{System, Tolerance};
pub(crate) use pairs::{EIGHT, FIVE, Pair};
use stiffness::Stiffness;

/// Four components are combined at once, in vector registers, for any dimension.
type Four = [f64; 4];

/// The smallest error that enters the step size control, and the initial value of the previous error.
const LEAST_ERROR: f64 = 1e-4;
/// Safety factor of the step size.
const SAFETY: f64 = 0.9;
/// The reduction factor of the step size after an undefined step.
const RETREAT: f64 = 0.25;

/// The state of a pair; slopes and stages are padded to multiples of four components.
pub(crate) struct DormandPrince<'a> {
    pair: &'static Pair,
    relative: f64,
    absolute: Vec<Four>,
    before: Vec<Four>,
    /// The argument of the last evaluated stage.
    stage: Vec<Four>,
    after: Vec<Four>,
    slopes: Slopes,
    /// The time at which k_1 was evaluated.
    slope_at: Option<f64>,
    last_error: f64,
    /// The size of the last accepted step.
    last_step: Option<f64>,
    after_rejection: bool,
    stiffness: Stiffness<'a>,
}

/// The slopes k_1 to k_s, then f(t + h, y_1).
struct Slopes {
    all: Vec<Four>,
    width: usize,
}

impl Slopes {
    fn of(&self, stage: usize) -> &[Four] {
        &self.all[stage * self.width..][..self.width]
    }

    /// The components of the slope of one stage.
    fn of_mut(&mut self, stage: usize, dimension: usize) -> &mut [f64] {
        &mut self.all[stage * self.width..][..self.width].as_flattened_mut()[..dimension]
    }

    /// Copies the last slope to the first.
    fn begin_at(&mut self, last: usize) {
        self.all.copy_within(last * self.width.., 0);
    }

    /// The sum of a_j k_j over the stages j of a row, for the four components with the index `place`.
    fn weighted(&self, row: &[(usize, f64)], place: usize) -> Four {
        let mut sum = [0.0; 4];
        for &(stage, share) in row {
            let slope = &self.all[stage * self.width + place];
            sum = std::array::from_fn(|i| sum[i] + share * slope[i]);
        }
        sum
    }

    /// to = from + h sum_j a_j k_j.
    fn advance(&self, row: &[(usize, f64)], from: &[Four], step: f64, to: &mut [Four]) {
        for (place, (to, from)) in to.iter_mut().zip(from).enumerate() {
            let slope = self.weighted(row, place);
            *to = std::array::from_fn(|i| from[i] + step * slope[i]);
        }
    }
}

impl<'a> DormandPrince<'a> {
    pub fn new(system: &'a dyn System, pair: &'static Pair, tolerance: &Tolerance, dimension: usize) -> Self {
        let width = dimension.div_ceil(4);
        let zeros = || vec![[0.0; 4]; width];
        let mut absolute = vec![[1.0; 4]; width];
        let given = (0..dimension).map(|i| tolerance.absolute(i));
        absolute.as_flattened_mut().iter_mut().zip(given).for_each(|(absolute, given)| *absolute = given);
        DormandPrince {
            pair,
            relative: tolerance.relative,
            absolute,
            before: zeros(),
            stage: zeros(),
            after: zeros(),
            slopes: Slopes { all: vec![[0.0; 4]; (pair.stages.len() + 2) * width], width },
            slope_at: None,
            last_error: LEAST_ERROR,
            last_step: None,
            after_rejection: false,
            stiffness: Stiffness::of(system),
        }
    }

    /// Sum over all components of (sum_j e_j k_j / tolerance)^2.
    fn squares(&self, row: &[(usize, f64)]) -> f64 {
        if row.is_empty() {
            return 0.0;
        }
        let mut sum = [0.0; 4];
        for (place, ((absolute, a), b)) in self.absolute.iter().zip(&self.before).zip(&self.after).enumerate() {
            let error = self.slopes.weighted(row, place);
            for i in 0..4 {
                let share = error[i] / (absolute[i] + self.relative * a[i].abs().max(b[i].abs()));
                sum[i] += share * share;
            }
        }
        sum.iter().sum()
    }

    /// The error of a step in units of the tolerance: h E / sqrt(n (E + F/100)), with the sums E and F of the two
    /// estimates (Hairer, Norsett and Wanner, II.10). Without a second estimate, the root mean square.
    fn error(&self, step: f64, dimension: usize) -> f64 {
        let fine = self.squares(self.pair.error);
        let both = fine + 0.01 * self.squares(self.pair.second_error);
        let both = if both > 0.0 { both } else { 1.0 };
        step * fine / (both * dimension as f64).sqrt()
    }

    /// The divisor of the step size if the error keeps growing at the rate of the last two steps: fewer steps are
    /// rejected where the motion changes. The work for equal errors decreases by 17 to 20 % for Andrews' mechanism and
    /// the Pleiades; for the scenes of `snapshots/atlas` it is unchanged on average.
    fn predicted(&self, stretch: f64, step: f64, error: f64) -> f64 {
        let growth = (error.max(LEAST_ERROR) / self.last_error).powf(self.pair.exponent);
        self.last_step.map_or(0.0, |last| stretch * last / step * growth)
    }

    /// An estimate of the Lipschitz number, h |f(y_1) - f(z)| / |y_1 - z|, where the argument z of the last stage
    /// belongs to the time of y_1. Differences are measured in units of the absolute tolerance.
    fn stretching(&self, step: f64) -> f64 {
        let last = self.pair.stages.len();
        let apart = |a: &[Four], b: &[Four]| {
            let pairs = a.as_flattened().iter().zip(b.as_flattened()).zip(self.absolute.as_flattened());
            pairs.map(|((a, b), unit)| ((a - b) / unit).powi(2)).sum::<f64>()
        };
        let (slopes, states) = (apart(self.slopes.of(last + 1), self.slopes.of(last)), apart(&self.after, &self.stage));
        if states > 0.0 { step * (slopes / states).sqrt() } else { 0.0 }
    }
}

impl Stepper<f64> for DormandPrince<'_> {
    fn attempt(&mut self, tau: f64, before: &[f64], step: f64, after: &mut [f64], meter: &BudgetedRhs<f64>) -> Attempt {
        let (pair, n) = (self.pair, before.len());
        let end = pair.stages.len() + 1;
        self.before.as_flattened_mut()[..n].copy_from_slice(before);
        if self.slope_at != Some(tau) {
            meter.rates(tau, before, self.slopes.of_mut(0, n));
            self.slope_at = Some(tau);
        }
        for (i, (node, row)) in pair.stages.iter().enumerate() {
            self.slopes.advance(row, &self.before, step, &mut self.stage);
            meter.rates(tau + node * step, &self.stage.as_flattened()[..n], self.slopes.of_mut(i + 1, n));
        }
        self.slopes.advance(pair.weights, &self.before, step, &mut self.after);
        let slope_at_end = |slopes: &mut Slopes, after: &[Four]| {
            meter.rates(tau + step, &after.as_flattened()[..n], slopes.of_mut(end, n));
        };
        if pair.error_needs_end {
            slope_at_end(&mut self.slopes, &self.after);
        }
        let error = self.error(step, n);
        if !error.is_finite() {
            self.after_rejection = true;
            // the squares of finite errors may overflow
            let cause = if meter.was_undefined() { Cause::Undefined } else { Cause::Error };
            return Attempt::Rejected { next: RETREAT * step, cause };
        }
        let stretch = error.powf(pair.exponent) / SAFETY;
        if error > 1.0 {
            self.after_rejection = true;
            return Attempt::Rejected { next: step / stretch.min(1.0 / pair.shortest), cause: Cause::Error };
        }
        let damped = if pair.predicts {
            stretch.max(self.predicted(stretch, step, error))
        } else {
            stretch * self.last_error.powf(-pair.damping)
        };
        let most = if self.after_rejection { 1.0 } else { pair.longest };
        let next = step / damped.clamp(1.0 / most, 1.0 / pair.shortest);
        (self.last_error, self.last_step) = (error.max(LEAST_ERROR), Some(step));
        self.after_rejection = false;
        if !pair.error_needs_end {
            slope_at_end(&mut self.slopes, &self.after);
        }
        let is_stiff = self.stiffness.is_due()
            && self.stiffness.found(self.stretching(step) > pair.stretching)
            && self.stiffness.is_confirmed(
                (pair.stretching, step),
                (meter, tau + step),
                &self.after.as_flattened()[..n],
            );
        self.slopes.begin_at(end);
        self.slope_at = Some(tau + step);
        after.copy_from_slice(&self.after.as_flattened()[..n]);
        if is_stiff { Attempt::Limited { next } } else { Attempt::Accepted { next } }
    }
}
