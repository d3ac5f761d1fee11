//! Hamilton's canonical equations q' = dH/dp and p' = -dH/dq + Q, expressed by the speeds.
//!
//! The kinetic energy T includes the co-energy of magnetic fields, whose momenta are fluxes. The momenta p = dT/du, and H = p . u - T + V,
//! are functions of q and u. The chain rule gives
//!
//!   dH/du_j|q = sum (dH/dp_k) dp_k/du_j ,    dH/dq_i|u = dH/dq_i|p + sum (dH/dp_k) dp_k/dq_i .
//!
//! The first equation with dH/dp = u is q' = dH/dp if the momenta determine the speeds; the second one yields dH/dq|p
//! without solving for the speeds. Both occur in the residual; the first one, which is an identity, as a factor of u'.

use super::NotApplicable;
use super::loads::{by_energies, forces, torques};
use crate::Trace;
use crate::equations::generic_rank;
use symbolic::Sym;

/// Returns the momenta dT/du, one for each speed.
pub(crate) fn momenta(trace: &Trace<'_>) -> Vec<Sym> {
    let kinetic = trace.kinetic_and_coenergy();
    (0..trace.speeds.len()).map(|i| trace.by_speed(kinetic, i)).collect()
}

/// Returns sum p u - T + V, where V is only the potential of the weights.
fn hamiltonian(trace: &Trace<'_>, momenta: &[Sym]) -> Sym {
    let heights = trace.potential_of_weights();
    momenta.iter().zip(&trace.speeds).fold(heights - trace.kinetic_and_coenergy(), |sum, (&p, &u)| sum + p * u)
}

pub(super) fn residual(trace: &Trace<'_>) -> Result<Vec<Sym>, NotApplicable> {
    let n = trace.speeds.len();
    let momenta = momenta(trace);
    let inertia: Vec<Vec<Sym>> = momenta.iter().map(|&p| (0..n).map(|j| trace.by_speed(p, j)).collect()).collect();
    if generic_rank(&inertia) < n {
        return Err(NotApplicable(
            "the momenta dT/du do not determine the speeds: no inertia resists one of them".into(),
        ));
    }
    let energy = hamiltonian(trace, &momenta);
    let (forces, torques) = (forces(trace, trace.uniform_gravity().is_none()), torques(trace));
    let given = |i: usize| -> Sym {
        let by_forces = forces.iter().map(|force| trace.dot(force.is, trace.material_displacement(force.at, i)));
        let by_torques =
            torques.iter().map(|torque| trace.dot(torque.is, trace.vector_by_speed(trace.turning(torque.on), i)));
        by_forces.chain(by_torques).fold(Sym::ZERO, |sum, each| sum + each)
    };
    let of = |i: usize| {
        let along = |derivative: &dyn Fn(Sym) -> Sym| {
            momenta.iter().zip(&trace.speeds).fold(derivative(energy), |sum, (&p, &u)| sum - u * derivative(p))
        };
        let by_place = along(&|scalar| trace.by_coordinate(scalar, i));
        // q' - dH/dp, multiplied by dp/du: an identity
        let kinematic = along(&|scalar| trace.by_speed(scalar, i));
        let rate = trace.rate_of(momenta[i]) + trace.transposition(i, |j| momenta[j]);
        rate + by_place + trace.accelerations[i] * kinematic - given(i) + by_energies(trace, i)
    };
    Ok((0..n).map(of).collect())
}
