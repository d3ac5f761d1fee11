//! Lagrange's equations of the second kind, d/dt dT/du - dT/dq + dV/dq = sum F . dr/dq + T . dw/du; T includes the co-energy of magnetic fields. For the angular velocity w of
//! a free frame they are Euler's equations, with the additional term w x dT/dw.

use super::loads::{by_energies, forces, torques};
use crate::Trace;
use symbolic::Sym;

pub(super) fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    // weights are derived from their potential if gravity is uniform
    let uniform = trace.uniform_gravity();
    let (forces, torques) = (forces(trace, uniform.is_none()), torques(trace));
    let displaced = |i: usize| -> Sym {
        let by_forces = forces.iter().map(|force| trace.dot(force.is, trace.material_displacement(force.at, i)));
        let by_torques =
            torques.iter().map(|torque| trace.dot(torque.is, trace.vector_by_speed(trace.turning(torque.on), i)));
        by_forces.chain(by_torques).fold(Sym::ZERO, |sum, each| sum + each)
    };
    let weights = |i: usize| -> Sym {
        let Some(gravity) = uniform else { return Sym::ZERO };
        let of = |body: &crate::Body| -> Option<Sym> {
            let height = trace.dot(gravity, trace.position(body.centre?));
            Some(trace.solidified(body.mass?) * trace.by_coordinate(height, i))
        };
        trace.model.bodies.iter().filter_map(of).fold(Sym::ZERO, |sum, each| sum + each)
    };
    (0..trace.speeds.len()).map(|i| inertia(trace, i) - weights(i) - displaced(i) + by_energies(trace, i)).collect()
}

/// Returns d/dt dT/du - dT/dq, plus w x dT/dw for a free frame.
pub(crate) fn inertia(trace: &Trace<'_>, i: usize) -> Sym {
    let kinetic = trace.kinetic_and_coenergy();
    let momentum = |j: usize| trace.by_speed(kinetic, j);
    trace.rate_of(momentum(i)) + trace.transposition(i, momentum) - trace.by_coordinate(kinetic, i)
}
