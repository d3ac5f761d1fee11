//! Times of other programs for the proofs of dalembert, read from the file of the measuring script if it exists.

use charts::{Contender, TimingRow, Timings};
use serde_json::Value;
use std::path::Path;

/// The output file of the script, relative to the parent of the folder of scenes.
const FILE: &str = "benches/peers/proofs.json";
const COMMAND: &str = "python3 benches/peers/proofs.py";

/// The times in the file of the measuring script.
///
/// # Errors
/// The file is missing or has another format, as a sentence for the page.
pub fn read(scenes: &Path) -> Result<Timings, String> {
    let path = scenes.parent().unwrap_or(Path::new("")).join(FILE);
    let missing = || format!("Not measured here: {COMMAND} writes {FILE}, and the next page shows it.");
    let text = std::fs::read_to_string(path).map_err(|_| missing())?;
    timings(&text).ok_or_else(|| format!("{FILE} is not what this program reads; {COMMAND} writes it anew."))
}

/// Parses the entries `tasks`, each `{task, dalembert, sympy, flint}` in seconds; the text in place of a time is the reason for a missing answer.
fn timings(text: &str) -> Option<Timings> {
    let value: Value = serde_json::from_str(text).ok()?;
    let rows: Vec<TimingRow> = value.get("tasks")?.as_array()?.iter().filter_map(row).collect();
    (!rows.is_empty()).then(|| Timings {
        title: "Building and proving the same statements".to_owned(),
        ours: "dalembert".to_owned(),
        rows,
        note: format!("Medians of one run on one machine, in which the programs take turns. {}", versions(&value)),
    })
}

fn row(value: &Value) -> Option<TimingRow> {
    let others = [("sympy", "SymPy"), ("flint", "FLINT")].map(|(key, name)| {
        let outcome = match value.get(key) {
            Some(Value::String(reason)) => Err(reason.clone()),
            other => other.and_then(Value::as_f64).ok_or_else(|| "not measured".to_owned()),
        };
        Contender { name: name.to_owned(), outcome }
    });
    let task = value.get("task")?.as_str()?.to_owned();
    Some(TimingRow { task, ours: value.get("dalembert")?.as_f64()?, others: others.into() })
}

/// The versions of the tools, such as `sympy 1.14.0, flint 3.6.0`.
fn versions(value: &Value) -> String {
    let Some(Value::Object(versions)) = value.get("versions") else { return String::new() };
    let named = versions.iter().filter_map(|(name, version)| Some(format!("{name} {}", version.as_str()?)));
    let named: Vec<String> = named.collect();
    if named.is_empty() { String::new() } else { format!("Versions: {}.", named.join(", ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_keeps_what_was_measured_and_says_what_was_not() {
        let text = r#"{"versions": {"sympy": "1.14.0"}, "tasks": [
            {"task": "det", "dalembert": 1e-5, "sympy": 9e-3, "flint": "no derivatives"}, {"task": "no time"}]}"#;
        let timings = timings(text).expect("a list of tasks");
        assert_eq!(timings.rows.len(), 1);
        assert_eq!(timings.rows[0].others[0].outcome, Ok(9e-3));
        assert_eq!(timings.rows[0].others[1].outcome, Err("no derivatives".to_owned()));
        assert!(timings.note.ends_with("Versions: sympy 1.14.0."));
    }

    #[test]
    fn what_is_no_table_of_times_gives_a_reason() {
        let strange = ["", "7", "{}", "[]", r#"{"tasks": 3}"#, r#"{"tasks": [{"task": 3}]}"#];
        assert!(strange.iter().all(|text| timings(text).is_none()));
        assert!(read(Path::new("/nowhere/scenes")).is_err_and(|reason| reason.contains(COMMAND)));
    }

    #[test]
    fn the_file_of_the_measuring_script_is_read() {
        let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
        assert!(read(&scenes).is_ok_and(|timings| timings.rows.len() > 3));
    }
}
