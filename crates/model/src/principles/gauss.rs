//! Gauss' principle of least constraint: among all accelerations those of the motion minimise Z = S - sum F . a - T . w'. Potentials and Rayleigh's dissipation function
//! enter by their second and first time derivatives.

use super::appell::energy_of_accelerations;
use super::loads::{along, forces, torques};
use crate::Trace;
use symbolic::Sym;

pub(super) fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    let mut constraint = energy_of_accelerations(trace);
    for force in forces(trace, true) {
        constraint -= trace.dot(force.is, trace.material_acceleration(force.at));
    }
    for torque in torques(trace) {
        constraint -= trace.dot(torque.is, trace.vector_rate(trace.turning(torque.on)));
    }
    let energies = &trace.model.energies;
    if let Some(potential) = energies.potential {
        constraint += trace.rate_of(trace.rate_of(trace.scalar(potential)));
    }
    if let Some(dissipation) = energies.dissipation {
        constraint += trace.rate_of(trace.scalar(dissipation));
    }
    for (i, &acceleration) in trace.accelerations.iter().enumerate() {
        constraint -= along(trace, i) * acceleration;
    }
    (0..trace.speeds.len()).map(|i| trace.by_acceleration(constraint, i) + trace.induced(i)).collect()
}
