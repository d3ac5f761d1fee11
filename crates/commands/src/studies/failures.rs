//! The catalogue of failures in the report: a table of thresholds, and a table of the outcomes of all methods.

use crate::failures::{Measured, Way, grouped, judged, quantity};
use crate::job_pool::JobPool;
use charts::{Study, Table};
use std::path::Path;
use studies::failures::Found;

/// The entries of the catalogue, each measured by a separate job.
pub struct Failures {
    measured: Vec<Option<Measured>>,
    chosen: Vec<Way>,
}

impl Failures {
    /// The entries whose scenes exist in a folder.
    pub fn of(folder: &Path) -> Self {
        let (mut chosen, _) = Way::all(folder);
        chosen.retain(|way| way.scene().is_file());
        Failures { measured: chosen.iter().map(|_| None).collect(), chosen }
    }

    /// Adds the jobs that measure the entries.
    pub fn enlist<'s>(&'s mut self, crew: &mut JobPool<'s>, folder: &'s Path) {
        for (place, way) in self.measured.iter_mut().zip(std::mem::take(&mut self.chosen)) {
            crew.add(1.0, place, move || way.measured(folder));
        }
    }

    /// The completed study; `None` without measured entries.
    pub fn study(self) -> Option<Study> {
        let (mut found, mut missed) = (Vec::new(), String::new());
        for (way, measured) in self.measured.into_iter().flatten() {
            match measured {
                Ok(measured) => found.push((way, measured)),
                Err(why) => missed += &format!(" Not measured, {}: {why}.", way.name()),
            }
        }
        (!found.is_empty()).then(|| Study {
            id: "failures".into(),
            title: "How methods fail".into(),
            lead: "Each failure has a scene, with its theoretical threshold, computed exactly from the scene's decimals, and the threshold measured by halving between a run that holds and one that fails. Below are the message of the program and the result of every method under a budget of 200 000 evaluations (3 000 in Euler's angles, 21 000 where friction is a sign function): it held, was wrong without a message, or stopped with a reason. No run ended with NaN.".into(),
            tables: vec![thresholds(&found), fates(&found)],
            note: format!("`dalembert failures` prints these results.{missed}"),
            ..Study::default()
        })
    }
}

fn thresholds(found: &[(Way, Found)]) -> Table {
    let rows = found.iter().flat_map(|(way, found)| {
        found.thresholds.iter().enumerate().map(|(place, it)| {
            let title = if place == 0 { way.title().to_owned() } else { String::new() };
            let of = format!("{}: {}", it.of, it.formula);
            let exact = it.exact.to_string();
            let value = quantity(Some(it.exact.value()), &it.unit);
            vec![title, of, exact, value, quantity(it.measured, &it.unit), judged(it)]
        })
    });
    Table {
        caption: "Thresholds by theory and by runs".into(),
        head: ["Failure", "Threshold", "Theory, exact", "Value", "Measured", "Comparison"].map(String::from).into(),
        rows: rows.collect(),
    }
}

fn fates(found: &[(Way, Found)]) -> Table {
    let rows = found.iter().map(|(way, found)| {
        let (mut holds, mut others) = (String::new(), Vec::new());
        for (fate, by) in grouped(found) {
            if fate == "holds" { holds = by } else { others.push(format!("{fate}: {by}")) }
        }
        let why = way.why().to_owned();
        vec![way.title().to_owned(), why, found.diagnosis.clone(), holds, others.join(". "), way.advice().to_owned()]
    });
    Table {
        caption: "Cause, message, methods that hold, remedy".into(),
        head: ["Failure", "Cause", "Message", "Methods that hold", "Other methods", "Remedy"].map(String::from).into(),
        rows: rows.collect(),
    }
}
