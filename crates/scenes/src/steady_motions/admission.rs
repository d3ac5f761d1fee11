//! Models for which the search of steady motions is supported, and the combinations of cases of their conditions and contacts.

use super::conditions::{self, Case};
use super::determinacy::Wanted;
use super::quasi_velocities::state_names;
use super::rows::{Rows, Touching};
use super::{NoSteadyMotions, SteadySearch};
use crate::compiled_system::has_values;
use model::equations::vanishes;
use model::{Contact, Model, Trace};
use symbolic::Sym;

/// The combinations of cases of a law's conditions and contacts that are searched.
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
        // a gap that is identically zero leaves its reaction undetermined
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

/// Refuses laws that change at conditions or contacts, and models that are not supported.
pub(super) fn checked(model: &Model) -> Result<(), NoSteadyMotions> {
    checked_but_for_conditions(model)?;
    // an event changes only the state, not the law
    let is_one = model.switches.is_empty() && model.contacts.is_empty();
    if is_one { Ok(()) } else { Err(NoSteadyMotions::Changes) }
}

/// Refuses contacts, and models that are not supported; conditions are accepted.
pub(super) fn checked_but_for_cases(model: &Model) -> Result<(), NoSteadyMotions> {
    checked_but_for_conditions(model)?;
    if model.contacts.is_empty() { Ok(()) } else { Err(NoSteadyMotions::Changes) }
}

/// Refuses algebraic speeds, free frames and models with missing values.
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

/// The speeds of coordinates that are not cyclic, each with the value zero of steady motion.
pub(super) fn at_rest(trace: &Trace<'_>, is_cyclic: &[bool]) -> Vec<(Sym, Sym)> {
    let rests = trace.speeds.iter().zip(is_cyclic).filter(|(_, cyclic)| !**cyclic);
    rests.map(|(speed, _)| (*speed, Sym::ZERO)).collect()
}
