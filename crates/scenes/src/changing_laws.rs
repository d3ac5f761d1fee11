//! Models whose law or state changes at events along a run.

use model::{Event, Model};

/// True if the equations of motion or the state of a model can change during a run: at conditions, at events, or with contacts. Events
/// that only end the run do not count.
pub(crate) fn changes(model: &Model) -> bool {
    let is_end = |event: &Event| event.ends && event.set.is_empty();
    !(model.switches.is_empty() && model.contacts.is_empty() && model.events.iter().all(is_end))
}

/// True if a run must locate events, including events that only end the run.
pub(crate) fn is_watched(model: &Model) -> bool {
    changes(model) || !model.events.is_empty()
}
