//! The steady motion to which Newton's method converges from a state; along a parameter, the motion changes with it.

use super::nearby::cases_at;
use super::{EnclosedSpectrum, NotEnclosed};
use crate::linearisation::VariedEquations;
use crate::steady_motions::equations::SteadyEquations;
use crate::steady_motions::quasi_velocities::Extended;
use model::Model;
use nalgebra::{DMatrix, DVector};

/// Largest number of Newton's iterations.
const STEPS: usize = 60;

/// Longest step, in SI units and relative to the value.
const LONGEST: f64 = 0.5;

/// The iteration has converged if a step is shorter, in SI units and relative to the value.
const SHORT: f64 = 1e-14;

impl EnclosedSpectrum {
    /// The eigenvalues at the steady motion at a state, or at that to which Newton's method converges with the same cyclic speeds. The motion is proved
    /// to be the only one in a neighbourhood.
    ///
    /// # Errors
    /// As for [`EnclosedSpectrum::near`].
    pub fn following(model: &Model, state: &[f64], mut goes_on: impl FnMut() -> bool) -> Result<Self, NotEnclosed> {
        match Self::near(model, state, &mut goes_on) {
            Err(NotEnclosed::NoMotion) => {
                let (model, state) = &Extended::about(model, state);
                let moved = steady_from(model, state).ok_or(NotEnclosed::NoMotion)?;
                Self::near(model, &moved, goes_on)
            }
            found => found,
        }
    }
}

/// The state of the steady motion, up to rounding; `None` if the iteration does not converge.
fn steady_from(model: &Model, state: &[f64]) -> Option<Vec<f64>> {
    let varied = VariedEquations::with_inputs(model, &[], &[]).ok()?;
    let equations = SteadyEquations::near(model, state, &cases_at(&varied, state)).ok()?;
    let (own, size) = (equations.unknowns.len(), equations.unknowns.len() + equations.reactions);
    let (mut values, mut slopes) = (equations.tapes.values.over::<f64>(), equations.tapes.slopes.over::<f64>());
    if equations.rows != size || equations.tapes.surplus.outputs() > 0 {
        return None;
    }
    // reactions start from zero: the equations are linear in them
    let mut at: Vec<f64> = equations.unknowns.iter().map(|unknown| state[unknown.place]).collect();
    at.resize(size, 0.0);
    let (mut value, mut slope) = (vec![0.0; size], vec![0.0; size * size]);
    for _ in 0..STEPS {
        values.evaluate(&at, &mut value);
        slopes.evaluate(&at, &mut slope);
        let matrix = DMatrix::from_row_slice(size, size, &slope);
        let step = matrix.lu().solve(&DVector::from_column_slice(&value))?;
        let part = |place: usize| step[place].abs() / (1.0 + at[place].abs());
        let most = (0..own).map(part).fold(0.0, f64::max);
        if !most.is_finite() {
            return None;
        }
        let factor = if most > LONGEST { LONGEST / most } else { 1.0 };
        at.iter_mut().zip(step.iter()).for_each(|(own, step)| *own -= factor * step);
        if most <= SHORT {
            return Some(equations.state_at(at.into_iter().take(own)));
        }
    }
    None
}
