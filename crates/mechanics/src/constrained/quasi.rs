//! Lagrange's operator applied to an energy with substituted constraints, and the correction terms.
//!
//! With T(q, p, t) = 1/2 sum m_i x'_i(q, p, t)^2 and the fields X_j = dq'/dp_j the following identity holds:
//!
//!   d/dt dT/dp_j - X_j(T) = sum m_i x''_i dx'_i/dp_j + lost_j ,
//!   lost_j = sum m_i x'_i (d/dt dx'_i/dp_j - X_j(x'_i)) .
//!
//! The first sum equals the generalised force. The term `lost_j` vanishes where the brackets of the fields and the
//! motion are zero (p are rates of coordinates), or where the momenta in it vanish: substituting a kinematic constraint
//! into the energy changes the equations unless the constraint is integrable. In redundant coordinates, with q = x,
//! these are Shulgin's equations ([`redundant`](super::redundant)); linear quasi-velocities give the equations of
//! Boltzmann and Hamel.

use super::motion::{Motion, velocity};
use super::{Charted, kinetic_energy};
use crate::definite::{NotDefinite, root};
use crate::differentiate::{along, fixed, unit};
use field::{Analytic, Over, Tangent};

/// The terms of the identity, except the first sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operator<S, const R: usize> {
    /// The operator d/dt dT/dp_j - X_j(T).
    pub energy: [S; R],
    /// The correction terms lost_j.
    pub lost: [S; R],
}

/// The terms at (t, q, p) for the rates p'.
pub fn operator<Q, S, const N: usize, const K: usize, const R: usize>(
    system: &Q,
    (time, q, p): (S, [S; K], [S; R]),
    rates: [S; R],
) -> Operator<S, R>
where
    Q: Charted<N, K, R>,
    S: Over<Q::Given> + Analytic,
{
    let masses: [S; N] = system.masses();
    let momenta: [S; N] = {
        let speeds = velocity(system, time, q, p);
        std::array::from_fn(|i| masses[i] * speeds[i])
    };
    let speeds = system.rates(time, q, p);
    let mut operator = Operator { energy: [S::zero(); R], lost: [S::zero(); R] };
    for j in 0..R {
        // inner derivative along the motion, outer one with respect to p_j: the mixed derivative is d/dt d/dp_j
        let varied = velocity(
            system,
            Tangent::fixed(Tangent::variable(time)),
            fixed(along(q, speeds)),
            std::array::from_fn(|k| {
                Tangent::moving(Tangent::moving(p[k], rates[k]), Tangent::fixed(unit::<S, R>(j)[k]))
            }),
        );
        let displaced = system.rates(Tangent::fixed(time), fixed(q), along(p, unit(j))).map(|speed| speed.slope);
        let along_field = velocity(system, Tangent::fixed(time), along(q, displaced), fixed(p));
        operator.energy[j] =
            kinetic_energy(system.masses(), varied).slope.slope - kinetic_energy(system.masses(), along_field).slope;
        operator.lost[j] =
            (0..N).fold(S::zero(), |sum, i| sum + momenta[i] * (varied[i].slope.slope - along_field[i].slope));
    }
    operator
}

/// The residual d/dt dT/dp_j - X_j(T) - lost_j - Q_j for the rates p'.
pub fn residual<Q, S, const N: usize, const K: usize, const R: usize>(
    system: &Q,
    at: (S, [S; K], [S; R]),
    force: [S; N],
    rates: [S; R],
) -> [S; R]
where
    Q: Charted<N, K, R>,
    S: Over<Q::Given> + Analytic,
{
    let (time, q, p) = at;
    let Operator { energy, lost } = operator(system, at, rates);
    let generalised = Motion::at(system, time, q, p).generalised(force);
    std::array::from_fn(|j| energy[j] - lost[j] - generalised[j])
}

/// The rates p' for which the residual vanishes.
///
/// # Errors
/// [`NotDefinite`] with the index of the first p whose field depends on those before it.
pub fn rates<Q, S, const N: usize, const K: usize, const R: usize>(
    system: &Q,
    (time, q, p): (S, [S; K], [S; R]),
    force: [S; N],
) -> Result<[S; R], NotDefinite>
where
    Q: Charted<N, K, R>,
    S: Over<Q::Given> + Analytic,
{
    root(|dp| residual(system, (Tangent::fixed(time), fixed(q), fixed(p)), fixed(force), dp))
}
