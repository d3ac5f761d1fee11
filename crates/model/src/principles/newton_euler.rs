//! The Newton-Euler equations of every body with its joint loads, and with the reactions of constraints at their points of action.
//!
//! The joint loads have no power on the motions that the joints admit. Subtraction of the generalised reactions J^T lambda gives the residual;
//! the multipliers cancel if every reaction acts according to its constraint.

use super::loads::by_energies;
use crate::Trace;
use crate::equations::constraints_of;
use symbolic::Sym;

pub(super) fn residual(trace: &Trace<'_>) -> Vec<Sym> {
    let constraints = constraints_of(trace);
    let of = |(i, loads): (usize, Sym)| {
        let reaction =
            constraints.iter().fold(Sym::ZERO, |sum, constraint| sum + constraint.multiplier * constraint.row[i]);
        loads + reaction + by_energies(trace, i) + trace.induced(i)
    };
    trace.joints().residual().into_iter().enumerate().map(of).collect()
}
