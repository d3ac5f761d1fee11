//! Steady motions of a law that changes at conditions, in each combination of their cases.

use super::Asked;
use super::model::{body, object};
use super::steady_box::{Cases, Combination};
use crate::arguments::Format;
use crate::exit::{Exit, print};
use serde_json::json;
use std::fmt::Write;

/// Prints the combinations in which there is something.
pub(super) fn show(asked: &Asked, cases: Cases) -> Result<Exit, Exit> {
    let title = cases.title.clone();
    let (mut out, mut objects, mut last) = (format!("{title}\n"), Vec::new(), Exit::Done);
    let (count, all) = (cases.all.len(), cases.with_motions());
    let empty = count - all.len();
    for Combination { conditions, found, .. } in all {
        // writing to a String cannot fail
        let _ = write!(out, "\nwhere {}\n{}", conditions.join(", "), body(&found));
        let mut object = object(&found);
        object["where"] = json!(conditions);
        objects.push(object);
        if let Exit::Stopped = asked.steady.ended(&asked.scene, &found.motions) {
            last = Exit::Stopped;
        }
    }
    let _ = match (count, empty) {
        (_, 0) => Ok(()),
        (count, empty) if count == empty => {
            writeln!(
                out,
                "\nno steady motion in any of {count} combinations of its conditions: the searches decide everything"
            )
        }
        (_, 1) => writeln!(out, "\nno steady motion in one other combination of its conditions"),
        (_, empty) => writeln!(out, "\nno steady motion in {empty} other combinations of its conditions"),
    };
    print(&match asked.format {
        Format::Text => out,
        Format::Json => format!("{:#}\n", json!({ "title": title, "combinations": count, "cases": objects })),
    })?;
    Ok(last)
}
