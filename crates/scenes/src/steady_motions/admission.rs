//! Models whose steady motions are sought, and the combinations of cases of a law that changes.

use super::conditions::{self, Case};
use super::determinacy::Wanted;
use super::quasi_velocities::state_names;
use super::rows::{Rows, Touching};
use super::{NoSteadyMotions, SteadySearch};
use crate::compiled_system::has_values;
use model::equations::vanishes;
use model::{Contact, Model, Trace};
use symbolic::Sym;

/// The combinations of cases of the conditions of a law.
pub(super) fn combinations(model: &Model, asked: &SteadySearch) -> Result<Vec<Vec<Case>>, NoSteadyMotions> {
    let is_refused = |one: &&Contact| one.one_way.is_some() || one.guide.is_some();
    if let Some(contact) = model.contacts.iter().find(is_refused) {
        return Err(NoSteadyMotions::Contacts { at: contact.at.clone() });
    }
    checked_but_for_conditions(model)?;
    symbolic::apart(|| {
        let trace = Trace::of(model);
        let start = model.start_state();
        let (names, n) = (state_names(model), trace.speeds.len());
        let free = (0..n).filter(|&k| asked.range(&names[n + k]).is_some()).collect();
        let rows = Rows::of(model, &trace, &Wanted { free, state: &start, is_near: false })?;
        // a gap that no coordinate opens has a reaction that no position determines
        let gaps = &rows.conditions[rows.condition_letters.len()..];
        if let Some(place) = gaps.iter().position(|gap| vanishes(*gap)) {
            return Err(NoSteadyMotions::Contacts { at: model.contacts[place].at.clone() });
        }
        let rest = at_rest(&trace, &rows.is_cyclic);
        let is_refused = |own: &Touching| own.may_slide(&rest) && (own.slides.len() > 1 || !own.is_one_sided);
        if let Some(place) = rows.contacts.iter().position(is_refused) {
            return Err(NoSteadyMotions::Contacts { at: model.contacts[place].at.clone() });
        }
        conditions::combinations(&rows, &at_rest(&trace, &rows.is_cyclic))
    })
}

/// Refuses a law that changes, and everything that no law may hold.
pub(super) fn checked(model: &Model) -> Result<(), NoSteadyMotions> {
    checked_but_for_conditions(model)?;
    // an event changes the state alone: between events the law is one
    let is_one = model.switches.is_empty() && model.contacts.is_empty();
    if is_one { Ok(()) } else { Err(NoSteadyMotions::Changes) }
}

/// Refuses contacts, and everything that no law may hold.
pub(super) fn checked_but_for_cases(model: &Model) -> Result<(), NoSteadyMotions> {
    checked_but_for_conditions(model)?;
    if model.contacts.is_empty() { Ok(()) } else { Err(NoSteadyMotions::Changes) }
}

/// Refuses speeds without inertia, frames that turn freely, and laws without values.
fn checked_but_for_conditions(model: &Model) -> Result<(), NoSteadyMotions> {
    has_values(model).map_err(NoSteadyMotions::NotCompiled)?;
    if !model.algebraic_speeds.is_empty() {
        return Err(NoSteadyMotions::Changes);
    }
    if model.positions() != model.speeds() {
        return Err(NoSteadyMotions::FreeFrame { why: "no angles place it".to_owned() });
    }
    Ok(())
}

/// Speeds that are zero where only cyclic coordinates move.
pub(super) fn at_rest(trace: &Trace<'_>, is_cyclic: &[bool]) -> Vec<(Sym, Sym)> {
    let rests = trace.speeds.iter().zip(is_cyclic).filter(|(_, cyclic)| !**cyclic);
    rests.map(|(speed, _)| (*speed, Sym::ZERO)).collect()
}
