//! The section of the report on scenes that could not be read, with their faulty lines.

use charts::{Study, Table};
use reader::{Issue, SceneError};

/// The section on unread scenes; `None` where all were read.
pub fn study(unread: &[SceneError]) -> Option<Study> {
    (!unread.is_empty()).then(|| Study {
        id: "unread".into(),
        title: "Scenes that could not be read".into(),
        lead: "The report goes on without these files. `dalembert run FILE` shows each fault with its line.".into(),
        tables: vec![Table {
            caption: String::new(),
            head: ["File", "Line", "What is wrong", "What is accepted"].map(String::from).into(),
            rows: unread.iter().flat_map(rows).collect(),
        }],
        ..Study::default()
    })
}

fn rows(error: &SceneError) -> impl Iterator<Item = Vec<String>> {
    error.issues.iter().map(|issue| {
        let Issue { title, help, .. } = issue;
        vec![error.path.clone(), line(error, issue), title.clone(), help.clone().unwrap_or_default()]
    })
}

/// The number of a faulty line, counted from 1; empty where the fault concerns the whole file.
fn line(error: &SceneError, issue: &Issue) -> String {
    issue.span.as_ref().map_or_else(String::new, |span| {
        let before = error.text.bytes().take(span.start);
        (1 + before.filter(|byte| *byte == b'\n').count()).to_string()
    })
}
