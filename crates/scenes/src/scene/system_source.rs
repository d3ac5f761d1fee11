//! The system of a file: its tables, or those of the system that it names, as a model.

use super::ModelScene;
use crate::branch::settled;
use crate::named_systems;
use crate::text;
use model::{Entry, Model, Source};
use reader::{Issue, Table, tables};
use std::ops::Range;
use std::sync::Arc;

/// The system of a file with its source; its faults are added to the list of issues.
pub(crate) fn model(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<(Model, Source)> {
    model_with(top, issues, Vec::new())
}

/// The system of a file with its source and with further outputs.
pub(crate) fn model_with(top: &mut Table<'_>, issues: &mut Vec<Issue>, outputs: Vec<Entry>) -> Option<(Model, Source)> {
    let mut source = named_systems::source(top, issues)?;
    source.outputs.extend(outputs);
    let faults = match Model::of(&source).and_then(settled) {
        // a table with unreadable parts gives an incomplete model
        Ok(model) => return (!top.has_issues()).then_some((model, source)),
        Err(faults) => faults,
    };
    // unreadable parts may be the cause of these faults, and are reported already
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
