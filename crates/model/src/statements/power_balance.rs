//! The power balance: the rate of the energy equals the power of all loads and reactions.
//!
//! Let H = sum u dT/du - T + V, and let R be the residual of the equations of motion, inertia minus forces. The identity is
//!
//!   dH/dt = sum u R + P + d(V - T)/dt|q,u + sum m' dH/dm ,
//!
//! where P is the power of all forces without a potential, with velocities relative to those at u = 0, and m are the variable masses and moments of
//! inertia, which the equations treat as constant at each instant. Along a motion R is the reaction J^T lambda, whose power sum lambda J u is
//! computed by [`ReactionPower`]. If T is homogeneous of second degree in the speeds, then H = T + V.

use super::reaction_power::{ReactionPower, or_zero, sum_written};
use super::{Statement, piecewise, residual, while_inputs_rest};
use crate::agreement::decided;
use crate::equations::{Equation, constraints_of, vanishes};
use crate::principles::hamilton::momenta;
use crate::principles::loads::{along, forces, torques};
use crate::{Trace, Vector};
use symbolic::Sym;

/// The energy H of a balance.
struct Energy {
    is: Sym,
    /// Whether H is T + V.
    is_whole: bool,
    /// The partial derivative d(V - T)/dt; T includes the co-energy.
    by_time: Sym,
}

impl Energy {
    fn of(trace: &Trace<'_>) -> Self {
        let (kinetic, potential) = (trace.kinetic_and_coenergy(), trace.potential_energy());
        let moved = momenta(trace).iter().zip(&trace.speeds).fold(Sym::ZERO, |sum, (&p, &u)| sum + p * u);
        let is_whole = trace.has_quadratic_kinetic_energy();
        let is = if is_whole { kinetic + potential } else { moved - kinetic + potential };
        Energy { is, is_whole, by_time: or_zero((potential - kinetic).diff(trace.time)) }
    }

    /// Returns sum m' dH/dm over the variable masses and moments of inertia.
    fn by_masses(&self, trace: &Trace<'_>) -> Sym {
        trace.solid().iter().fold(Sym::ZERO, |sum, &(letter, value)| sum + self.is.diff(letter) * trace.rate_of(value))
    }
}

/// The energy of a model and the power supplied to it along every motion, over the symbols of a trace, including multipliers.
#[derive(Clone, Copy, Debug)]
pub struct PowerBalance {
    /// The energy H; it equals T + V if T is homogeneous of second degree in the speeds.
    pub energy: Sym,
    /// The power dH/dt; the constant zero if it vanishes identically without simplification.
    pub power: Sym,
}

impl PowerBalance {
    /// Computes the balance from the forces, the reactions and the partial time derivative.
    pub fn of(trace: &Trace<'_>) -> Self {
        let Parts { energy, constraints, powers, by_forces, by_masses } = Parts::of(trace);
        let by_reactions = of_reactions(&constraints, &powers, |power| power.working);
        PowerBalance { energy: energy.is, power: by_forces.is + by_reactions + energy.by_time + by_masses }
    }
}

/// The parts of a balance.
struct Parts {
    energy: Energy,
    constraints: Vec<Equation>,
    powers: Vec<ReactionPower>,
    by_forces: Power,
    by_masses: Sym,
}

impl Parts {
    fn of(trace: &Trace<'_>) -> Self {
        let (energy, constraints) = (Energy::of(trace), constraints_of(trace));
        let powers = constraints.iter().map(|one| ReactionPower::of(trace, one)).collect();
        let by_masses = energy.by_masses(trace);
        Parts { energy, constraints, powers, by_forces: Power::of_forces(trace), by_masses }
    }
}

/// Returns the sum of one part of the power of all reactions.
fn of_reactions(constraints: &[Equation], powers: &[ReactionPower], part: impl Fn(&ReactionPower) -> Sym) -> Sym {
    constraints.iter().zip(powers).fold(Sym::ZERO, |sum, (one, power)| sum + one.multiplier * part(power))
}

pub(super) fn statement(trace: &Trace<'_>) -> Statement {
    let Parts { energy, constraints, powers, by_forces, by_masses } = Parts::of(trace);
    let of_reactions = |part: fn(&ReactionPower) -> Sym| of_reactions(&constraints, &powers, part);
    // terms that vanish along every motion: sum u (R - J^T lambda), and sum lambda n f
    let of_speed = |(i, &inertia): (usize, &Sym)| {
        constraints.iter().fold(inertia, |rest, one| rest - one.multiplier * one.row[i]) * trace.speeds[i]
    };
    let equations = residual(trace).iter().enumerate().map(of_speed).fold(Sym::ZERO, |sum, each| sum + each);
    let rate = trace.rate_of(energy.is) + by_masses;
    let stated = by_forces.is + of_reactions(|power| power.working) + energy.by_time + by_masses;
    let subject = "energy".to_owned();
    let agreement = decided(trace, &subject, &[(rate, stated + equations + of_reactions(|power| power.idle))]);
    let says = piecewise(trace, &says(trace, &energy, &by_forces, &powers));
    let known: Vec<Sym> = constraints.iter().map(|one| one.zero).chain([energy.is]).collect();
    Statement { subject, says: while_inputs_rest(trace, &known, says), agreement }
}

/// Returns the balance in words.
fn says(trace: &Trace<'_>, energy: &Energy, by_forces: &Power, powers: &[ReactionPower]) -> String {
    let (name, short) = match (energy.is_whole, trace.model.energies.coenergy.is_some()) {
        (true, false) => ("(T + V)'", "T + V"),
        (true, true) => ("(T + W + V)' with the energy W of magnetic fields", "T + W + V"),
        (false, false) => ("(H = sum u dT/du - T + V)'", "H"),
        (false, true) => ("(H = sum u d(T + W')/du - T - W' + V)' with the co-energy W' of magnetic fields", "H"),
    };
    let mut parts = Vec::new();
    if by_forces.is != Sym::ZERO {
        parts.push("the power of the forces".to_owned());
    }
    let works = powers.iter().any(|power| !power.is_zero());
    if works {
        let sum = sum_written(trace, powers).unwrap_or_else(|| "sum lambda J u".to_owned());
        parts.push(format!("the power of the reactions ({sum})"));
    }
    if energy.by_time != Sym::ZERO {
        let has_coenergy = trace.model.energies.coenergy.is_some();
        parts.push(format!("the partial rate of V - T{} by t", if has_coenergy { " - W'" } else { "" }));
    }
    if !trace.solid().is_empty() {
        parts.push(format!("sum m' d({short})/dm over the masses and moments of inertia m that vary"));
    }
    let sum = if parts.is_empty() { "zero".to_owned() } else { parts.join(" plus ") };
    let is_relative = works && !energy.is_whole || by_forces.is_relative;
    let relative = if is_relative { "; powers are computed with velocities less the velocities at u = 0" } else { "" };
    format!("{name} is {sum}{relative}")
}

/// The power of forces without a potential, with velocities relative to those at u = 0.
struct Power {
    is: Sym,
    /// Whether the forces also have power at u = 0.
    is_relative: bool,
}

impl Power {
    fn of_forces(trace: &Trace<'_>) -> Self {
        let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
        let (mut is, mut still) = (Sym::ZERO, Sym::ZERO);
        let mut add = |force: Vector, velocity: Vector| {
            let moving = velocity.map(|component| component - component.substitute(&at_rest));
            is += trace.dot(force, moving);
            still += trace.dot(force, velocity.map(|component| component.substitute(&at_rest)));
        };
        for force in forces(trace, trace.uniform_gravity().is_none()) {
            add(force.is, trace.material_velocity(force.at));
        }
        for torque in torques(trace) {
            add(torque.is, trace.turning(torque.on));
        }
        let dissipation = trace.model.energies.dissipation.map_or(Sym::ZERO, |id| trace.scalar(id));
        for (i, &speed) in trace.speeds.iter().enumerate() {
            is += (along(trace, i) - trace.by_speed(dissipation, i)) * speed;
        }
        let is = or_zero(is);
        Power { is, is_relative: is != Sym::ZERO && !vanishes(still) }
    }
}
