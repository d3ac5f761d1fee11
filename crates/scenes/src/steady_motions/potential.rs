//! Test for a potential energy of loads, also of springs that are written as forces.
//!
//! With the kinetic energy T and without accelerations and reactions the residuals are Q - (T_uq u - T_q). Where Q holds no speeds, and
//!
//!   dQ_i/dq_j = dQ_j/dq_i ,
//!
//! Q is the gradient of an energy about every position, -V_q. In frames that turn at a given rate T = T2 + T1 + T0 by powers of the speeds:
//! Jacobi's integral T2 + V - T0 is kept, and T1 gives gyroscopic forces, which do no work.

use super::conditions::constant;
use model::Trace;
use model::equations::{Equation, vanishes};
use symbolic::{Sym, substitute_all};

/// The largest number of speeds for which this is tested: the work grows with its square.
const MOST_ASKED: usize = 10;

/// An integral of a system whose loads have a potential energy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct EnergyIntegral {
    /// Whether frames that turn at a given rate give kinetic energy to a system that rests in them: Jacobi's integral.
    pub is_of_jacobi: bool,
    /// Whether gyroscopic forces act on small motions about rest.
    pub is_gyroscopic: bool,
    /// Whether it is constant; otherwise linear dampers lessen it.
    pub is_kept: bool,
}

/// The energy where the loads behind residuals without accelerations have a potential energy but for linear dampers, T over the same letters. The reactions of
/// constraints and of contacts are left out: without friction they do no work.
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

/// Rounding of sums of decimals, relative to them.
const ROUNDING: f64 = 1e-13;

/// Whether the power of loads is a quadratic form of the speeds with constant coefficients, and nowhere positive: each diagonal entry
/// outweighs the others of its row, as of dampers of coordinates and between two of them.
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

/// Whether expressions are the derivatives of one by coordinates.
fn is_gradient(all: &[Sym], by: &[Sym]) -> bool {
    (0..all.len()).all(|i| (0..i).all(|j| vanishes(all[i].diff(by[j]) - all[j].diff(by[i]))))
}

/// Coordinates with conserved momenta: T does not depend on them, and no load and no reaction occurs in their equations,
///
///   R_k + d(T_uk)/dq u = 0 ,
///
/// with residuals R = Q + J^T lambda - (d(T_u)/dq u - T_q) without accelerations.
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
