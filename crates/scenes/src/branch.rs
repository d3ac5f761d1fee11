//! Constraints that follow from others: everywhere, or on the branch of the start alone, on which ranks are then judged.

use crate::readiness::{completed, leave_out};
use model::equations::dependent_everywhere;
use model::{Fault, Model, Trace};

/// The model without the equations of constraints that follow from others on the branch of its start alone, where it has a start.
pub fn on_branch(model: &mut Model) {
    let Ok(mut completed) = completed(model) else { return };
    let everywhere = symbolic::apart(|| dependent_everywhere(&Trace::of(model), &completed.implied));
    completed.implied.retain(|of| !everywhere.contains(of));
    leave_out(model, &completed);
}

/// Judges quasi-velocities on the branch of the start, where they do not determine the speeds at a general point.
pub(crate) fn settled(mut model: Model) -> Result<Model, Vec<Fault>> {
    if !model.unsettled.is_empty() {
        on_branch(&mut model);
        model.settle();
    }
    if model.unsettled.is_empty() { Ok(model) } else { Err(model.unsettled) }
}

/// The first coordinates of a state with their units.
pub(crate) fn in_words(model: &Model, state: &[f64]) -> String {
    let all = model.state_names().into_iter().zip(state).take(model.positions());
    let mut words: Vec<String> =
        all.map(|((name, unit), value)| format!("{name} = {} {unit}", short(*value))).take(MOST_TOLD).collect();
    if model.positions() > MOST_TOLD {
        words.push("...".to_owned());
    }
    words.join(", ")
}

/// Coordinates that a sentence tells.
const MOST_TOLD: usize = 6;

/// A number to some digits: it tells branches apart.
fn short(value: f64) -> String {
    let rounded = (value * 1e4).round() / 1e4;
    if rounded == 0.0 { "0".to_owned() } else { format!("{rounded}") }
}
