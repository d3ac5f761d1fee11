//! The energy goes where the forces send it.
//!
//! With H = sum u dT/du - T + V and the residual R of the equations of motion, identically
//!
//!   dH/dt + dT/dt|q,u - dV/dt|q = sum u R + P ,
//!
//! where P is the power of all forces without a potential on the motion relative to the one at u = 0. Along a motion R is the
//! reaction J^T lambda, whose power is that of [`constraint_rates`](super::constraint_rates).

use super::{Statement, residual};
use crate::Trace;
use crate::agreement::{decided, is_zero};
use crate::principles::hamilton::momenta;
use crate::principles::loads::{along, forces, torques};
use symbolic::Sym;

pub(super) fn statement(trace: &Trace<'_>) -> Statement {
    let (kinetic, potential) = (trace.kinetic_energy(), trace.potential_energy());
    let moved = momenta(trace).iter().zip(&trace.speeds).fold(Sym::ZERO, |sum, (&p, &u)| sum + p * u);
    let energy = moved - kinetic + potential;
    let by_time = |expression: Sym| expression.diff(trace.time);
    let rate = trace.rate_of(energy) + by_time(kinetic) - by_time(potential);
    let equations = residual(trace).iter().zip(&trace.speeds).fold(Sym::ZERO, |sum, (&r, &u)| sum + u * r);
    let agreement = decided(&[(rate, equations + power(trace))]);
    let is_whole = is_zero(energy - kinetic - potential);
    let knows_time = !(is_zero(by_time(kinetic)) && is_zero(by_time(potential)));
    let of = if is_whole { "T + V" } else { "H = sum u dT/du - T + V" };
    let rate = if knows_time { format!("({of})' less what the time does to V - T") } else { format!("({of})'") };
    let says =
        if is_zero(power(trace)) { format!("{rate} is zero") } else { format!("{rate} is the power of the forces") };
    let changes = !(trace.model.events.is_empty() && trace.model.switches.is_empty());
    let says = if changes { format!("between events {says}") } else { says };
    Statement { subject: "energy".to_owned(), says, agreement }
}

/// The power of forces without a potential, less that on the motion at u = 0.
fn power(trace: &Trace<'_>) -> Sym {
    let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let moving = |vector: crate::Vector| vector.map(|component| component - component.substitute(&at_rest));
    let by_forces = forces(trace, trace.uniform_gravity().is_none()).into_iter();
    let by_forces = by_forces.map(|force| trace.dot(force.is, moving(trace.material_velocity(force.at))));
    let by_torques = torques(trace).into_iter().map(|torque| trace.dot(torque.is, moving(trace.turning(torque.on))));
    let along = trace.speeds.iter().enumerate().map(|(i, &u)| u * along(trace, i));
    let given = by_forces.chain(by_torques).chain(along).fold(Sym::ZERO, |sum, each| sum + each);
    trace.model.energies.dissipation.map_or(given, |id| {
        let resisted = trace.scalar(id);
        let resisted = trace.speeds.iter().enumerate().map(|(i, &u)| u * trace.by_speed(resisted, i));
        resisted.fold(given, |sum, each| sum - each)
    })
}
