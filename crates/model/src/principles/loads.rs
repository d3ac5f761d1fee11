//! Applied loads for all principles: forces at points and torques on frames.

use crate::trace::{Trace, Vector};
use crate::{Along, Force, FrameId, Material, Torque};
use field::Analytic;
use symbolic::Sym;

/// A force at a point.
pub(crate) struct PointForce {
    pub at: Material,
    pub is: Vector,
}

/// A torque on a frame.
pub(crate) struct FrameTorque {
    pub on: FrameId,
    pub is: Vector,
}

/// Returns every force except those of potentials, one entry for each point; with `weights` also the weights.
pub(crate) fn forces(trace: &Trace<'_>, weights: bool) -> Vec<PointForce> {
    let mut all = Vec::new();
    for force in &trace.model.forces {
        match force {
            Force::On { at, is } => all.push(PointForce { at: *at, is: trace.vector(*is) }),
            Force::Between { points: [first, second], is } => {
                let line = trace.between(first.point, second.point);
                let size = trace.scalar(*is) / trace.dot(line, line).sqrt();
                let on_second = line.map(|component| size * component);
                all.push(PointForce { at: *second, is: on_second });
                all.push(PointForce { at: *first, is: on_second.map(|component| -component) });
            }
        }
    }
    if let (true, Some(gravity)) = (weights, trace.model.gravity) {
        let gravity = trace.vector(gravity);
        for body in &trace.model.bodies {
            if let (Some(mass), Some(point)) = (body.mass, body.centre) {
                let mass = trace.solidified(mass);
                let at = Material { body: None, point };
                all.push(PointForce { at, is: gravity.map(|component| mass * component) });
            }
        }
    }
    all
}

/// Returns every torque, one entry for each frame.
pub(crate) fn torques(trace: &Trace<'_>) -> Vec<FrameTorque> {
    let mut all = Vec::new();
    for torque in &trace.model.torques {
        match torque {
            Torque::On { frame, is } => all.push(FrameTorque { on: *frame, is: trace.vector(*is) }),
            Torque::Between { frames: [first, second], is } => {
                let is = trace.vector(*is);
                all.push(FrameTorque { on: *second, is });
                all.push(FrameTorque { on: *first, is: is.map(|component| -component) });
            }
        }
    }
    all
}

/// Returns the generalised force along a speed.
pub(crate) fn along(trace: &Trace<'_>, speed: usize) -> Sym {
    trace.model.generalised.iter().fold(Sym::ZERO, |sum, force| match force.along {
        Along::Speed(own) if own == speed => sum + trace.scalar(force.is),
        Along::Speed(_) => sum,
        Along::Expression(own) => sum + trace.scalar(force.is) * trace.by_speed(trace.scalar(own), speed),
        Along::QuasiVelocity(place) => {
            let velocity = trace.scalar(trace.model.quasi_velocities[place].is);
            sum + trace.scalar(force.is) * trace.by_speed(velocity, speed)
        }
    })
}

/// Returns the terms dV/dq + dD/du - Q of the residual, from a given potential, Rayleigh's dissipation function and generalised forces.
pub(crate) fn by_energies(trace: &Trace<'_>, speed: usize) -> Sym {
    let energies = &trace.model.energies;
    let potential = energies.potential.map_or(Sym::ZERO, |id| trace.by_coordinate(trace.scalar(id), speed));
    let dissipation = energies.dissipation.map_or(Sym::ZERO, |id| trace.by_speed(trace.scalar(id), speed));
    potential + dissipation - along(trace, speed)
}

/// Returns the generalised forces Q by partial velocities. Without `potentials`, those of potentials and uniform gravity are omitted.
pub(crate) fn generalised(trace: &Trace<'_>, potentials: bool) -> Vec<Sym> {
    let (forces, torques) = (forces(trace, potentials || trace.uniform_gravity().is_none()), torques(trace));
    let of = |i: usize| {
        let by_forces = forces.iter().map(|force| {
            let velocity = trace.material_velocity(force.at);
            trace.dot(force.is, trace.vector_by_speed(velocity, i))
        });
        let by_torques =
            torques.iter().map(|torque| trace.dot(torque.is, trace.vector_by_speed(trace.turning(torque.on), i)));
        let power = by_forces.chain(by_torques).fold(Sym::ZERO, |sum, each| sum + each);
        let energies = &trace.model.energies;
        let resisted = energies.dissipation.map_or(Sym::ZERO, |id| trace.by_speed(trace.scalar(id), i));
        let potential = energies.potential.filter(|_| potentials);
        power + along(trace, i) - resisted - potential.map_or(Sym::ZERO, |id| trace.by_coordinate(trace.scalar(id), i))
    };
    (0..trace.speeds.len()).map(of).collect()
}
