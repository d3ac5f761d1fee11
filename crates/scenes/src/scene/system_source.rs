//! The system of a file: its tables, or those of the system that it names, as a model.

use crate::branch::settled;
use crate::named_systems;
use crate::text;
use model::{Entry, Model, Source};
use reader::{Issue, Table, tables};

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
