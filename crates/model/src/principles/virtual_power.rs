//! The Newton-Euler equations of every body, projected onto partial velocities (Jourdain; Kane):
//!
//!   sum (m a_C - F) . dv/du + (I w' + w x I w - T) . dw/du = 0

use super::loads::{by_energies, forces, torques};
use crate::Trace;
use symbolic::Sym;

pub(super) fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    let (forces, torques) = (forces(trace, true), torques(trace));
    let mut residual = vec![Sym::ZERO; trace.speeds.len()];
    for body in &trace.model.bodies {
        if let Some((mass, velocity, acceleration)) = trace.carried(body) {
            for (i, sum) in residual.iter_mut().enumerate() {
                let along = trace.vector_by_speed(velocity, i);
                *sum += mass * trace.dot(acceleration, along);
            }
        }
        if let Some((inertia, turning)) = trace.turned(body) {
            // the rate of I w relative to the ground, with components along the body's axes
            let momentum = trace.inertia_times(inertia, turning);
            let rate = trace.vector_rate(momentum);
            for (i, sum) in residual.iter_mut().enumerate() {
                *sum += trace.dot(rate, trace.vector_by_speed(turning, i));
            }
        }
    }
    for force in &forces {
        let velocity = trace.material_velocity(force.at);
        for (i, sum) in residual.iter_mut().enumerate() {
            *sum -= trace.dot(force.is, trace.vector_by_speed(velocity, i));
        }
    }
    for torque in &torques {
        let turning = trace.turning(torque.on);
        for (i, sum) in residual.iter_mut().enumerate() {
            *sum -= trace.dot(torque.is, trace.vector_by_speed(turning, i));
        }
    }
    residual.iter().enumerate().map(|(i, sum)| *sum + by_energies(trace, i) + trace.induced(i)).collect()
}
