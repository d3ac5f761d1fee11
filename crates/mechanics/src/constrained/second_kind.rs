//! Lagrange's equations of the second kind; with kinematic constraints, Maggi's equations.
//!
//! The kinetic energy T(q, q', t) includes the geometric constraints only. The virtual displacements admitted by the
//! kinematic constraints are dq = sum (dq'/dp_j) dpi_j, hence
//!
//!   sum over i of (d/dt dT/dq'_i - dT/dq_i - Q_i) dq'_i/dp_j = 0 .
//!
//! With p = q' these are Lagrange's equations. Substituting a kinematic constraint into T first gives other equations:
//! see [`quasi`](super::quasi).

use super::{Charted, State, kinetic_energy};
use crate::definite::{NotDefinite, root};
use crate::differentiate::{along, fixed, unit};
use crate::lagrange::rheonomic;
use field::{Analytic, Over, Tangent};

/// The left-hand side above at (t, q, p), under a force, for the rates p'.
pub fn residual<Q, S, const N: usize, const K: usize, const R: usize>(
    system: &Q,
    (time, q, p): (S, [S; K], [S; R]),
    force: [S; N],
    rates: [S; R],
) -> [S; R]
where
    Q: Charted<N, K, R>,
    S: Over<Q::Given> + Analytic,
{
    let speeds = system.rates(time, q, p);
    let accelerations = system.rates(Tangent::variable(time), along(q, speeds), along(p, rates)).map(|v| v.slope);
    let inertia = rheonomic(
        |t, q, dq| {
            let place = system.place(Tangent::variable(t), along(q, dq));
            kinetic_energy(system.masses(), place.map(|x| x.slope))
        },
        time,
        q,
        speeds,
        accelerations,
    );
    let missing: [S; K] = std::array::from_fn(|i| {
        let moved = system.place(Tangent::fixed(time), along(q, unit(i)));
        (0..N).fold(inertia[i], |sum, k| sum - force[k] * moved[k].slope)
    });
    std::array::from_fn(|j| {
        let displaced = system.rates(Tangent::fixed(time), fixed(q), along(p, unit(j)));
        (0..K).fold(S::zero(), |sum, i| sum + missing[i] * displaced[i].slope)
    })
}

/// The rates p' by these equations, under the given force.
///
/// # Errors
/// [`NotDefinite`] with the index of the first p whose displacement depends on those before it.
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

/// The applied forces of a system with a chart at (t, q, p).
pub fn given_force<Q, S, const N: usize, const K: usize, const R: usize>(
    system: &Q,
    (time, q, p): (S, [S; K], [S; R]),
) -> [S; N]
where
    Q: Charted<N, K, R>,
    S: Over<Q::Given> + Analytic,
{
    let velocity = super::motion::velocity(system, time, q, p);
    system.force(&State { time, place: system.place(time, q), velocity })
}
