//! The state after bodies are rigidly joined, with conservation of momentum.
//!
//! Only reactions r change coordinates and speeds,
//!
//!   M dq = J^T r ,  g(q + dq) = 0 ;   M dv = J^T r ,  J (v + dv) + g_t = 0 ,
//!
//! as in a perfectly inelastic impact: the centre of mass of two joined masses keeps its position and its velocity.

use super::RANK;
use super::constraints::Constraints;
use model::Model;
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Largest number of Newton's iterations.
const MOST_STEPS: usize = 20;
/// Residuals below this size count as zero.
const MET: f64 = 1e-13;

/// A sum below this multiple of its terms is a rounding error.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The state after the constraints of a model are imposed, with the mass matrix M at the state; `None` with free frames, with given
/// quasi-velocities, or if M is singular.
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
        // the singular value decomposition does not terminate for NaN
        if !slopes.iter().chain(residual.iter()).all(|entry| entry.is_finite()) {
            return None;
        }
        let slopes = slopes.svd(true, true);
        let rank = RANK * slopes.singular_values.max();
        let reactions = slopes.solve(&-residual, rank).ok()?;
        let sizes = by_reactions.abs() * reactions.abs();
        let by = by_reactions * reactions;
        Some(by.iter().copied().zip(sizes.iter().copied()).collect::<Vec<_>>())
    };
    for _ in 0..MOST_STEPS {
        let at = constraints.at(&state, &parameters, Some(Level::Position));
        if at.0.is_empty() || at.0.amax() <= MET {
            break;
        }
        let by = moved(at)?;
        state[..n].iter_mut().zip(by).for_each(|(own, by)| *own = sum(*own, by));
    }
    let by = moved(constraints.at(&state, &parameters, None))?;
    state[n..].iter_mut().zip(by).for_each(|(own, by)| *own = sum(*own, by));
    state.iter().all(|value| value.is_finite()).then_some(state)
}

/// The sum of a number and a change with terms of the given size. A rounding error becomes zero, so that a body that comes to rest has exactly
/// no energy.
fn sum(own: f64, (by, size): (f64, f64)) -> f64 {
    let sum = own + by;
    if sum.abs() <= ROUNDING * (own.abs() + size) { 0.0 } else { sum }
}

#[cfg(test)]
mod tests {
    use super::sum;

    #[test]
    fn what_cancels_but_for_rounding_is_zero() {
        assert_eq!([sum(1.0, (-1.0 + 1e-15, 1.0)), sum(0.0, (3e-16, 2.0))], [0.0, 0.0]);
        assert_eq!([sum(1.0, (1e-12, 1e-12)), sum(0.0, (3e-16, 3e-16))], [1.0 + 1e-12, 3e-16]);
    }
}
