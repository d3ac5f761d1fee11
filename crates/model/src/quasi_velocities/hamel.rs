//! The Boltzmann-Hamel equations, from the kinetic energy T(q, w, s, t):
//!
//!   d/dt dT/dw_r + sum_k (dT/dp_k) g_kr - X_r(T) = Q_r,    p = (w, s),    s = 0 after differentiation of T.
//!
//! Here X_r = sum_i C_ir d/dq_i at constant p, and g_kr follows from the three-index symbols g^k_rl,
//!
//!   g_kr = sum_i C_ir (d/dt dp_k/du_i - dp_k/dq_i) = sum_l g^k_rl p_l + terms in the time.
//!
//! The rates s of constraints are quasi-velocities too, since their momenta dT/ds do not vanish at s = 0. For a free frame the term
//! (W x dp_k/dW)_i is added, since its angular velocity W is itself a quasi-velocity.

use super::QuasiVelocities;
use crate::Trace;
use crate::principles::loads::generalised;
use symbolic::{Sym, substitute_all};

pub(super) fn residual(quasi: &QuasiVelocities<'_, '_>, trace: &Trace<'_>) -> Vec<Sym> {
    let rates = quasi.independent.iter().map(|&place| quasi.met[place].rate);
    // names of systems contain no spaces
    let named = |k: usize| Sym::symbol(&format!("rate of constraint {}", k + 1));
    let idle: Vec<Sym> = (0..quasi.independent.len()).map(named).collect();
    let whole = quasi.speeds.iter().zip(&quasi.across).map(|(&speed, across)| {
        let terms = across.iter().zip(&idle);
        terms.fold(speed, |sum, (&slope, &rate)| sum + slope * rate)
    });
    let by_all: Vec<(Sym, Sym)> = trace.speeds.iter().copied().zip(whole).collect();
    let kinetic = trace.kinetic_and_coenergy().substitute(&by_all);
    let at_zero: Vec<(Sym, Sym)> = idle.iter().map(|&rate| (rate, Sym::ZERO)).collect();
    let momenta: Vec<Sym> = quasi.symbols.iter().chain(&idle).map(|&letter| kinetic.diff(letter)).collect();
    let momenta = substitute_all(&momenta, &at_zero);
    let kinetic = kinetic.substitute(&at_zero);
    let by_place = quasi.along(&(0..trace.speeds.len()).map(|i| trace.by_coordinate(kinetic, i)).collect::<Vec<_>>());
    let forces: Vec<Sym> = generalised(trace, true).into_iter().map(|force| quasi.moved(force)).collect();
    let forces = quasi.along(&forces);
    let mut sums: Vec<Sym> =
        (0..quasi.symbols.len()).map(|r| quasi.rate_of(momenta[r]) - by_place[r] - forces[r]).collect();
    let all = quasi.definitions.iter().copied().chain(rates);
    for (velocity, momentum) in all.zip(momenta) {
        if momentum == Sym::ZERO {
            continue;
        }
        let transposed = |i: usize| {
            let turned = trace.transposition(i, |j| trace.by_speed(velocity, j));
            quasi.moved(trace.rate_of(trace.by_speed(velocity, i)) + turned - trace.by_coordinate(velocity, i))
        };
        let transposed: Vec<Sym> = (0..trace.speeds.len()).map(transposed).collect();
        for (sum, transposed) in sums.iter_mut().zip(quasi.along(&transposed)) {
            *sum += momentum * transposed;
        }
    }
    sums
}
