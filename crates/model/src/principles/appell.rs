//! The Gibbs-Appell equations dS/du' = Q, with the energy of accelerations
//!
//!   S = sum m a_C^2/2 + w' . I w'/2 + w' . (w x I w) .
//!
//! The last term is the part of the rotational energy of accelerations that is linear in w'. Terms without accelerations
//! are omitted.

use super::loads::{by_energies, forces, torques};
use crate::Trace;
use field::Rational;
use symbolic::Sym;

/// Returns S without the terms that do not depend on accelerations.
pub(crate) fn energy_of_accelerations(trace: &Trace<'_>) -> Sym {
    let half = Sym::constant(Rational::new(1, 2));
    let mut sum = Sym::ZERO;
    for body in &trace.model.bodies {
        if let Some((mass, _, acceleration)) = trace.carried(body) {
            sum += half * mass * trace.dot(acceleration, acceleration);
        }
        if let Some((inertia, turning)) = trace.turned(body) {
            let angular = trace.vector_rate(turning);
            let gyroscopic = trace.cross(turning, trace.inertia_times(inertia, turning));
            sum =
                sum + half * trace.dot(angular, trace.inertia_times(inertia, angular)) + trace.dot(angular, gyroscopic);
        }
    }
    sum
}

pub(super) fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    let energy = energy_of_accelerations(trace);
    let (forces, torques) = (forces(trace, true), torques(trace));
    let power = |i: usize| -> Sym {
        let of_forces = forces.iter().map(|force| {
            let velocity = trace.material_velocity(force.at);
            trace.dot(force.is, trace.vector_by_speed(velocity, i))
        });
        let of_torques =
            torques.iter().map(|torque| trace.dot(torque.is, trace.vector_by_speed(trace.turning(torque.on), i)));
        of_forces.chain(of_torques).fold(Sym::ZERO, |sum, each| sum + each)
    };
    (0..trace.speeds.len())
        .map(|i| trace.by_acceleration(energy, i) - power(i) + by_energies(trace, i) + trace.induced(i))
        .collect()
}
