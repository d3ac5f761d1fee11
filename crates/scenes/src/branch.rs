//! Constraints that follow from others: everywhere, or on the branch of the start alone, on which ranks are then judged.

use crate::readiness::{completed, leave_out, unmet_at};
use crate::start::{Completed, Unmet, consistent};
use crate::warnings::warn_of;
use model::equations::dependent_everywhere;
use model::{Fault, Model, Trace};
use reader::SceneError;

/// The model without the equations of constraints that follow from others on the branch of its start alone, where it has a start.
pub(crate) fn on_branch(model: &mut Model) {
    let Ok(mut completed) = completed(model) else { return };
    let everywhere = everywhere(model, &completed);
    completed.implied.retain(|of| !everywhere.contains(of));
    leave_out(model, &completed);
}

/// The equations of constraints that follow from others at a start and at every other one.
fn everywhere(model: &Model, Completed { implied, .. }: &Completed) -> Vec<[usize; 2]> {
    symbolic::apart(|| dependent_everywhere(&Trace::of(model), implied))
}

/// The model of a text, which messages call by a name, without the equations of constraints that follow from others: each is told by a warning. Those of one branch are
/// known where the file has a start that is met; a start that is not met leaves those that follow everywhere.
///
/// # Errors
/// Constraints that contradict each other.
pub(crate) fn without_implied((name, text): (&str, &str), model: &mut Model) -> Result<(), SceneError> {
    if let Err(unmet @ Unmet::Contradiction { .. }) = consistent(model) {
        return Err(SceneError { path: name.to_owned(), text: text.to_owned(), issues: vec![unmet_at(model, unmet)] });
    }
    let known = model.warnings.len();
    let found = completed(model).or_else(|_| {
        let mut guessed = model.clone();
        guessed.start.iter_mut().for_each(|value| value.is_guess = true);
        guessed.start_speeds.clear();
        completed(&guessed).map(|mut found| {
            found.implied = everywhere(model, &found);
            found
        })
    });
    if let Ok(found) = found {
        leave_out(model, &found);
    }
    warn_of(name, text, &model.warnings.split_off(known));
    Ok(())
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
    let with_unit = |unit: &str| if unit == "1" { String::new() } else { format!(" {unit}") };
    let told = all.map(|((name, unit), value)| format!("{name} = {}{}", short(*value), with_unit(&unit)));
    let mut words: Vec<String> = told.take(MOST_TOLD).collect();
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
