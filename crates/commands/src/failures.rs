//! `dalembert failures`: a catalogue of cases in which methods fail, with measured limits.

use crate::arguments::Format;
use crate::clock;
use crate::exit::{Exit, print};
use crate::job_pool::JobPool;
use ::scenes::FailureEntry;
use charts::significant;
use reader::SceneError;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use studies::failures::{ALL, Failing, Found, NotFound, Threshold, measure_text, text_entries, text_entry};

/// Arguments of `failures`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// Entries whose name contains this text, such as windings or pull-out; or a scene of your own with the table [failure]
    #[arg(default_value = "", value_name = "NAME|SCENE.toml")]
    pub name: String,
    /// The folder of scene files; those in its subfolder `failures` with a table [failure] are measured too
    #[arg(long, value_name = "FOLDER", default_value = "scenes")]
    pub scenes: PathBuf,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// An entry of the catalogue: a built-in case, or a scene with the table `[failure]`.
pub enum Way {
    Known { failing: &'static Failing, scene: PathBuf },
    Text { entry: Box<FailureEntry>, scene: PathBuf },
}

/// An entry with its measured thresholds and trials, or the reason for which it could not be measured.
pub type Measured = (Way, Result<Found, NotFound>);

impl Way {
    /// All entries: the built-in cases, and those of the scenes of a folder. Scenes that cannot be read are returned as errors.
    pub fn all(folder: &Path) -> (Vec<Self>, Vec<SceneError>) {
        let known = ALL.iter().map(|failing| Way::Known { failing, scene: folder.join(failing.scene) });
        let (mut ways, mut errors) = (known.collect::<Vec<_>>(), Vec::new());
        for entry in text_entries(folder) {
            match entry {
                Ok((scene, entry)) => ways.push(Way::Text { entry: Box::new(entry), scene }),
                Err(error) => errors.push(error),
            }
        }
        (ways, errors)
    }

    /// Measures the thresholds of the entry by runs.
    pub fn measured(self, folder: &Path) -> Measured {
        let found = match &self {
            Way::Known { failing, .. } => failing.measure(folder),
            Way::Text { entry, scene } => measure_text(scene, entry, &clock::goes_on),
        };
        (self, found)
    }

    pub fn name(&self) -> &str {
        match self {
            Way::Known { failing, .. } => failing.name,
            Way::Text { entry, .. } => &entry.name,
        }
    }

    pub fn title(&self) -> &str {
        match self {
            Way::Known { failing, .. } => failing.title,
            Way::Text { entry, .. } => &entry.title,
        }
    }

    pub fn scene(&self) -> &Path {
        match self {
            Way::Known { scene, .. } | Way::Text { scene, .. } => scene,
        }
    }

    /// The path of the scene relative to the folder of scenes; for a scene with `[failure]` its own path.
    fn scene_in_folder(&self) -> String {
        match self {
            Way::Known { failing, .. } => failing.scene.to_owned(),
            Way::Text { scene, .. } => scene.display().to_string(),
        }
    }

    pub fn why(&self) -> &str {
        match self {
            Way::Known { failing, .. } => failing.why,
            Way::Text { entry, .. } => &entry.why,
        }
    }

    pub fn advice(&self) -> &str {
        match self {
            Way::Known { failing, .. } => failing.advice,
            Way::Text { entry, .. } => &entry.advice,
        }
    }

    /// The condition that a successful run satisfies.
    pub fn asked(&self) -> String {
        match self {
            Way::Known { failing, .. } => failing.asked.to_owned(),
            Way::Text { entry, .. } => match &entry.margin {
                Some(margin) => format!("{margin} > 0 along the run"),
                None => "the end of the run, without a failure".to_owned(),
            },
        }
    }
}

/// Measures and prints the entries whose name contains the argument, or the entry of a scene.
pub fn list(asked: &Args) -> Result<Exit, Exit> {
    let file = Path::new(&asked.name);
    let (chosen, mut missed) = match file.extension().is_some_and(|extension| extension == "toml") {
        true => {
            let entry = Box::new(text_entry(file)?);
            (vec![Way::Text { entry, scene: file.to_owned() }], Vec::new())
        }
        false => chosen(asked)?,
    };
    let mut measured: Vec<Option<Measured>> = chosen.iter().map(|_| None).collect();
    let mut crew = JobPool::default();
    for (place, way) in measured.iter_mut().zip(chosen) {
        crew.add(1.0, place, || way.measured(&asked.scenes));
    }
    crew.work(|_| ());
    let mut told = Vec::new();
    for (way, found) in measured.into_iter().flatten() {
        match found {
            Ok(found) => told.push((way, found)),
            Err(NotFound::Scene(error)) => missed.push(Exit::from(error)),
            Err(why) => missed.push(Exit::refused(why)),
        }
    }
    // a scene that cannot be measured must not hide the results of others
    if told.is_empty() {
        return Err(missed.into_iter().next().unwrap_or(Exit::Stopped));
    }
    let all = missed.is_empty();
    for missed in missed {
        missed.tell();
    }
    let agree = told.iter().flat_map(|(_, found)| &found.thresholds).all(Threshold::agrees);
    print(&match asked.format {
        Format::Text => told.iter().map(|(way, found)| text(way, found)).collect::<Vec<_>>().join("\n"),
        Format::Json => format!("{:#}\n", Value::from_iter(told.iter().map(|(way, found)| object(way, found)))),
    })?;
    Ok(if agree && all { Exit::Done } else { Exit::Stopped })
}

/// The requested entries, and the errors of files that cannot be read.
fn chosen(asked: &Args) -> Result<(Vec<Way>, Vec<Exit>), Exit> {
    let (ways, errors) = Way::all(&asked.scenes);
    let names = ways.iter().map(Way::name).collect::<Vec<_>>().join(", ");
    let chosen: Vec<Way> = ways.into_iter().filter(|way| way.name().contains(&asked.name)).collect();
    if chosen.is_empty() {
        return Err(Exit::refused(format!(
            "no entry is called `{}`; known: {names}; or a file SCENE.toml with the table [failure]",
            asked.name
        )));
    }
    Ok((chosen, errors.into_iter().map(Exit::from).collect()))
}

/// The trials grouped by their outcome, successful ones first, then those with an undetected error.
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

/// A value with its unit, `4.000·10⁻⁶ s`; a sentence where there is no value.
pub fn quantity(value: Option<f64>, unit: &str) -> String {
    let number = value.map_or_else(|| "no edge was found".to_owned(), |value| significant(value, 6));
    if unit.is_empty() || value.is_none() { number } else { format!("{number} {unit}") }
}

/// Whether the theoretical and the measured threshold agree, with the accuracy of the comparison.
pub fn judged(threshold: &Threshold) -> String {
    format!("{} {}", if threshold.agrees() { "agrees" } else { "DISAGREES" }, threshold.within)
}

fn text(way: &Way, found: &Found) -> String {
    let mut text = format!("{}: {}\n", way.name(), way.title());
    let mut line = |name: &str, value: &str| {
        // writing to a string cannot fail
        let _ = writeln!(text, "  {name:<22} {value}");
    };
    line("scene", &way.scene().display().to_string());
    for it in &found.thresholds {
        line("threshold", &it.of);
        line("  theory", &format!("{} = {}", it.exact, quantity(Some(it.exact.value()), &it.unit)));
        line("  measured", &format!("{}, {}", quantity(it.measured, &it.unit), judged(it)));
    }
    line("says", &found.diagnosis);
    line("asked", &way.asked());
    for (fate, by) in grouped(found) {
        line(&fate, &by);
    }
    line("advice", way.advice());
    text
}

fn object(way: &Way, found: &Found) -> Value {
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
        "name": way.name(),
        "title": way.title(),
        "scene": way.scene_in_folder(),
        "why": way.why(),
        "thresholds": found.thresholds.iter().map(threshold).collect::<Vec<_>>(),
        "diagnosis": found.diagnosis,
        "asked": way.asked(),
        "trials": found.trials.iter().map(|it| trial(&it.by, it.fate.to_string())).collect::<Vec<_>>(),
        "advice": way.advice(),
    })
}
