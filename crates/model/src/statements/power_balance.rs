//! The power balance: the rate of the energy is the power of all loads and reactions.
//!
//! With H = sum u dT/du - T + V and the residual R of the equations of motion, inertia less forces, identically
//!
//!   dH/dt = sum u R + P + d(V - T)/dt|q,u + sum m' dH/dm ,
//!
//! where P is the power of all forces without a potential on the velocities less those at u = 0, and m are the masses and moments of
//! inertia that vary: the equations take them as solidified. Along a motion R is the reaction J^T lambda, whose power sum lambda J u is
//! given by [`ReactionPower`]. Where T is homogeneous of second degree in the speeds, H is T + V.

use super::reaction_power::{ReactionPower, or_zero, sum_written};
use super::{Statement, piecewise, residual, while_inputs_rest};
use crate::agreement::decided;
use crate::equations::{Equation, constraints_of, vanishes};
use crate::principles::hamilton::momenta;
use crate::principles::loads::{along, forces, torques};
use crate::{Trace, Vector};
use symbolic::Sym;

/// The energy that a balance is of.
struct Energy {
    is: Sym,
    /// Whether it is T + V.
    is_whole: bool,
    /// d(V - T)/dt at rest, T with the co-energy.
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

    /// sum m' dH/dm over the masses and moments of inertia that vary.
    fn by_masses(&self, trace: &Trace<'_>) -> Sym {
        trace.solid().iter().fold(Sym::ZERO, |sum, &(letter, value)| sum + self.is.diff(letter) * trace.rate_of(value))
    }
}

/// The energy of a model and the power that feeds it along every motion, over the letters of a trace, multipliers among them.
#[derive(Clone, Copy, Debug)]
pub struct PowerBalance {
    /// H, which is T + V where T is homogeneous of second degree in the speeds.
    pub energy: Sym,
    /// dH/dt; the constant zero where it vanishes as it stands.
    pub power: Sym,
}

impl PowerBalance {
    /// The balance by the forces, the reactions and the terms with the time.
    pub fn of(trace: &Trace<'_>) -> Self {
        let Parts { energy, constraints, powers, by_forces, by_masses } = Parts::of(trace);
        let by_reactions = of_reactions(&constraints, &powers, |power| power.working);
        PowerBalance { energy: energy.is, power: by_forces.is + by_reactions + energy.by_time + by_masses }
    }
}

/// All that a balance is made of.
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

/// The sum of a part of the power of each reaction.
fn of_reactions(constraints: &[Equation], powers: &[ReactionPower], part: impl Fn(&ReactionPower) -> Sym) -> Sym {
    constraints.iter().zip(powers).fold(Sym::ZERO, |sum, (one, power)| sum + one.multiplier * part(power))
}

pub(super) fn statement(trace: &Trace<'_>) -> Statement {
    let Parts { energy, constraints, powers, by_forces, by_masses } = Parts::of(trace);
    let of_reactions = |part: fn(&ReactionPower) -> Sym| of_reactions(&constraints, &powers, part);
    // zero along every motion: sum u (R - J^T lambda), and sum lambda n f
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

/// The balance in words.
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

/// The power of forces without a potential on the velocities less those at u = 0.
struct Power {
    is: Sym,
    /// Whether forces have power at u = 0 too.
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
