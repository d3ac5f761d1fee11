//! A text with a system, as commands and programs that are handed a text ask for it.

use crate::branch::{on_branch, without_implied};
use crate::readiness::{start_of, starting};
use crate::scene::parse_titled;
use crate::size::Task;
use model::Model;
use reader::{SceneError, read_text};
use std::path::Path;

/// A text with `[coordinates]`, and what messages call it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SystemText {
    pub name: String,
    pub text: String,
}

impl SystemText {
    /// The text of a file.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        Ok(SystemText { name: path.display().to_string(), text: read_text(path)? })
    }

    /// Its system, without its run.
    ///
    /// # Errors
    /// All that is wrong with the system, each at its place.
    pub fn model(&self, task: Task) -> Result<Model, SceneError> {
        parse_titled(&self.name, &self.text, task).map(|(_, model)| model)
    }

    /// Its system as equations are written of it: without the equations of constraints that follow from others.
    ///
    /// # Errors
    /// All that is wrong with the system, and constraints that contradict each other.
    pub fn for_equations(&self) -> Result<Model, SceneError> {
        let mut model = self.model(Task::Write)?;
        without_implied(self, &mut model)?;
        Ok(model)
    }

    /// Its system as statements are judged of it: on the branch of its start.
    ///
    /// # Errors
    /// All that is wrong with the system, and constraints that contradict each other: then there is no motion of which anything could be
    /// said.
    pub fn for_judgement(&self) -> Result<Model, SceneError> {
        let mut model = self.model(Task::Write)?;
        without_implied(self, &mut model.clone())?;
        // off the branch the constraints leave other motions
        on_branch(&mut model);
        Ok(match start_of(&model) {
            Ok(state) => starting(&model, &state),
            Err(_) => model,
        })
    }
}
