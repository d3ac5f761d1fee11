//! The model in a combination of cases: closed contacts without friction become constraints, and open contacts are removed.

use super::conditions::Case;
use crate::letters::Letters;
use model::equations::vanishes;
use model::{Contact, Model, Trace};
use std::borrow::Cow;

/// The model with the contacts in the states of a combination of cases; `None` if a contact with friction is closed.
pub fn with_kept_contacts<'a>(model: &'a Model, cases: &[Case]) -> Option<Cow<'a, Model>> {
    if model.contacts.is_empty() {
        return Some(Cow::Borrowed(model));
    }
    let touch: Vec<bool> = cases.get(model.switches.len()..)?.iter().map(|case| *case != Case::Holds).collect();
    let rubs = |(contact, touches): (&Contact, &bool)| *touches && has_friction(model, contact);
    if model.contacts.iter().zip(&touch).any(rubs) {
        return None;
    }
    model.with_kept_contacts(&touch).map(Cow::Owned)
}

/// The model without its outputs, which may have kinks but do not influence motions.
pub(super) fn without_outputs(model: &Model) -> Model {
    let mut without = model.clone();
    without.outputs.clear();
    without
}

/// Whether the coefficient of friction of a contact is not identically zero.
fn has_friction(model: &Model, contact: &Contact) -> bool {
    contact.friction.is_some_and(|friction| {
        symbolic::apart(|| {
            let trace = Trace::of(model);
            let state = [&trace.coordinates[..], &trace.speeds].concat();
            let own = Letters::with_decimals(trace.time, &state).put_into(&trace, &[trace.scalar(friction)]);
            !own.into_iter().all(vanishes)
        })
    })
}
