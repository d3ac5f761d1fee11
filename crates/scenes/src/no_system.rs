//! The error of a file that defines no system, with the two ways to define one.

use crate::text::is_of_system;
use reader::{Issue, SceneError, tables};

/// The keys that define a system; a file needs one of them.
const WAYS: [&str; 2] = ["coordinates", "system"];

/// The titles of the faults of a file without a system, in any command.
const TITLES: [&str; 2] = ["`system` is missing", "the system has no coordinates"];

/// Replaces all faults of a file without a system by a single one that says how to define a system. Other errors are returned unchanged.
pub fn with_ways_to_a_system(error: SceneError) -> SceneError {
    if !error.issues.iter().any(|issue| TITLES.contains(&issue.title.as_str())) {
        return error;
    }
    let keys = tables(&error.path, &error.text, |top, _| {
        top.known_all();
        Some(top.keys())
    });
    let Ok(keys) = keys else { return error };
    if keys.iter().any(|key| WAYS.contains(&key.value.as_str())) {
        return error;
    }
    let has = |name: &str| keys.iter().find(|key| key.value == name);
    if let (Some(model), Some(_)) = (has("model"), has("claim")) {
        let title = "this file is a paper: its system is in the file that `model` names";
        let issue = Issue::at(model.span.clone(), title, "the system")
            .accepted("that file; `judge` and `watch` take the paper");
        return SceneError { issues: vec![issue], ..error };
    }
    let misspelt = keys.iter().find_map(|key| Some((key, units::nearest(&key.value, WAYS)?)));
    let misspelt = misspelt.filter(|(key, _)| !is_of_system(&key.value));
    let issue = match (misspelt, keys.iter().find(|key| is_of_system(&key.value))) {
        (Some((key, meant)), _) => {
            let issue = Issue::at(key.span.clone(), "this file names no system", "not known");
            issue.accepted(format!("is `{meant}` meant?"))
        }
        (None, Some(part)) => {
            let label = "a part of a system whose coordinates stand nowhere";
            Issue::at(part.span.clone(), "this file names no system", label).accepted(
                "[coordinates] names what moves in a system of one's own: theta = \"rad\" (the table is empty where frames alone turn \
                 freely); `system = \"...\"` names a built-in one, and `dalembert scenes` lists them",
            )
        }
        (None, None) => Issue::at(0..0, "this file names no system", "in this file").accepted(
            "`system = \"...\"` names a built-in one, and `dalembert scenes` lists them; [coordinates] begins a system of one's own: \
             theta = \"rad\"",
        ),
    };
    SceneError { issues: vec![issue], ..error }
}
