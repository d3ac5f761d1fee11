//! The model of a file: elaborated from its tables, or from those of the named system.

use super::ModelScene;
use crate::branch::settled;
use crate::named_systems;
use crate::text;
use model::{Entry, Model, Source};
use reader::{Issue, Table, tables};
use std::ops::Range;
use std::sync::Arc;

/// The model of a file and the source that it was elaborated from; faults are added to `issues`.
pub(crate) fn model(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<(Model, Source)> {
    model_with(top, issues, Vec::new())
}

/// The model of a file with additional outputs, and its source; faults are added to `issues`.
pub(crate) fn model_with(top: &mut Table<'_>, issues: &mut Vec<Issue>, outputs: Vec<Entry>) -> Option<(Model, Source)> {
    let mut source = named_systems::source(top, issues)?;
    source.outputs.extend(outputs);
    let faults = match Model::of(&source).and_then(settled) {
        // without the unreadable parts of a table the model is incomplete
        Ok(model) => return (!top.has_issues()).then_some((model, source)),
        Err(faults) => faults,
    };
    // faults may result from unreadable parts, which are reported already
    if !top.has_issues() && !text::has_unknown_tables(top) {
        issues.extend(faults.into_iter().map(text::issue));
    }
    None
}

/// The model of a text; `None` if the text has faults.
pub(crate) fn written(text: &str) -> Option<Model> {
    let read = tables("", text, |top, issues| {
        top.known(&["title", "description", "known_as", "run", "ensemble", "failure"]);
        model(top, issues).map(|(model, _)| model)
    });
    read.ok()
}

impl ModelScene {
    /// The scene with another source of its file and with the lines of those conditions that remain from `whole`.
    pub(crate) fn of_source(self, source: Source, whole: &Self) -> Self {
        let line_of = |place: &Range<usize>| {
            let known = whole.model.switch_places.iter().position(|known| known == place);
            known.and_then(|known| whole.condition_lines.get(known).copied()).unwrap_or_default()
        };
        let condition_lines = self.model.switch_places.iter().map(line_of).collect();
        ModelScene { source: Arc::new(source), condition_lines, ..self }
    }
}
