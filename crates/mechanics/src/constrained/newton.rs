//! Newton's equations with reactions along given directions: m_i x''_i = X_i + sum over the reactions of r_k D_ki.
//!
//! The system gives the directions of its reactions explicitly, not as gradients of constraints: a rod pulls along
//! itself, a guide pushes perpendicularly, a blade across its edge. Reactions are forces in newtons; it is then a
//! result, not an assumption, that they do no work.

use super::rates::rates;
use super::{Constrained, PointSystem, State};
use crate::definite::{NotDefinite, solve};
use crate::differentiate::{along, unit};
use field::{Over, Scalar, Tangent};

/// A system with C reactions.
pub trait Reactions<const N: usize, const C: usize>: PointSystem<N> {
    /// Each reaction of unit magnitude, as a force in the coordinates x.
    fn reactions<S: Over<Self::Given>>(&self, at: &State<S, N>) -> [[S; N]; C];
}

/// The force in the coordinates x that is equivalent to a force at a point r(x): sum over d of F_d dr_d/dx.
pub fn at_point<S: Scalar, const N: usize, const D: usize>(
    point: impl Fn([Tangent<S>; N]) -> [Tangent<S>; D],
    place: [S; N],
    force: [S; D],
) -> [S; N] {
    std::array::from_fn(|i| {
        let moved = point(along(place, unit(i)));
        (0..D).fold(S::zero(), |sum, d| sum + force[d] * moved[d].slope)
    })
}

/// Accelerations and reactions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pushed<S, const N: usize, const C: usize> {
    /// The accelerations x''.
    pub acceleration: [S; N],
    /// The reactions r, N.
    pub reactions: [S; C],
}

/// The reactions that satisfy the constraints under a force, and the accelerations.
///
/// # Errors
/// [`NotDefinite`] with the index of the first constraint that its reaction cannot enforce.
pub fn newton<Q, S, const N: usize, const C: usize>(
    system: &Q,
    at: &State<S, N>,
    force: [S; N],
) -> Result<Pushed<S, N, C>, NotDefinite>
where
    Q: Constrained<N, C> + Reactions<N, C>,
    S: Over<Q::Given>,
{
    let masses: [S; N] = system.masses();
    let directions = system.reactions(at);
    let accelerated = |reactions: [S; C]| -> [S; N] {
        std::array::from_fn(|i| {
            (0..C).fold(force[i] / masses[i], |sum, k| sum + reactions[k] * directions[k][i] / masses[i])
        })
    };
    let none = [S::zero(); C];
    let rows = super::rates::jacobian(system, at);
    let matrix =
        rows.map(|row| directions.map(|push| (0..N).fold(S::zero(), |sum, i| sum + row[i] * push[i] / masses[i])));
    let reactions = solve(matrix, rates(system, at, accelerated(none)).map(|rate| -rate))?;
    Ok(Pushed { acceleration: accelerated(reactions), reactions })
}
