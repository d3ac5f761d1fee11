//! The key `known_as`: a system of which some crate knows more than its equations.

use model::Model;
use reader::{At, Issue};
use simulation::knowledge::{self, Knowledge};
use units::nearest;

/// The knowledge of a name; an issue where there is none, or where the model has other letters. A row of its runs has these columns.
pub(crate) fn asked_for(
    model: &Model,
    columns: &[String],
    name: &At<String>,
    issues: &mut Vec<Issue>,
) -> Option<&'static Knowledge> {
    let entries = knowledge::entries();
    let At { value, span } = name;
    let Some(found) = entries.iter().find(|entry| entry.name == *value) else {
        let list = entries.iter().map(|entry| entry.name).collect::<Vec<_>>().join(", ");
        let accepted = match nearest(value, entries.iter().map(|entry| entry.name)) {
            Some(nearest) => format!("is `{nearest}` meant? Known: {list}"),
            None if list.is_empty() => "a file without `known_as`: this program knows no more of any system".to_owned(),
            None => format!("known: {list}"),
        };
        let title = format!("no system is known as `{value}`");
        issues.push(Issue::at(span.clone(), title, "not known").accepted(accepted));
        return None;
    };
    let has_value = |name: &str| model.parameters.iter().any(|one| one.name == name && one.value.is_some());
    let parameters =
        found.parameters.iter().filter(|name| !has_value(name)).map(|name| (name, "parameter with a value"));
    let read = found.columns.iter().filter(|name| !columns.iter().any(|own| own == *name));
    let mut missing = parameters.chain(read.map(|name| (name, "coordinate, speed or output")));
    let Some((name, what)) = missing.next() else { return Some(found) };
    let title = format!("`{value}` is a system with `{name}`, which is no {what} here");
    let letters = found.parameters.iter().chain(found.columns).copied().collect::<Vec<_>>().join(", ");
    let issue = Issue::at(span.clone(), title, found.summary);
    issues.push(issue.accepted(format!("a system with {letters}; without `known_as` any names are accepted")));
    None
}
