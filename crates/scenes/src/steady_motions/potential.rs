//! Test whether the loads have a potential energy, also if they are written as forces.
//!
//! With the kinetic energy T, the residuals without accelerations and reactions are Q - (T_uq u - T_q). If Q does not depend on speeds and
//!
//!   dQ_i/dq_j = dQ_j/dq_i ,
//!
//! then Q = -V_q locally. In frames that turn at a given rate, T = T2 + T1 + T0 by powers of the speeds. Jacobi's integral T2 + V - T0 is constant
//! then, and T1 causes gyroscopic forces, which do no work.

use super::dissipation::take_power;
use crate::letters::Letters;
use model::equations::{Equation, Level, Residuals, constraints_of, vanishes};
use model::{Model, Trace};
use symbolic::{Sym, substitute_all};

/// Largest number of speeds for this test; its cost grows with the square of the number.
const MOST_ASKED: usize = 10;

/// The energy integral of a system whose loads have a potential energy, except for linear dampers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct EnergyIntegral {
    /// Whether T0 is not zero, so that Jacobi's integral takes the place of the energy.
    pub is_of_jacobi: bool,
    /// Whether gyroscopic forces act on small motions about a position of rest.
    pub is_gyroscopic: bool,
    /// Whether the integral is constant; otherwise linear dampers reduce its value.
    pub is_kept: bool,
}

/// The energy integral of a system with the residuals R without accelerations and the kinetic energy T = `energy`; `None` if the loads have no
/// potential energy besides linear dampers. Reactions of constraints and contacts are left out, since they do no work without friction.
pub(super) fn energy_integral(
    trace: &Trace<'_>,
    residuals: &[Sym],
    energy: Sym,
    constraints: &[Equation],
) -> Option<EnergyIntegral> {
    let (coordinates, speeds) = (&trace.coordinates, &trace.speeds);
    if speeds.len() > MOST_ASKED || !trace.solid().is_empty() || !vanishes(energy.diff(trace.time)) {
        return None;
    }
    if !is_quadratic(energy, speeds) {
        return None;
    }
    let at_rest: Vec<(Sym, Sym)> = speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    let Loads { resting, of_speeds } = Loads::of(trace, residuals, energy, constraints);
    let is_kept = of_speeds.iter().all(|load| vanishes(*load));
    if !(is_kept || take_power(&of_speeds, speeds)) || !is_gradient(&resting, coordinates) {
        return None;
    }
    let linear: Vec<Sym> = speeds.iter().map(|&speed| energy.diff(speed).substitute(&at_rest)).collect();
    Some(EnergyIntegral {
        is_of_jacobi: !vanishes(energy.substitute(&at_rest)),
        is_gyroscopic: !is_gradient(&linear, coordinates),
        is_kept,
    })
}

/// Whether a model without contacts and constraints of speeds has linear equations about its positions of rest that keep an energy: its
/// loads at rest have a potential energy, and to first order in the speeds the others do no work. A force -c v^3 is an example of them.
pub fn keeps_energy_near_rest(model: &Model) -> bool {
    symbolic::apart(|| is_kept_near_rest(model))
}

fn is_kept_near_rest(model: &Model) -> bool {
    let trace = Trace::of(model);
    let speeds = &trace.speeds;
    let constraints = constraints_of(&trace);
    let is_of_positions = |one: &Equation| one.level == Level::Position && one.gains.is_none() && one.law.is_none();
    if speeds.len() > MOST_ASKED || !(model.contacts.is_empty() && constraints.iter().all(is_of_positions)) {
        return false;
    }
    let Some(equations) = Residuals::of(&trace).into_iter().next() else { return false };
    let state = [&trace.coordinates[..], speeds].concat();
    let letters = Letters::with_decimals(trace.time, &state);
    let residuals = letters.put_into(&trace, &equations.residuals[..model.speeds()]);
    let energy = letters.put_into(&trace, &[trace.kinetic_energy()])[0];
    let knows_time = residuals.iter().any(|row| row.symbols_of().contains(&trace.time));
    if knows_time || !trace.solid().is_empty() || !is_quadratic(energy, speeds) {
        return false;
    }
    let rests: Vec<(Sym, Sym)> = trace.accelerations.iter().map(|own| (*own, Sym::ZERO)).collect();
    let Loads { resting, of_speeds } = Loads::of(&trace, &substitute_all(&residuals, &rests), energy, &constraints);
    let at_rest: Vec<(Sym, Sym)> = speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    let slope = |i: usize, j: usize| of_speeds[i].diff(speeds[j]).substitute(&at_rest);
    let does_no_work = (0..speeds.len()).all(|i| (0..=i).all(|j| vanishes(slope(i, j) + slope(j, i))));
    does_no_work && is_gradient(&resting, &trace.coordinates)
}

/// Whether a kinetic energy has second derivatives by speeds without speeds.
fn is_quadratic(energy: Sym, speeds: &[Sym]) -> bool {
    let is_free = |second: Sym| second.symbols_of().iter().all(|symbol| !speeds.contains(symbol));
    speeds.iter().all(|&one| speeds.iter().all(|&other| is_free(energy.diff(one).diff(other))))
}

/// The loads behind residuals without accelerations and reactions.
struct Loads {
    /// The loads at zero speeds.
    resting: Vec<Sym>,
    /// The terms of the loads that depend on speeds.
    of_speeds: Vec<Sym>,
}

impl Loads {
    /// The loads Q = R + (T_uq u - T_q), with the kinetic energy T, over the same letters as the residuals R. Reactions of constraints and
    /// of contacts are zero.
    fn of(trace: &Trace<'_>, residuals: &[Sym], energy: Sym, constraints: &[Equation]) -> Self {
        let (coordinates, speeds) = (&trace.coordinates, &trace.speeds);
        let reactions = constraints.iter().map(|one| one.multiplier).chain(trace.reactions());
        let without_reactions: Vec<(Sym, Sym)> = reactions.map(|letter| (letter, Sym::ZERO)).collect();
        let at_rest: Vec<(Sym, Sym)> = speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
        let load = |(i, residual): (usize, Sym)| {
            let momentum = energy.diff(speeds[i]);
            let along = coordinates.iter().zip(speeds).map(|(&by, &speed)| momentum.diff(by) * speed);
            residual + along.fold(Sym::ZERO, |sum, each| sum + each) - energy.diff(coordinates[i])
        };
        let loads: Vec<Sym> = substitute_all(residuals, &without_reactions).into_iter().enumerate().map(load).collect();
        let resting = substitute_all(&loads, &at_rest);
        let of_speeds = loads.iter().zip(&resting).map(|(load, resting)| *load - *resting).collect();
        Loads { resting, of_speeds }
    }
}

/// Whether expressions are the gradient of a function of `by`.
fn is_gradient(all: &[Sym], by: &[Sym]) -> bool {
    (0..all.len()).all(|i| (0..i).all(|j| vanishes(all[i].diff(by[j]) - all[j].diff(by[i]))))
}

/// The indices of coordinates with conserved momenta: T does not depend on them, and their equations contain no load and no reaction,
///
///   R_k + d(T_uk)/dq u = 0 ,
///
/// with the residuals R = Q + J^T lambda - (d(T_u)/dq u - T_q) without accelerations.
pub(super) fn momenta_kept(trace: &Trace<'_>, residuals: &[Sym], energy: Sym) -> Vec<usize> {
    let (coordinates, speeds) = (&trace.coordinates, &trace.speeds);
    if !trace.solid().is_empty() {
        return Vec::new();
    }
    let is_kept = |&k: &usize| {
        let momentum = energy.diff(speeds[k]);
        let rate =
            || coordinates.iter().zip(speeds).fold(Sym::ZERO, |sum, (&by, &speed)| sum + momentum.diff(by) * speed);
        vanishes(energy.diff(coordinates[k])) && vanishes(residuals[k] + rate())
    };
    (0..speeds.len().min(coordinates.len())).filter(is_kept).collect()
}
