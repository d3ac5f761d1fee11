//! Models whose law or state changes at events along a run.

use model::{Event, Model};

/// Whether the law of a model, or its state, changes at conditions, at events or with its contacts. An event that ends the run, and sets
/// nothing, changes neither.
pub(crate) fn changes(model: &Model) -> bool {
    let is_end = |event: &Event| event.ends && event.set.is_empty();
    !(model.switches.is_empty() && model.contacts.is_empty() && model.events.iter().all(is_end))
}

/// Whether a run watches for events, be it for its end alone.
pub(crate) fn is_watched(model: &Model) -> bool {
    changes(model) || !model.events.is_empty()
}
