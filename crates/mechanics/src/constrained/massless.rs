//! Multipliers for a singular mass matrix: coordinates without mass, whose motion is determined by the constraints.
//!
//! M^-1 does not exist, but M is positive definite on J dx = 0. With J x'' = w the term J^T (J x'' - w) vanishes on
//! every motion. The equations
//!
//!   (M + J^T J) x'' = X + J^T kappa ,   J x'' = w ,   lambda = kappa - w
//!
//! have the solution of M x'' = X + J^T lambda, and a positive definite matrix. The factor of J^T J, which may be any
//! positive number, is one in the units of the coordinates.

use super::multipliers::Reaction;
use super::rates::{jacobian, rates};
use super::{Constrained, State};
use crate::definite::{NotDefinite, solve};
use field::{Over, Scalar};

/// The matrix M + J^T J.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia<S, const N: usize>([[S; N]; N]);

impl<S: Scalar, const N: usize> Inertia<S, N> {
    /// The matrix from masses, which may be zero, and the rows of J.
    pub fn of<const C: usize>(masses: [S; N], rows: &[[S; N]; C]) -> Self {
        Inertia(std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let mass = if i == j { masses[i] } else { S::zero() };
                rows.iter().fold(mass, |sum, row| sum + row[i] * row[j])
            })
        }))
    }

    /// The acceleration (M + J^T J)^-1 X due to a force X without the constraint reactions.
    ///
    /// # Errors
    /// [`NotDefinite`] with the index of the first coordinate with neither mass nor constraint.
    pub fn moved(&self, force: [S; N]) -> Result<[S; N], NotDefinite> {
        solve(self.0, force)
    }
}

/// As [`multipliers::leading_to`](super::multipliers::leading_to), for masses that may be zero.
///
/// # Errors
/// [`NotDefinite`] with the index of the first undetermined coordinate, or of the first constraint that depends on
/// those before it.
pub fn leading_to<Q: Constrained<N, C>, S: Over<Q::Given>, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
    force: [S; N],
    prescribed: [S; C],
) -> Result<Reaction<S, N, C>, NotDefinite> {
    let rows = jacobian(system, at);
    let inertia = Inertia::of(system.masses(), &rows);
    let free = inertia.moved(force)?;
    let mut pushes = rows;
    for push in &mut pushes {
        *push = inertia.moved(*push)?;
    }
    let still = rates(system, at, [S::zero(); N]);
    let wanted: [S; C] = std::array::from_fn(|k| prescribed[k] - still[k]);
    let dot = |a: &[S; N], b: &[S; N]| (0..N).fold(S::zero(), |sum, i| sum + a[i] * b[i]);
    let matrix = std::array::from_fn(|a| std::array::from_fn(|b| dot(&rows[a], &pushes[b])));
    let kappa: [S; C] = solve(matrix, std::array::from_fn(|k| wanted[k] - dot(&rows[k], &free)))?;
    let acceleration = std::array::from_fn(|i| (0..C).fold(free[i], |sum, k| sum + kappa[k] * pushes[k][i]));
    Ok(Reaction { acceleration, multipliers: std::array::from_fn(|k| kappa[k] - wanted[k]) })
}
