//! A text with a system, for commands and programs that work on texts.

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

/// A text with `[coordinates]`, and its name in messages.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemText {
    pub name: String,
    pub text: String,
    /// Values of parameters, and of coordinates and speeds at the start, in SI units, which replace those of the text.
    pub values: Vec<(String, f64)>,
}

impl SystemText {
    /// The text of a file.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        Ok(SystemText { name: path.display().to_string(), text: read_text(path)?, values: Vec::new() })
    }

    /// The system, without its run.
    ///
    /// # Errors
    /// All that is wrong with the system, each at its place.
    pub fn model(&self, task: Task) -> Result<Model, SceneError> {
        let (_, model) = parse_titled(&self.name, &self.text, task)?;
        self.with_its_values(model)
    }

    /// A model with the replaced values.
    ///
    /// # Errors
    /// A name that it does not know, and bodies that cannot exist with these values.
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

    /// A fault of the system, at its place in this text.
    pub fn with_issue(&self, issue: Issue) -> SceneError {
        SceneError { path: self.name.clone(), text: self.text.clone(), issues: vec![issue] }
    }

    /// Checks the table [run], where the text has one, for tasks that need no run.
    ///
    /// # Errors
    /// All that is wrong with it, each at its place.
    pub fn check_run(&self, model: &Model) -> Result<(), SceneError> {
        let names = columns(model);
        // outputs of a scene with a law of its own have the names of that
        let known = (holds_model(&self.text) || !has_model(&self.text)).then_some(names.as_slice());
        tables(&self.name, &self.text, |top, issues| {
            top.known_all();
            let is_sound = !top.has("run") || run::read(top, issues, known).is_some();
            is_sound.then_some(())
        })
    }

    /// The system for printing equations: without the equations of redundant constraints.
    ///
    /// # Errors
    /// All that is wrong with the system, and constraints that contradict each other.
    pub fn for_equations(&self) -> Result<Model, SceneError> {
        let mut model = self.model(Task::Write)?;
        without_implied((&self.name, &self.text), &mut model)?;
        Ok(model)
    }

    /// The system for judging statements: on the branch of its start.
    ///
    /// # Errors
    /// All that is wrong with the system, and constraints that contradict each other: then there is no motion of which anything could be
    /// said.
    pub fn for_judgement(&self) -> Result<Model, SceneError> {
        self.for_judgement_with(Vec::new())
    }

    /// The system for judging statements, with further outputs: the quantities of the statements.
    ///
    /// # Errors
    /// All faults of the system and of these outputs, and constraints that contradict each other.
    pub fn for_judgement_with(&self, outputs: Vec<Entry>) -> Result<Model, SceneError> {
        let (_, model, _) = parse_with(&self.name, &self.text, Task::Write, outputs)?;
        let mut model = self.with_its_values(model)?;
        without_implied((&self.name, &self.text), &mut model.clone())?;
        // off the branch the constraints leave other motions
        on_branch(&mut model);
        Ok(match start_of(&model) {
            Ok(state) => starting(&model, &state),
            Err(_) => model,
        })
    }
}

/// Reads the system of a file without its run, for tasks that need neither values nor a run.
///
/// # Errors
/// All that is wrong with the system, each at its place.
pub fn read_model(path: &Path, task: Task) -> Result<Model, SceneError> {
    read_titled(path, task).map(|(_, model)| model)
}

/// Reads the system of a file without its run, with the title, which may be empty.
///
/// # Errors
/// All that is wrong with the system, each at its place.
pub fn read_titled(path: &Path, task: Task) -> Result<(String, Model), SceneError> {
    parse_titled(&path.display().to_string(), &read_text(path)?, task)
}

/// The same of a text; `name` is what messages call it.
///
/// # Errors
/// All that is wrong with the system, each at its place.
pub fn parse_titled(name: &str, text: &str, task: Task) -> Result<(String, Model), SceneError> {
    parse_with(name, text, task, Vec::new()).map(|(title, model, _)| (title, model))
}

/// The title, the model and the source of a system.
type Read = (String, Model, Source);

/// Reads the title, the model and the source of a file.
///
/// # Errors
/// All that is wrong with the system, each at its place.
pub fn read_with_source(path: &Path, task: Task) -> Result<Read, SceneError> {
    parse_with_source(&path.display().to_string(), &read_text(path)?, task)
}

/// The same of a text; `name` is what messages call it.
///
/// # Errors
/// All that is wrong with the system, each at its place.
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

/// Gives parameters, coordinates and speeds at the start other values, in SI units.
///
/// # Errors
/// The name of nothing that has such a value, or why there is no such system.
pub fn set_values(model: &mut Model, values: &[(String, f64)]) -> Result<(), String> {
    model.set_values(values)?;
    impossible(model).into_iter().next().map_or(Ok(()), |issue| Err(issue.title))
}

/// Coordinates and speeds at the start of a file that were left out or guessed, and that constraints or an equilibrium have moved, with
/// their values in SI units; none of a file that holds no such system.
pub fn completed_start(path: &Path) -> Vec<(String, f64)> {
    read_text(path).map_or_else(|_| Vec::new(), |text| completed_start_of(&text))
}

/// The values of a text's start that were left out or guessed, and that constraints or an equilibrium have moved.
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
    // a component below the rounding of others of its kind is zero
    let shown = |(place, (name, (&now, written))): (usize, (String, (&f64, f64)))| {
        let rounding = rounding[usize::from(place >= positions)];
        let now = if now.abs() <= rounding { 0.0 } else { now };
        (now != written).then_some((name, now))
    };
    moved.filter_map(shown).collect()
}
