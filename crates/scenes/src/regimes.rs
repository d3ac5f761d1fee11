//! The regimes of contacts and conditions at the start of a system.

use crate::admissible::impossible;
use crate::modes::{Modes, Regimes};
use crate::readiness::independent_start;
use crate::refused_start::not_started;
use model::Model;
use reader::Issue;
use std::sync::Arc;

/// The regimes of a model at its start, without its regulator.
///
/// # Errors
/// The reason for which the model cannot be at its start, or has no regimes, at its place in the file.
pub fn regimes(model: Model) -> Result<Regimes, Issue> {
    let mut model = Arc::new(model);
    if model.contacts.is_empty() && model.switches.is_empty() {
        let place = model.coordinates.first().map_or(0..0, |first| first.at.clone());
        let issue =
            Issue::at(place, "this system has one regime: it has no contact and no condition", "it moves by one law");
        return Err(issue.accepted(
            "[[contact]], [[diode]], [[freewheel]], or an expression with `if`, `sign`, `abs`, `min`, `max` or `table`",
        ));
    }
    if let Some(issue) = impossible(&model).into_iter().next() {
        return Err(issue);
    }
    Arc::make_mut(&mut model).close_regulated_inputs();
    let start = independent_start(Arc::make_mut(&mut model))?;
    Modes::of(&model, &[], &[]).regimes(0.0, &start).map_err(|why| not_started(&model, why))
}
