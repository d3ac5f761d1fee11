//! The system of a file: its tables, or those of the system that it names, as a model.

use super::ModelScene;
use crate::branch::settled;
use crate::named_systems;
use crate::text;
use model::{Entry, Model, Source};
use reader::{Issue, Table, tables};
use std::ops::Range;
use std::sync::Arc;

/// The system of a file with its source; what is wrong with it goes into the list.
pub(crate) fn model(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<(Model, Source)> {
    model_with(top, issues, Vec::new())
}

/// The same with more outputs.
pub(crate) fn model_with(top: &mut Table<'_>, issues: &mut Vec<Issue>, outputs: Vec<Entry>) -> Option<(Model, Source)> {
    let mut source = named_systems::source(top, issues)?;
    source.outputs.extend(outputs);
    let faults = match Model::of(&source).and_then(settled) {
        // what could not be read is missing in it
        Ok(model) => return (!top.has_issues()).then_some((model, source)),
        Err(faults) => faults,
    };
    // what could not be read explains what is missing
    if !top.has_issues() && !text::has_unknown_tables(top) {
        issues.extend(faults.into_iter().map(text::issue));
    }
    None
}

/// The model of a text; none where it cannot be read.
pub(crate) fn written(text: &str) -> Option<Model> {
    let read = tables("", text, |top, issues| {
        top.known(&["title", "description", "known_as", "run", "ensemble", "failure"]);
        model(top, issues).map(|(model, _)| model)
    });
    read.ok()
}

impl ModelScene {
    /// The scene of a model that was elaborated from another source of the same file, with the lines of its conditions.
    pub(crate) fn of_source(self, source: Source, whole: &Self) -> Self {
        let line_of = |place: &Range<usize>| {
            let known = whole.model.switch_places.iter().position(|known| known == place);
            known.and_then(|known| whole.condition_lines.get(known).copied()).unwrap_or_default()
        };
        let condition_lines = self.model.switch_places.iter().map(line_of).collect();
        ModelScene { source: Arc::new(source), condition_lines, ..self }
    }
}
