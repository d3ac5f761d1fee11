//! Test whether the loads have a potential energy, also if they are written as forces.
//!
//! With the kinetic energy T, the residuals without accelerations and reactions are Q - (T_uq u - T_q). If Q does not depend on speeds and
//!
//!   dQ_i/dq_j = dQ_j/dq_i ,
//!
//! then Q = -V_q locally. In frames that turn at a given rate, T = T2 + T1 + T0 by powers of the speeds. Jacobi's integral T2 + V - T0 is constant
//! then, and T1 causes gyroscopic forces, which do no work.

use super::conditions::constant;
use model::Trace;
use model::equations::{Equation, vanishes};
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
    let n = speeds.len();
    if n > MOST_ASKED || !trace.solid().is_empty() || !vanishes(energy.diff(trace.time)) {
        return None;
    }
    let reactions = constraints.iter().map(|one| one.multiplier).chain(trace.reactions());
    let without_reactions: Vec<(Sym, Sym)> = reactions.map(|letter| (letter, Sym::ZERO)).collect();
    let at_rest: Vec<(Sym, Sym)> = speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    let is_quadratic = (0..n).all(|i| {
        (0..n).all(|j| {
            let second = energy.diff(speeds[i]).diff(speeds[j]);
            second.symbols_of().iter().all(|symbol| !speeds.contains(symbol))
        })
    });
    if !is_quadratic {
        return None;
    }
    let loads: Vec<Sym> = substitute_all(residuals, &without_reactions)
        .into_iter()
        .enumerate()
        .map(|(i, residual)| {
            let momentum = energy.diff(speeds[i]);
            let rate =
                (0..n).map(|j| momentum.diff(coordinates[j]) * speeds[j]).fold(Sym::ZERO, |sum, each| sum + each);
            residual + rate - energy.diff(coordinates[i])
        })
        .collect();
    let resting = substitute_all(&loads, &at_rest);
    let of_speeds: Vec<Sym> = loads.iter().zip(&resting).map(|(load, resting)| *load - *resting).collect();
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

/// Relative rounding error of sums of decimals.
const ROUNDING: f64 = 1e-13;

/// Whether the power of loads is a quadratic form of the speeds with constant coefficients that is nowhere positive, by diagonal dominance; dampers
/// of coordinates and between two coordinates have this form.
fn take_power(loads: &[Sym], speeds: &[Sym]) -> bool {
    let power = loads.iter().zip(speeds).fold(Sym::ZERO, |sum, (load, speed)| sum + *load * *speed);
    let row = |i: usize| -> Option<Vec<f64>> {
        let slope = power.diff(speeds[i]);
        speeds.iter().map(|&speed| constant(slope.diff(speed))).collect()
    };
    (0..speeds.len()).all(|i| {
        row(i).is_some_and(|row| {
            let others: f64 = (0..row.len()).filter(|&j| j != i).map(|j| row[j].abs()).sum();
            row[i] <= 0.0 && -row[i] >= others * (1.0 - ROUNDING)
        })
    })
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
