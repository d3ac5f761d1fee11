//! Kane's equations: the Newton-Euler equations of every body, projected onto the partial velocities dv/dw and dW/dw.
//!
//! Velocities are functions of q and w. Accelerations are their rates, with q' = q'(q, w, t).

use super::QuasiVelocities;
use crate::principles::loads::{forces, torques};
use crate::{Along, Trace, Vector};
use symbolic::Sym;

/// Returns the generalised forces along each w: of forces, torques, a potential, Rayleigh's dissipation function and generalised
/// forces.
pub(super) fn active(quasi: &QuasiVelocities<'_, '_>, trace: &Trace<'_>) -> Vec<Sym> {
    let mut sums = by_energies(quasi, trace);
    for force in forces(trace, true) {
        let velocity = quasi.moved_vector(trace.material_velocity(force.at));
        add(quasi, trace, &mut sums, quasi.moved_vector(force.is), velocity);
    }
    for torque in torques(trace) {
        let turning = quasi.turning(torque.on);
        add(quasi, trace, &mut sums, quasi.moved_vector(torque.is), turning);
    }
    sums
}

/// Adds load . dv/dw_r to each sum.
fn add(quasi: &QuasiVelocities<'_, '_>, trace: &Trace<'_>, sums: &mut [Sym], load: Vector, velocity: Vector) {
    for (sum, &w) in sums.iter_mut().zip(&quasi.symbols) {
        *sum += trace.dot(load, velocity.map(|component| component.diff(w)));
    }
}

/// Returns -dV/dq along the directions of w, minus dD/dw, plus generalised forces.
fn by_energies(quasi: &QuasiVelocities<'_, '_>, trace: &Trace<'_>) -> Vec<Sym> {
    let energies = &trace.model.energies;
    let potential = energies.potential.map_or(Sym::ZERO, |id| quasi.rate_of(trace.scalar(id)));
    let dissipation = energies.dissipation.map_or(Sym::ZERO, |id| quasi.moved(trace.scalar(id)));
    let along = |place: usize, w: Sym| {
        trace.model.generalised.iter().fold(Sym::ZERO, |sum, force| match force.along {
            Along::Speed(speed) => sum + quasi.moved(trace.scalar(force.is)) * quasi.speeds[speed].diff(w),
            Along::QuasiVelocity(own) if own == place => sum + quasi.moved(trace.scalar(force.is)),
            Along::QuasiVelocity(_) => sum,
            Along::Expression(own) => {
                sum + quasi.moved(trace.scalar(force.is)) * quasi.moved(trace.scalar(own)).diff(w)
            }
        })
    };
    let all = quasi.symbols.iter().enumerate();
    all.map(|(place, &w)| along(place, w) - potential.diff(w) - dissipation.diff(w)).collect()
}

pub(super) fn residual(quasi: &QuasiVelocities<'_, '_>, trace: &Trace<'_>) -> Vec<Sym> {
    let mut inertia = vec![Sym::ZERO; quasi.symbols.len()];
    for body in &trace.model.bodies {
        if let Some((mass, velocity, _)) = trace.carried(body) {
            let velocity = quasi.moved_vector(velocity);
            let acceleration = quasi.vector_rate(velocity);
            add(quasi, trace, &mut inertia, acceleration.map(|component| mass * component), velocity);
        }
        if let (Some(tensor), Some(frame)) = (&body.inertia, body.frame) {
            let turning = quasi.turning(frame);
            let momentum = trace.inertia_times(tensor, turning);
            add(quasi, trace, &mut inertia, quasi.vector_rate(momentum), turning);
        }
    }
    inertia.into_iter().zip(active(quasi, trace)).map(|(inertia, active)| inertia - active).collect()
}
