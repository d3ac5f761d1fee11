//! Steady motions of a law that changes at conditions, in each combination of their cases.

use super::Asked;
use super::model::{body, object};
use super::steady_box::{Cases, Found};
use crate::arguments::Format;
use crate::exit::{Exit, print};
use ::scenes::steady_motions::{Case, SteadyMotions};
use serde_json::json;
use std::fmt::Write;

/// Prints the combinations in which there is something.
pub(super) fn show(asked: &Asked, cases: Cases) -> Result<Exit, Exit> {
    let Cases { title, model, conditions, all } = cases;
    let told = |own: &[Case]| -> Vec<String> {
        let told = |(case, text): (&Case, &String)| match case {
            Case::Holds => format!("{text} > 0"),
            Case::Fails => format!("{text} < 0"),
            Case::Between => format!("{text} = 0"),
            Case::Forward => format!("{text} = 0, sliding along its tangent"),
            Case::Backward => format!("{text} = 0, sliding against its tangent"),
        };
        own.iter().zip(&conditions).map(told).collect()
    };
    let (mut out, mut objects, mut last) = (format!("{title}\n"), Vec::new(), Exit::Done);
    let (count, mut empty) = (all.len(), 0);
    for (own, motions) in all {
        if is_empty(&motions) {
            empty += 1;
            continue;
        }
        let found = Found { title: title.clone(), model: model.clone(), motions };
        // writing to a String cannot fail
        let _ = write!(out, "\nwhere {}\n{}", told(&own).join(", "), body(&found));
        let mut object = object(&found);
        object["where"] = json!(told(&own));
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

fn is_empty(found: &SteadyMotions) -> bool {
    found.motions.is_empty() && found.families.is_empty() && found.is_complete()
}
