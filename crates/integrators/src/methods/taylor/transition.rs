//! The state-transition matrix dy(t1)/dy(t0) of a motion.
//!
//! Taylor's method over numbers with derivatives in eight directions, in the lanes of a register. The variational
//! equations need not be formed, and the matrix is as accurate as the motion.

use crate::clock;
use crate::methods::taylor::taylor_order;
use crate::{DIRECTIONS, Failure, Refusal, System, TaylorSeries, Tolerance, Variations};

/// The state at the end of a motion, and its derivatives with respect to the initial state.
#[derive(Clone, Debug, PartialEq)]
pub struct Transition {
    pub state: Vec<f64>,
    /// `matrix[i * n + j]` = dy_i(t1) / dy_j(t0).
    pub matrix: Vec<f64>,
    /// The largest number of steps among the blocks of eight columns.
    pub steps: u64,
}

/// Integrates a state and its derivatives with respect to the initial state from the time `from` to `to` (s). The tolerance
/// applies to the state, and to each column of derivatives relative to its largest entry.
///
/// # Errors
/// [`Failure`] where the system provides no Taylor series, the integration fails, or the clock of the process ends it.
pub fn transition(
    system: &dyn System,
    tolerance: &Tolerance,
    (from, to): (f64, f64),
    state: &[f64],
) -> Result<Transition, Failure> {
    if !(from.is_finite() && to.is_finite()) {
        return Err(Failure::Refused(Refusal::SpanNotFinite { start: from, end: to }));
    }
    let n = state.len();
    let mut series = system.taylor_variations().ok_or(Failure::Refused(Refusal::NoSeries))?;
    let mut found = Transition { state: state.to_vec(), matrix: vec![0.0; n * n], steps: 0 };
    for first in (0..n).step_by(DIRECTIONS) {
        let block = DIRECTIONS.min(n - first);
        let mut y: Vec<Variations> = state.iter().map(|&y| Variations::from(y)).collect();
        for k in 0..block {
            y[first + k].slope.0[k] = 1.0;
        }
        let steps = carry(&mut *series, tolerance, (from, to), &mut y)?;
        found.steps = found.steps.max(steps);
        for (i, end) in y.iter().enumerate() {
            found.state[i] = end.value.0[0];
            for k in 0..block {
                found.matrix[i * n + first + k] = end.slope.0[k];
            }
        }
    }
    Ok(found)
}

/// Integrates y, and returns the number of steps.
fn carry(
    series: &mut dyn TaylorSeries<Variations>,
    tolerance: &Tolerance,
    (from, to): (f64, f64),
    y: &mut [Variations],
) -> Result<u64, Failure> {
    let mut steps = 0;
    let (order, direction, mut at) = (taylor_order(tolerance.relative), (to - from).signum(), from);
    while at != to {
        if let Some(over) = clock::over() {
            return Err(over.failure(at));
        }
        series.expand(Variations::from(at), y, order);
        let terms = [order, order - 1].map(|k| {
            let share = largest_share(series.coefficients(k), y, tolerance);
            share.powf(-1.0 / k as f64)
        });
        let reach = terms[0].min(terms[1]);
        if terms.iter().any(|term| term.is_nan()) {
            return Err(Failure::LeftTheNumbers { at });
        }
        let next = if reach >= (to - at).abs() { to } else { at + direction * reach };
        if next == at {
            return Err(Failure::StepCollapsed { at, step: reach });
        }
        series.sum(Variations::from(next - at), y);
        (at, steps) = (next, steps + 1);
    }
    Ok(steps)
}

/// The largest coefficient in units of the allowed error; NaN where one is NaN.
fn largest_share(coefficients: &[Variations], y: &[Variations], tolerance: &Tolerance) -> f64 {
    let columns: [f64; DIRECTIONS] =
        std::array::from_fn(|k| y.iter().map(|y| y.slope.0[k].abs()).fold(f64::MIN_POSITIVE, f64::max));
    let mut largest = 0.0_f64;
    for (i, (a, y)) in coefficients.iter().zip(y).enumerate() {
        let own = a.value.0[0].abs() / tolerance.allowed(i, y.value.0[0].abs());
        let slopes = columns.iter().enumerate().map(|(k, column)| a.slope.0[k].abs() / (tolerance.relative * column));
        for share in slopes.chain([own]) {
            if !share.is_finite() {
                return f64::NAN;
            }
            largest = largest.max(share);
        }
    }
    largest
}
