//! What others take for the same proofs: read from what the measuring script has written, if it has.

use charts::{Contender, TimingRow, Timings};
use serde_json::Value;
use std::path::Path;

/// Where the script writes, beside the folder of scenes.
const FILE: &str = "benches/against_sympy.json";
const COMMAND: &str = "python3 benches/against_sympy.py";

/// The times, or why there are none.
pub fn read(scenes: &Path) -> Result<Timings, String> {
    let path = scenes.parent().unwrap_or(Path::new("")).join(FILE);
    let missing = || {
        format!(
            "Not measured here: {COMMAND} (it asks for SymPy and python-flint) writes {FILE}, and the next page shows it."
        )
    };
    let text = std::fs::read_to_string(path).map_err(|_| missing())?;
    timings(&text).ok_or_else(|| format!("{FILE} is not what this program reads; {COMMAND} writes it anew."))
}

/// From a list of `{task, ours, sympy, flint}` in seconds, under `rows` or alone; what is missing or null was not done.
fn timings(text: &str) -> Option<Timings> {
    let value: Value = serde_json::from_str(text).ok()?;
    let rows = value.as_array().or_else(|| ["rows", "tasks"].iter().find_map(|key| value.get(key)?.as_array()))?;
    let rows: Vec<TimingRow> = rows.iter().filter_map(row).collect();
    let note = value
        .get("note")
        .and_then(Value::as_str)
        .unwrap_or("Seconds, each a median, measured in one run on one machine.");
    (!rows.is_empty()).then(|| Timings {
        title: "Building and proving the same statements".to_owned(),
        ours: "dalembert".to_owned(),
        rows,
        note: note.to_owned(),
    })
}

fn row(value: &Value) -> Option<TimingRow> {
    let others = [("sympy", "SymPy"), ("flint", "FLINT")].map(|(key, name)| {
        let outcome = value.get(key).and_then(Value::as_f64).ok_or_else(|| "not measured".to_owned());
        Contender { name: name.to_owned(), outcome }
    });
    let task = value.get("task")?.as_str()?.to_owned();
    Some(TimingRow { task, ours: value.get("ours")?.as_f64()?, others: others.into() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_keeps_what_was_measured_and_says_what_was_not() {
        let text = r#"[{"task": "det", "ours": 1e-5, "sympy": 9e-3, "flint": null}, {"task": "no time"}]"#;
        let timings = timings(text).expect("a list of rows");
        assert_eq!(timings.rows.len(), 1);
        assert_eq!(timings.rows[0].others[0].outcome, Ok(9e-3));
        assert!(timings.rows[0].others[1].outcome.is_err());
    }

    #[test]
    fn what_is_no_table_of_times_gives_a_reason() {
        assert!(["", "7", "{}", "[]", "[{\"task\": 3}]"].iter().all(|text| timings(text).is_none()));
        assert!(read(Path::new("/nowhere/scenes")).is_err_and(|reason| reason.contains(COMMAND)));
    }
}
