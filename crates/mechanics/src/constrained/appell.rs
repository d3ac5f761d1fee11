//! Appell's equations in quasi-velocities: dS'/dp'_j = Q'_j, with the acceleration energy S' = 1/2 sum m_i x_i''^2.

use super::PointSystem;
use super::motion::Motion;
use crate::appell::appell;
use crate::definite::{NotDefinite, root};
use crate::differentiate::fixed;
use field::{Over, Scalar};

/// The residuals dS'/dp'_j - Q'_j at the rates p'.
pub fn residual<Q: PointSystem<N>, S: Over<Q::Given>, const N: usize, const R: usize>(
    system: &Q,
    motion: &Motion<S, N, R>,
    force: [S; N],
    rates: [S; R],
) -> [S; R] {
    let lifted = motion.fixed();
    let by_energy = appell(|dp| acceleration_energy(system.masses(), lifted.acceleration(dp)), rates);
    let generalised = motion.generalised(force);
    std::array::from_fn(|j| by_energy[j] - generalised[j])
}

/// The rates p' by Appell's equations.
///
/// # Errors
/// [`NotDefinite`] with the index of the first field that depends linearly on those before it.
pub fn rates<Q: PointSystem<N>, S: Over<Q::Given>, const N: usize, const R: usize>(
    system: &Q,
    motion: &Motion<S, N, R>,
    force: [S; N],
) -> Result<[S; R], NotDefinite> {
    root(|dp| residual(system, &motion.fixed(), fixed(force), dp))
}

/// The acceleration energy S = 1/2 sum m_i x_i''^2.
fn acceleration_energy<S: Scalar, const N: usize>(masses: [S; N], acceleration: [S; N]) -> S {
    super::kinetic_energy(masses, acceleration)
}
