//! Painleve's combination of constraints: decomposition of a reaction R into a constraint force and a friction force.
//!
//! R = R^n + R^tau, where R^n = J^T lambda does no work on virtual displacements (J dx = 0). The second part satisfies
//!
//! * Painleve: R^tau is a virtual displacement, J R^tau = 0;
//! * extended: M^-1 R^tau is a virtual displacement, J M^-1 R^tau = 0.
//!
//! Both are orthogonal projections, in the metrics 1 and M^-1. Both exist and are unique; lambda is unique where J has
//! full rank. In the extended decomposition lambda is that without friction, since R^tau does not accelerate the
//! constraints.

use crate::definite::{NotDefinite, solve};
use field::Scalar;

/// The two parts of a reaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Combined<S, const N: usize, const C: usize> {
    /// The multipliers lambda.
    pub multipliers: [S; C],
    /// The constraint force R^n = J^T lambda.
    pub of_constraints: [S; N],
    /// The friction force R^tau.
    pub of_friction: [S; N],
}

/// The extended decomposition for the masses m.
///
/// # Errors
/// [`NotDefinite`] with the index of the first row of J that depends linearly on those before it.
pub fn extended<S: Scalar, const N: usize, const C: usize>(
    masses: [S; N],
    rows: [[S; N]; C],
    reaction: [S; N],
) -> Result<Combined<S, N, C>, NotDefinite> {
    let weighted = |a: [S; N], b: [S; N]| (0..N).fold(S::zero(), |sum, i| sum + a[i] * b[i] / masses[i]);
    let matrix = rows.map(|a| rows.map(|b| weighted(a, b)));
    let multipliers = solve(matrix, rows.map(|row| weighted(row, reaction)))?;
    let of_constraints = std::array::from_fn(|i| (0..C).fold(S::zero(), |sum, k| sum + multipliers[k] * rows[k][i]));
    let of_friction = std::array::from_fn(|i| reaction[i] - of_constraints[i]);
    Ok(Combined { multipliers, of_constraints, of_friction })
}

/// Painleve's decomposition: the extended one for equal masses.
///
/// # Errors
/// [`NotDefinite`] with the index of the first row of J that depends linearly on those before it.
pub fn painleve<S: Scalar, const N: usize, const C: usize>(
    rows: [[S; N]; C],
    reaction: [S; N],
) -> Result<Combined<S, N, C>, NotDefinite> {
    extended([S::one(); N], rows, reaction)
}
