//! Coordinates without inertia follow at once after an event that sets the others.

use super::constraints::Constraints;
use super::start_speeds;
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Steps of Newton's method: laws of speeds are linear in most systems.
const STEPS: usize = 20;

/// Residuals below this are what rounding leaves.
const ROUNDED: f64 = 1e-14;

/// Singular values below this part of the largest one are taken for zero.
const RANK: f64 = 1e-10;

/// Moves coordinates without inertia, and their speeds, until constraints hold; the state stays where the model has none.
pub(crate) fn follow(model: &Model, time: f64, state: &mut [f64]) {
    let Some((_, own)) = model.with_inertia_alone() else { return };
    let Ok(Some(constraints)) = Constraints::of(model) else { return };
    let parameters: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
    let parameters = [parameters, start_speeds(model)].concat();
    for (order, level) in [(0, Some(Level::Position)), (1, None)] {
        for _ in 0..STEPS {
            let (residuals, rows) = at(&constraints, time, state, &parameters, level);
            let columns = DMatrix::from_fn(residuals.len(), own.len(), |row, at| rows[(row, own[at])]);
            let finite = residuals.iter().chain(columns.iter()).all(|number| number.is_finite());
            if !finite || residuals.is_empty() || residuals.amax() <= ROUNDED {
                break;
            }
            let decomposed = columns.svd(true, true);
            let largest = decomposed.singular_values.amax();
            let Ok(step) = decomposed.solve(&residuals, RANK * largest) else { break };
            if step.iter().any(|part| !part.is_finite()) || step.amax() == 0.0 {
                break;
            }
            for (&at, part) in own.iter().zip(step.iter()) {
                constraints.layout.displace(state, (at, order), -part);
            }
        }
    }
}

/// Residuals of the constraints of positions, or of the rates of all, and their derivatives by the speeds.
fn at(
    constraints: &Constraints,
    time: f64,
    state: &[f64],
    parameters: &[f64],
    level: Option<Level>,
) -> (DVector<f64>, DMatrix<f64>) {
    let values = constraints.values(time, state, parameters);
    let kept = &constraints.known[..constraints.kept];
    let count = level.map_or(kept.len(), |level| kept.iter().filter(|known| known.level == level).count());
    let first = if level.is_some() { 0 } else { constraints.known.len() };
    (DVector::from_fn(count, |row, _| values[first + row]), constraints.rows(&values, count))
}
