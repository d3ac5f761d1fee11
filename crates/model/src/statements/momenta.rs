//! Conserved momenta: dT/du of a coordinate on which neither T nor V depends, and on which no force and no reaction acts.

use super::{Statement, piecewise, residual, while_inputs_rest};
use crate::Trace;
use crate::agreement::decided;
use crate::equations::{constraints_of, vanishes};
use crate::principles::hamilton::momenta;
use crate::principles::loads::generalised;
use symbolic::Sym;

/// Returns the speeds whose momenta dT/du are conserved, with these momenta.
pub fn kept_momenta(trace: &Trace<'_>) -> Vec<(usize, Sym)> {
    // mass that leaves a body carries momentum away
    if trace.varies() {
        return Vec::new();
    }
    let lagrangian = trace.kinetic_and_coenergy() - trace.potential_energy();
    let (forces, constraints) = (generalised(trace, false), constraints_of(trace));
    let is_cyclic = |i: &usize| {
        vanishes(trace.by_coordinate(lagrangian, *i))
            && vanishes(forces[*i])
            && constraints.iter().all(|constraint| vanishes(constraint.row[*i]))
    };
    let momenta = momenta(trace);
    // rotations of a free frame about its own axes do not commute
    let stays = |i: &usize| vanishes(trace.transposition(*i, |j| momenta[j]));
    (0..trace.speeds.len()).filter(is_cyclic).filter(stays).map(|i| (i, momenta[i])).collect()
}

pub(super) fn statements(trace: &Trace<'_>) -> Vec<Statement> {
    let cyclic = kept_momenta(trace);
    if cyclic.is_empty() {
        return Vec::new();
    }
    let (residual, constraints) = (residual(trace), constraints_of(trace));
    let lagrangian = trace.kinetic_and_coenergy() - trace.potential_energy();
    let of = |(i, momentum): (usize, Sym)| {
        let idle = constraints.iter().map(|constraint| (constraint.row[i], Sym::ZERO));
        let kept = [(trace.rate_of(momentum), residual[i])];
        let subject = format!("momentum of {}", trace.direction(i));
        let agreement = decided(trace, &subject, &kept.into_iter().chain(idle).collect::<Vec<_>>());
        let kinetic = if trace.model.energies.coenergy.is_some() { "d(T + W')" } else { "dT" };
        let says = piecewise(trace, &format!("({kinetic}/d{})' is zero", trace.speeds[i]));
        Statement { subject, says: while_inputs_rest(trace, &[lagrangian], says), agreement }
    };
    cyclic.into_iter().map(of).collect()
}
