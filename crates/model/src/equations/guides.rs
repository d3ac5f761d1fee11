//! The force balance across a guide that the coordinates satisfy identically: the equation of motion of the released system along its additional coordinate.

use super::constraints::equations;
use crate::Trace;
use crate::principles::Principle;
use symbolic::{Sym, substitute_all};

/// Returns, for each contact, the expression that the reaction of such a guide must make zero; `None` for other contacts.
pub fn balances(trace: &Trace<'_>) -> Vec<Option<Sym>> {
    let none = || vec![None; trace.model.contacts.len()];
    let Some(released) = &trace.model.released else { return none() };
    let free = Trace::of(released);
    let Ok(residual) = Principle::VirtualPower.residual(&free) else { return none() };
    let constraints = equations(&free);
    let own: Vec<usize> = trace.model.contacts.iter().filter_map(|contact| contact.guide).collect();
    let at_rest = own.iter().flat_map(|&k| [free.coordinates[k], free.speeds[k], free.accelerations[k]]);
    let implied = trace.model.implied.iter().map(|implied| (Trace::multiplier(implied.of), Sym::ZERO));
    let at_rest: Vec<(Sym, Sym)> = at_rest.map(|letter| (letter, Sym::ZERO)).chain(implied).collect();
    let balance = |k: usize| {
        let reactions = constraints.iter().map(|one| one.multiplier * one.row[k]);
        reactions.fold(residual[k], |sum, part| sum - part)
    };
    let of = |contact: &crate::Contact| {
        let balance = balance(contact.guide?);
        substitute_all(&[balance], &at_rest).first().copied()
    };
    trace.model.contacts.iter().map(of).collect()
}
