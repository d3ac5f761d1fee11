//! Lagrange's equations of the first kind: m_i x_i'' = X_i + sum over the constraints of lambda J_i.

use super::rates::{jacobian, rates};
use super::{Constrained, State};
use crate::definite::{NotDefinite, solve};
use field::Over;

/// Accelerations and Lagrange multipliers under the constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction<S, const N: usize, const C: usize> {
    /// The accelerations x''.
    pub acceleration: [S; N],
    /// The multipliers lambda: the reaction of constraint k is lambda_k (df_k/dx), or lambda_k (dphi_k/dx') if it is
    /// kinematic.
    pub multipliers: [S; C],
}

/// Accelerations and multipliers under a force, from J M^-1 J^T lambda = -(rates at x'' = M^-1 X). The force is
/// [`PointSystem::force`](super::PointSystem::force) plus any other force, such as friction.
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint that depends on those before it.
pub fn multipliers<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
    force: [S; N],
) -> Result<Reaction<S, N, C>, NotDefinite> {
    leading_to(system, at, force, [S::zero(); C])
}

/// Accelerations and multipliers for prescribed [`rates`](mod@super::rates) Y of the constraints: J M^-1 J^T
/// lambda = Y - (rates at x'' = M^-1 X).
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint that depends on those before it.
pub fn leading_to<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
    force: [S; N],
    prescribed: [S; C],
) -> Result<Reaction<S, N, C>, NotDefinite> {
    let masses: [S; N] = system.masses();
    let rows = jacobian(system, at);
    let free: [S; N] = std::array::from_fn(|i| force[i] / masses[i]);
    let matrix: [[S; C]; C] = std::array::from_fn(|a| {
        std::array::from_fn(|b| (0..N).fold(S::zero(), |sum, i| sum + rows[a][i] * rows[b][i] / masses[i]))
    });
    let unforced = rates(system, at, free);
    let multipliers = solve(matrix, std::array::from_fn(|k| prescribed[k] - unforced[k]))?;
    let acceleration =
        std::array::from_fn(|i| (0..C).fold(free[i], |sum, k| sum + multipliers[k] * rows[k][i] / masses[i]));
    Ok(Reaction { acceleration, multipliers })
}
