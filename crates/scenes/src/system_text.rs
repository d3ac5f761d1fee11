//! The text of a system, for commands and programs that need a model without a run.

use crate::admissible::impossible;
use crate::branch::{on_branch, without_implied};
use crate::known_as::known;
use crate::quoted_keys::with_quoted_primes;
use crate::readiness::{start_of, starting};
use crate::row_units::columns;
use crate::scene::{KNOWN_AS, TITLE, VALUES, model_with, written};
use crate::size::{Task, too_large};
use crate::text::OF_PAPERS;
use crate::warnings::warn_of;
use model::{Entry, Model, Source};
use reader::{Issue, SceneError, read_text, tables};
use simulation::models::{has_model, holds_model};
use simulation::run;
use std::path::Path;

/// A text with the table `[coordinates]`, and its name in messages.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemText {
    /// The name of the text in messages, such as the path of its file.
    pub name: String,
    /// The text in TOML.
    pub text: String,
    /// Values, in SI units, that replace those of the text: of parameters, and of coordinates and speeds at the start.
    pub values: Vec<(String, f64)>,
}

impl SystemText {
    /// Reads the text of a file.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        Ok(SystemText { name: path.display().to_string(), text: read_text(path)?, values: Vec::new() })
    }

    /// The model of the text, with the replaced values.
    ///
    /// # Errors
    /// All faults of the system, each with its place; also a system that is too large for the task.
    pub fn model(&self, task: Task) -> Result<Model, SceneError> {
        let (_, model) = parse_titled(&self.name, &self.text, task)?;
        self.with_its_values(model)
    }

    /// A model with the replaced values of this text.
    ///
    /// # Errors
    /// If a name is unknown, or masses and moments of inertia are impossible with these values.
    pub fn with_its_values(&self, mut model: Model) -> Result<Model, SceneError> {
        if self.values.is_empty() {
            return Ok(model);
        }
        model.set_values(&self.values).map_err(|why| SceneError::whole(&self.name, why, VALUES))?;
        let issues = impossible(&model);
        if issues.is_empty() {
            return Ok(model);
        }
        Err(SceneError { path: self.name.clone(), text: self.text.clone(), issues })
    }

    /// A fault of the system, as an error that refers to this text.
    pub fn with_issue(&self, issue: Issue) -> SceneError {
        SceneError { path: self.name.clone(), text: self.text.clone(), issues: vec![issue] }
    }

    /// Checks the table `[run]` of the text, for tasks that do not run it.
    ///
    /// # Errors
    /// All faults of the table, each with its place.
    pub fn check_run(&self, model: &Model) -> Result<(), SceneError> {
        let names = columns(model);
        // `[run]` of a scene with a built-in law refers to the outputs of that law, which are not known here
        let known = (holds_model(&self.text) || !has_model(&self.text)).then_some(names.as_slice());
        tables(&self.name, &self.text, |top, issues| {
            top.known_all();
            let is_sound = !top.has("run") || run::read(top, issues, known).is_some();
            is_sound.then_some(())
        })
    }

    /// The model for printing equations, without the equations of redundant constraints.
    ///
    /// # Errors
    /// All faults of the system, and contradictory constraints.
    pub fn for_equations(&self) -> Result<Model, SceneError> {
        let mut model = self.model(Task::Write)?;
        without_implied((&self.name, &self.text), &mut model)?;
        Ok(model)
    }

    /// The model for judging statements, on the branch of its start.
    ///
    /// # Errors
    /// All faults of the system, and contradictory constraints: there is no motion then, and every statement would be true.
    pub fn for_judgement(&self) -> Result<Model, SceneError> {
        self.for_judgement_with(Vec::new())
    }

    /// The model for judging statements, with the quantities of the statements as additional outputs.
    ///
    /// # Errors
    /// All faults of the system and of these outputs, and contradictory constraints.
    pub fn for_judgement_with(&self, outputs: Vec<Entry>) -> Result<Model, SceneError> {
        let (_, model, _) = parse_with(&self.name, &self.text, Task::Write, outputs)?;
        let mut model = self.with_its_values(model)?;
        without_implied((&self.name, &self.text), &mut model.clone())?;
        // on another branch, constraints may allow other motions
        on_branch(&mut model);
        Ok(match start_of(&model) {
            Ok(state) => starting(&model, &state),
            Err(_) => model,
        })
    }
}

/// The model of a file, without its run.
///
/// # Errors
/// All faults of the system, each with its place; also a system that is too large for the task.
pub fn read_model(path: &Path, task: Task) -> Result<Model, SceneError> {
    read_titled(path, task).map(|(_, model)| model)
}

/// The title of a file, which may be empty, and its model.
///
/// # Errors
/// As for [`read_model`].
pub fn read_titled(path: &Path, task: Task) -> Result<(String, Model), SceneError> {
    parse_titled(&path.display().to_string(), &read_text(path)?, task)
}

/// The title of a text, which may be empty, and its model; messages refer to the text as `name`.
///
/// # Errors
/// As for [`read_model`].
pub fn parse_titled(name: &str, text: &str, task: Task) -> Result<(String, Model), SceneError> {
    parse_with(name, text, task, Vec::new()).map(|(title, model, _)| (title, model))
}

/// Title, model and source of a system.
type Read = (String, Model, Source);

/// The title, the model and the source of a file.
///
/// # Errors
/// As for [`read_model`].
pub fn read_with_source(path: &Path, task: Task) -> Result<Read, SceneError> {
    parse_with_source(&path.display().to_string(), &read_text(path)?, task)
}

/// The title, the model and the source of a text; messages refer to it as `name`.
///
/// # Errors
/// As for [`read_model`].
pub fn parse_with_source(name: &str, text: &str, task: Task) -> Result<Read, SceneError> {
    parse_with(name, text, task, Vec::new())
}

fn parse_with(name: &str, text: &str, task: Task, outputs: Vec<Entry>) -> Result<Read, SceneError> {
    let read = tables(name, text, |top, issues| {
        top.known(&["description", "run", "ensemble", "failure"]);
        if top.has("letters") || top.has("claim") {
            top.known(&OF_PAPERS);
        }
        if let Some(name) = top.optional_text("known_as", KNOWN_AS)
            && let Err(issue) = known(&name)
        {
            top.report(issue);
        }
        let title = top.optional_text("title", TITLE).map_or_else(String::new, |title| title.value);
        let (model, source) = model_with(top, issues, outputs)?;
        let large = too_large(&model, task);
        issues.extend(large.clone());
        let bodies = impossible(&model);
        let exist = bodies.is_empty();
        issues.extend(bodies);
        (exist && large.is_none()).then_some((title.split_whitespace().collect::<Vec<_>>().join(" "), model, source))
    });
    let (title, model, source) = read.map_err(with_quoted_primes)?;
    warn_of(name, text, &model.warnings);
    Ok((title, model, source))
}

/// Changes values of parameters, and of coordinates and speeds at the start, by name and in SI units.
///
/// # Errors
/// If a name is unknown, or masses and moments of inertia are impossible with these values; as a text.
pub fn set_values(model: &mut Model, values: &[(String, f64)]) -> Result<(), String> {
    model.set_values(values)?;
    impossible(model).into_iter().next().map_or(Ok(()), |issue| Err(issue.title))
}

/// The components of a file's start that were left out or guessed and were changed to satisfy constraints or an equilibrium: names and values in
/// SI units. Empty for a file without a system, or without a valid start.
pub fn completed_start(path: &Path) -> Vec<(String, f64)> {
    read_text(path).map_or_else(|_| Vec::new(), |text| completed_start_of(&text))
}

/// The components of a text's start that were changed in this way, as [`completed_start`].
pub fn completed_start_of(text: &str) -> Vec<(String, f64)> {
    if !holds_model(text) {
        return Vec::new();
    }
    let Some(model) = written(text) else { return Vec::new() };
    let Ok(start) = start_of(&model) else { return Vec::new() };
    let names = model.state_names().into_iter().map(|(name, _)| name);
    let positions = model.positions();
    let largest = |parts: &[f64]| parts.iter().fold(0.0, |largest: f64, part| largest.max(part.abs()));
    let rounding = [&start[..positions], &start[positions..]].map(|parts| f64::EPSILON * largest(parts));
    let moved = names.zip(start.iter().zip(model.start_state())).enumerate();
    // a component below the rounding errors of the others counts as zero
    let shown = |(place, (name, (&now, written))): (usize, (String, (&f64, f64)))| {
        let rounding = rounding[usize::from(place >= positions)];
        let now = if now.abs() <= rounding { 0.0 } else { now };
        (now != written).then_some((name, now))
    };
    moved.filter_map(shown).collect()
}
