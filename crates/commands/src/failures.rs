//! `dalembert failures`: the catalogue of failure, measured.

use crate::arguments::Format;
use crate::exit::{Exit, print};
use crate::job_pool::JobPool;
use charts::significant;
use clap::Args;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use studies::failures::{ALL, Failing, Found, NotFound, Threshold};

/// Which ways to fail are to be measured.
#[derive(Args, Debug)]
pub struct Asked {
    /// Those whose name contains this, such as windings or pull-out
    #[arg(default_value = "")]
    pub name: String,
    /// Where the scene files are
    #[arg(long, value_name = "FOLDER", default_value = "scenes")]
    pub scenes: PathBuf,
    /// How to print them
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// A way with what was found.
pub type Measured = (&'static Failing, Result<Found, NotFound>);

/// Measures the ways whose name contains what was asked for, and prints them.
pub fn list(asked: &Asked) -> Result<Exit, Exit> {
    let chosen: Vec<&Failing> = ALL.iter().filter(|failing| failing.name.contains(&asked.name)).collect();
    if chosen.is_empty() {
        let names: Vec<&str> = ALL.iter().map(|failing| failing.name).collect();
        return Err(Exit::refused(format!("no way to fail is called `{}`; known: {}", asked.name, names.join(", "))));
    }
    let mut measured: Vec<Option<Measured>> = chosen.iter().map(|_| None).collect();
    let mut crew = JobPool::default();
    for (place, failing) in measured.iter_mut().zip(chosen) {
        crew.add(1.0, place, || (failing, failing.measure(&asked.scenes)));
    }
    crew.work(|_| ());
    let (mut told, mut missed) = (Vec::new(), Vec::new());
    for (failing, found) in measured.into_iter().flatten() {
        match found {
            Ok(found) => told.push((failing, found)),
            Err(NotFound::Scene(error)) => missed.push(Exit::from(error)),
            Err(why @ NotFound::Unsuitable { .. }) => missed.push(Exit::refused(why)),
        }
    }
    // one scene that cannot be measured does not hide the others
    if told.is_empty() {
        return Err(missed.into_iter().next().unwrap_or(Exit::Stopped));
    }
    let all = missed.is_empty();
    for missed in missed {
        missed.tell();
    }
    let agree = told.iter().flat_map(|(_, found)| &found.thresholds).all(Threshold::agrees);
    print(&match asked.format {
        Format::Text => {
            told.iter().map(|(failing, found)| text(failing, found, &asked.scenes)).collect::<Vec<_>>().join("\n")
        }
        Format::Json => format!("{:#}\n", Value::from_iter(told.iter().map(|(failing, found)| object(failing, found)))),
    })?;
    Ok(if agree && all { Exit::Done } else { Exit::Stopped })
}

/// The trials of one fate together: those that hold first, then those that err silently.
pub fn grouped(found: &Found) -> Vec<(String, String)> {
    let mut groups: Vec<(u8, String, Vec<&str>)> = Vec::new();
    for trial in &found.trials {
        let (rank, fate) = (trial.fate.rank(), trial.fate.to_string());
        match groups.iter_mut().find(|(_, known, _)| *known == fate) {
            Some((.., by)) => by.push(&trial.by),
            None => groups.push((rank, fate, vec![&trial.by])),
        }
    }
    groups.sort_by(|a, b| (a.0, &a.1).cmp(&(b.0, &b.1)));
    groups.into_iter().map(|(_, fate, by)| (fate, by.join("; "))).collect()
}

/// `4.000·10⁻⁶ s`, or why there is no number.
pub fn quantity(value: Option<f64>, unit: &str) -> String {
    let number = value.map_or_else(|| "no edge was found".to_owned(), |value| significant(value, 6));
    if unit.is_empty() || value.is_none() { number } else { format!("{number} {unit}") }
}

/// Whether theory and measurement are one, and how well that was told.
pub fn judged(threshold: &Threshold) -> String {
    format!("{} {}", if threshold.agrees() { "agrees" } else { "DISAGREES" }, threshold.within)
}

fn text(failing: &Failing, found: &Found, folder: &Path) -> String {
    let mut text = format!("{}: {}\n", failing.name, failing.title);
    let mut line = |name: &str, value: &str| {
        // writing to a string cannot fail
        let _ = writeln!(text, "  {name:<22} {value}");
    };
    line("scene", &folder.join(failing.scene).display().to_string());
    for it in &found.thresholds {
        line("threshold", it.of);
        line("  theory", &format!("{} = {}", it.exact, quantity(Some(it.exact.value()), it.unit)));
        line("  measured", &format!("{}, {}", quantity(it.measured, it.unit), judged(it)));
    }
    line("says", &found.diagnosis);
    line("asked", failing.asked);
    for (fate, by) in grouped(found) {
        line(&fate, &by);
    }
    line("advice", failing.advice);
    text
}

fn object(failing: &Failing, found: &Found) -> Value {
    let threshold = |it: &Threshold| {
        json!({
            "of": it.of,
            "formula": it.formula,
            "exact": it.exact.to_string(),
            "theory": it.exact.value(),
            "measured": it.measured,
            "unit": it.unit,
            "agrees": it.agrees(),
            "within": it.within.to_string(),
        })
    };
    let trial = |by: &str, fate: String| json!({ "by": by, "fate": fate });
    json!({
        "name": failing.name,
        "title": failing.title,
        "scene": failing.scene,
        "why": failing.why,
        "thresholds": found.thresholds.iter().map(threshold).collect::<Vec<_>>(),
        "diagnosis": found.diagnosis,
        "asked": failing.asked,
        "trials": found.trials.iter().map(|it| trial(&it.by, it.fate.to_string())).collect::<Vec<_>>(),
        "advice": failing.advice,
    })
}
