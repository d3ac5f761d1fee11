//! Steady motions for each combination of cases and angles, as text and JSON.

use super::Args;
use super::combinations::{Combination, Combinations};
use super::model::{body, object};
use crate::arguments::Format;
use crate::exit::{Exit, print};
use serde_json::{Value, json};
use std::fmt::Write;

/// Prints the combinations that have steady motions or undecided regions.
pub(super) fn show(asked: &Args, parts: &Combinations) -> Result<Exit, Exit> {
    let mut last = Exit::Done;
    for Combination { found, .. } in &parts.filled {
        if let Exit::Stopped = asked.steady.ended(&asked.scene, &found.motions) {
            last = Exit::Stopped;
        }
    }
    let (text, object) = told(parts);
    print(&match asked.format {
        Format::Text => text,
        Format::Json => format!("{object:#}\n"),
    })?;
    Ok(last)
}

/// The combinations that have steady motions or undecided regions, as text and JSON.
pub(super) fn told(parts: &Combinations) -> (String, Value) {
    let Combinations { title, count, kind, filled } = parts;
    let (mut out, mut objects) = (format!("{title}\n"), Vec::new());
    let empty = count - filled.len();
    for Combination { held, found, .. } in filled {
        // writing to a String cannot fail
        let heading = if held.is_empty() { String::new() } else { format!("where {}\n", held.join(", ")) };
        let _ = write!(out, "\n{heading}{}", body(found));
        let mut object = object(found);
        object["where"] = json!(held);
        objects.push(object);
    }
    let _ = match (*count, empty) {
        (_, 0) => Ok(()),
        (count, empty) if count == empty => {
            let all = if count == 1 { kind.one().to_owned() } else { format!("any of {count} {}", kind.many()) };
            writeln!(out, "\nno steady motion in {all} (complete search)")
        }
        (_, 1) => writeln!(out, "\nno steady motion in one other of {count} {}", kind.many()),
        (_, empty) => writeln!(out, "\nno steady motion in {empty} others of {count} {}", kind.many()),
    };
    (out, json!({ "title": title, "combinations": count, "cases": objects }))
}
