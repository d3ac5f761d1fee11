//! The start of bodies that are joined where they were apart: no momentum is lost.
//!
//! Reactions r alone move coordinates and speeds,
//!
//!   M dq = J^T r ,  g(q + dq) = 0 ;   M dv = J^T r ,  J (v + dv) + g_t = 0 ,
//!
//! as in an impact without rebound: of two masses the centre stays where it is, and keeps its velocity.

use super::RANK;
use super::constraints::Constraints;
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Steps of Newton's method.
const MOST_STEPS: usize = 20;
/// Residuals below this are met.
const MET: f64 = 1e-13;

/// A state moved so that the constraints of a model hold, by the matrix M there; none of free frames, and where M does not determine it.
pub(crate) fn joined(model: &Model, mut state: Vec<f64>, mass: DMatrix<f64>) -> Option<Vec<f64>> {
    if !model.free.is_empty() || !model.start_speeds.is_empty() {
        return None;
    }
    let constraints = Constraints::of(model).ok()??;
    let parameters: Vec<f64> = model.parameters.iter().filter_map(|parameter| parameter.value).collect();
    let n = model.positions();
    let mass = mass.cholesky()?;
    let moved = |(residual, jacobian): (DVector<f64>, DMatrix<f64>)| {
        let by_reactions = mass.solve(&jacobian.transpose());
        let slopes = &jacobian * &by_reactions;
        // of what is no number the decomposition has no end
        if !slopes.iter().chain(residual.iter()).all(|entry| entry.is_finite()) {
            return None;
        }
        let slopes = slopes.svd(true, true);
        let rank = RANK * slopes.singular_values.max();
        Some(by_reactions * slopes.solve(&-residual, rank).ok()?)
    };
    for _ in 0..MOST_STEPS {
        let at = constraints.at(&state, &parameters, Some(Level::Position));
        if at.0.is_empty() || at.0.amax() <= MET {
            break;
        }
        let by = moved(at)?;
        state[..n].iter_mut().zip(by.iter()).for_each(|(own, by)| *own += by);
    }
    let by = moved(constraints.at(&state, &parameters, None))?;
    state[n..].iter_mut().zip(by.iter()).for_each(|(own, by)| *own += by);
    state.iter().all(|value| value.is_finite()).then_some(state)
}
