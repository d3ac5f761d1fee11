//! Prescribed motions: expressions of the time, in the letters of a file.

use crate::scene::model;
use crate::warnings::warn_of;
use derivations::scene::file::{read_text, tables};
use derivations::scene::{Issue, SceneError};
use model::{Entry, Fault, Model, ScalarId, Text};
use std::path::Path;

/// Reads the system of a file with prescribed motions: coordinates by their names with expressions of the time, as the file could
/// have them. Each comes back as the place of its coordinate and its expression.
///
/// # Errors
/// All that is wrong with the system, and with the motions.
pub fn read_prescribed(
    path: &Path,
    motions: &[(String, String)],
) -> Result<(Model, Vec<(usize, ScalarId)>), SceneError> {
    let text = read_text(path)?;
    let behind = text.len();
    let name = path.display().to_string();
    tables(&name, &text, |top, issues| {
        top.known(&["title", "description", "run", "ensemble"]);
        let (own, mut source) = model(top, issues)?;
        let mut places: Vec<usize> = Vec::new();
        for (name, is) in motions {
            let place = own.coordinates.iter().position(|coordinate| coordinate.name == *name);
            let wrong = match place {
                None => Some("no coordinate has this name"),
                Some(place) if places.contains(&place) => Some("it is prescribed twice"),
                Some(_) => None,
            };
            match (wrong, place) {
                (None, Some(place)) => places.push(place),
                (wrong, _) => {
                    let issue =
                        Issue::at(0..0, format!("the motion of `{name}` is not accepted"), wrong.unwrap_or("here"));
                    let known: Vec<&str> = own.coordinates.iter().map(|coordinate| coordinate.name.as_str()).collect();
                    issues.push(issue.accepted(format!("a motion for each of: {}", known.join(", "))));
                }
            }
            // the sum has the dimension of the coordinate, or is refused
            let is = Text::at(format!("{is} + ({name} - {name})"), behind);
            source.outputs.push(Entry { name: Text::at(format!("the motion of {name}"), behind), value: is });
        }
        if places.len() < motions.len() {
            return None;
        }
        let told = |fault: Fault| {
            let issue = Issue::at(0..0, format!("a prescribed motion: {}", fault.title), fault.label);
            issue.accepted(fault.accepted)
        };
        warn_of(&name, &text, &own.warnings);
        let model = Model::of(&source).map_err(|faults| issues.extend(faults.into_iter().map(told))).ok()?;
        let first = model.outputs.len() - motions.len();
        let prescribed = places.into_iter().zip(&model.outputs[first..]).map(|(place, output)| (place, output.is));
        let prescribed = prescribed.collect();
        Some((model, prescribed))
    })
}
