//! The comparison with other tools: tables of the file that `benches/peers/run.py` writes, or a note if this file does not exist.

use charts::{Study, Table};
use serde::Deserialize;
use std::path::Path;

/// The output file of the script, relative to the parent of the folder of scenes.
const FILE: &str = "benches/peers/results.json";
const COMMAND: &str = "python3 benches/peers/run.py";

#[derive(Deserialize)]
struct Results {
    summary: Vec<Summary>,
}

#[derive(Deserialize)]
struct Summary {
    caption: String,
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// The study with its tables, or with the reason for which there are none.
pub fn study(scenes: &Path) -> Study {
    let path = scenes.parent().unwrap_or(Path::new("")).join(FILE);
    let read = std::fs::read_to_string(path).map_err(|_| format!("Not measured here: {COMMAND} writes {FILE}."));
    let anew = |_| format!("{FILE} is not what this program reads; {COMMAND} writes it anew.");
    let found = read.and_then(|text| serde_json::from_str::<Results>(&text).map_err(anew));
    let (tables, note) = match found {
        Ok(Results { summary }) => {
            (summary, format!("From the last run of {COMMAND}: one machine, the tools take turns, medians."))
        }
        Err(reason) => (Vec::new(), reason),
    };
    let table = |Summary { caption, head, rows }| Table { caption, head, rows };
    Study {
        id: "peers".into(),
        title: "Comparison with other tools".into(),
        lead: "The same law, from the same file, by every tool; an error counts against a reference that two methods of ours \
               confirm, and the result of every tool is compared with it first."
            .into(),
        tables: tables.into_iter().map(table).collect(),
        note,
        ..Study::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_of_the_measuring_script_is_read() {
        let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
        let study = study(&scenes);
        assert_eq!(study.tables.len(), 2, "{}", study.note);
        assert!(study.tables.iter().all(|table| table.rows.iter().all(|row| row.len() == table.head.len())));
    }

    #[test]
    fn what_is_not_there_is_said_with_the_command_that_makes_it() {
        assert!(study(Path::new("/nowhere/scenes")).note.contains(COMMAND));
    }
}
