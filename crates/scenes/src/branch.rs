//! Removal of redundant constraints: equations that depend on the others everywhere, or only on the branch of configurations that
//! contains the start.

use crate::readiness::{completed, leave_out, unmet_at};
use crate::start::{Completed, Unmet, consistent};
use crate::warnings::warn_of;
use model::equations::dependent_everywhere;
use model::{Fault, Model, Trace};
use reader::SceneError;

/// Removes the equations that are redundant on the branch of the start but not everywhere. A model without a consistent start is
/// unchanged.
pub(crate) fn on_branch(model: &mut Model) {
    let Ok(mut completed) = completed(model) else { return };
    let everywhere = everywhere(model, &completed);
    completed.implied.retain(|of| !everywhere.contains(of));
    leave_out(model, &completed);
}

/// The equations among `implied`, as pairs of constraint and component, that are redundant at every configuration.
fn everywhere(model: &Model, Completed { implied, .. }: &Completed) -> Vec<[usize; 2]> {
    symbolic::apart(|| dependent_everywhere(&Trace::of(model), implied))
}

/// Removes redundant equations of constraints from the model of a file, and prints a warning for each. If the start of the file does not
/// satisfy the constraints, only equations that are redundant everywhere are removed. `name` is the name of the file in messages.
///
/// # Errors
/// Two constraints contradict each other.
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

/// Repeats the check that quasi-velocities determine the speeds, after the constraints that are redundant on the branch of the start are
/// removed.
///
/// # Errors
/// The quasi-velocities do not determine the speeds on this branch either.
pub(crate) fn settled(mut model: Model) -> Result<Model, Vec<Fault>> {
    if !model.unsettled.is_empty() {
        on_branch(&mut model);
        model.settle();
    }
    if model.unsettled.is_empty() { Ok(model) } else { Err(model.unsettled) }
}

/// A text with the first coordinates of a state, at most [`MOST_TOLD`], with their units: `x = 0.5 m, theta = 1.2 rad`.
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

/// The largest number of coordinates in a message.
const MOST_TOLD: usize = 6;

/// A number with four decimals, enough to distinguish branches.
fn short(value: f64) -> String {
    let rounded = (value * 1e4).round() / 1e4;
    if rounded == 0.0 { "0".to_owned() } else { format!("{rounded}") }
}
