//! The regimes of contacts and conditions at the start of a system.

use crate::admissible::impossible;
use crate::modes::{Modes, Regimes};
use crate::readiness::independent_start;
use crate::refused_start::not_started;
use model::Model;
use reader::Issue;
use std::sync::Arc;

/// All regimes of contacts and conditions that satisfy the equations at the start of a model. Its regulator is left out.
///
/// # Errors
/// If the start is not admissible, the law cannot be compiled, or the model has neither a contact nor a condition.
pub fn regimes(model: Model) -> Result<Regimes, Issue> {
    let mut model = Arc::new(model);
    if model.contacts.is_empty() && model.switches.is_empty() {
        let place = model.coordinates.first().map_or(0..0, |first| first.at.clone());
        let issue = Issue::at(
            place,
            "this system has one regime: it has no contact and no condition",
            "`regimes` needs a contact, a diode or a condition",
        );
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
