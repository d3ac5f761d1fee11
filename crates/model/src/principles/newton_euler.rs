//! Newton's and Euler's equations of every body with the loads of its joints, and with the reactions of constraints where they act.
//!
//! The loads do no work on the motions that joints admit. Less the generalised reactions J^T lambda they give the residual:
//! multipliers drop out of it where every reaction acts as its constraint says.

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
