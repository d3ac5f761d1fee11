//! Test for a potential energy of loads, also of springs that are written as forces.
//!
//! With the kinetic energy T and without accelerations and reactions the residuals are Q - (T_uq u - T_q). Where Q holds no speeds, and
//!
//!   dQ_i/dq_j = dQ_j/dq_i ,
//!
//! Q is the gradient of an energy about every position.

use model::Trace;
use model::equations::{Equation, vanishes};
use symbolic::{Sym, substitute_all};

/// The largest number of speeds for which this is tested: the work grows with its square.
const MOST_ASKED: usize = 10;

/// Whether the loads behind residuals without accelerations have a potential energy, T over the same letters.
pub(super) fn have_potential(trace: &Trace<'_>, residuals: &[Sym], energy: Sym, constraints: &[Equation]) -> bool {
    let (coordinates, speeds) = (&trace.coordinates, &trace.speeds);
    let n = speeds.len();
    if n > MOST_ASKED || !trace.solid().is_empty() {
        return false;
    }
    let without_reactions: Vec<(Sym, Sym)> = constraints.iter().map(|one| (one.multiplier, Sym::ZERO)).collect();
    let at_rest: Vec<(Sym, Sym)> = speeds.iter().map(|speed| (*speed, Sym::ZERO)).collect();
    // energies that are not quadratic in the speeds exert forces on a system at rest
    let is_quadratic = (0..n).all(|i| {
        (0..n).all(|j| {
            let second = energy.diff(speeds[i]).diff(speeds[j]);
            second.symbols_of().iter().all(|symbol| !speeds.contains(symbol))
        })
    }) && vanishes(energy.substitute(&at_rest))
        && speeds.iter().all(|&speed| vanishes(energy.diff(speed).substitute(&at_rest)));
    if !is_quadratic {
        return false;
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
    let holds_no_speeds = loads.iter().zip(&resting).all(|(load, resting)| vanishes(*load - *resting));
    let is_gradient =
        || (0..n).all(|i| (0..i).all(|j| vanishes(resting[i].diff(coordinates[j]) - resting[j].diff(coordinates[i]))));
    holds_no_speeds && is_gradient()
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
