//! The report: one page with the ledger of every paper and the runs and charts of every scene.

use crate::ending::{Ending, save};
use crate::pictures;
use crate::progress::Progress;
use crate::sphere;
use charts::{Parameter, Report, SceneSection, Table, WorkPrecision};
use derivations::machines::Quantity;
use derivations::scene::{Axes, Scene, Trajectory, Trials};
use std::path::{Path, PathBuf};

/// Runs and charts the scenes, adds them to a report that holds the ledger, and writes the page.
pub fn write(path: &Path, scenes: &[PathBuf], mut report: Report) -> Result<Ending, Ending> {
    // all are read before the first is run: what is wrong is told at once
    let scenes = scenes.iter().map(|file| Ok((id(file), Scene::open(file)?))).collect::<Result<Vec<_>, Ending>>()?;
    let mut all_reached = true;
    let mut progress = Progress::new("scenes");
    for (done, (id, scene)) in scenes.iter().enumerate() {
        progress.set(done as f64 / scenes.len() as f64);
        let (section, reached) = section(id, scene);
        report.scenes.push(section);
        report.spheres.extend(sphere::of(id, scene));
        all_reached &= reached;
    }
    drop(progress);
    save(path, &charts::page::render(&report).html)?;
    Ok(if all_reached { Ending::Done } else { Ending::Stopped })
}

/// A page with nothing but a scene and its charts.
pub fn of_scene(scene: &Scene, work: Vec<WorkPrecision>) -> String {
    let run = scene.simulate(&scene.choice(), |_| ());
    let section = SceneSection { work, ..described("scene", scene, &run) };
    let report = Report { scenes: vec![section], ..titled(&scene.title, &scene.description) };
    charts::page::render(&report).html
}

/// A report without content yet.
pub fn titled(title: &str, summary: &str) -> Report {
    let generated_by = concat!("dalembert ", env!("CARGO_PKG_VERSION")).to_owned();
    Report { title: title.to_owned(), summary: summary.to_owned(), generated_by, ..Default::default() }
}

/// The section of a scene, and whether its run and its reference reached the end.
fn section(id: &str, scene: &Scene) -> (SceneSection, bool) {
    let run = scene.simulate(&scene.choice(), |_| ());
    let mut section = described(id, scene, &run);
    section.tables.extend(ladder(scene, &run));
    let measured = scene.measure(Axes::First, &Trials::default());
    let reached = run.outcome.reached() && measured.is_ok();
    match measured {
        Ok(measured) => section.work = pictures::work_precision(scene, &measured).into(),
        Err(failure) => section.note = format!("No chart, because the reference stopped: {failure}."),
    }
    (section, reached)
}

fn described(id: &str, scene: &Scene, run: &Trajectory) -> SceneSection {
    SceneSection {
        id: id.to_owned(),
        title: scene.title.clone(),
        description: scene.description.clone(),
        parameters: parameters(scene),
        facts: facts(scene, run),
        trajectory: Some(pictures::trajectory(scene, run)),
        ..Default::default()
    }
}

fn facts(scene: &Scene, run: &Trajectory) -> Vec<(String, String)> {
    let choice = scene.choice();
    let mut facts = vec![
        ("model".to_owned(), scene.machine.name().replace('_', " ")),
        ("method".to_owned(), format!("{}, tolerance {:e}", choice.method, choice.tolerance)),
        ("work".to_owned(), run.outcome.work.to_string()),
    ];
    if let Some(failure) = run.outcome.failure() {
        facts.push(("stopped".to_owned(), failure.to_string()));
    }
    for deviation in &run.outcome.deviations {
        facts.push((deviation.name.replace('_', " "), format!("kept to {:.1e}", deviation.largest)));
    }
    facts
}

fn parameters(scene: &Scene) -> Vec<Parameter> {
    let numbers = scene.machine_data.numbers.iter().map(|(quantity, value)| {
        let Quantity { name, unit, meaning } = **quantity;
        let unit = if unit == "1" { "" } else { unit };
        parameter(name, value.to_string(), unit, meaning)
    });
    let counts = scene.machine_data.counts.iter();
    numbers.chain(counts.map(|(name, meaning, count)| parameter(name, count.to_string(), "", meaning))).collect()
}

fn parameter(symbol: &str, value: String, unit: &str, meaning: &str) -> Parameter {
    Parameter { symbol: symbol.replace('_', " "), value, unit: unit.to_owned(), meaning: meaning.to_owned() }
}

/// What each smaller model of the same data does to the outputs, where there is one.
fn ladder(scene: &Scene, run: &Trajectory) -> Option<Table> {
    let models = scene.machine_data.ladder();
    let mut rows = Vec::new();
    for model in models.into_iter().rev().filter(|model| *model != scene.machine.name()) {
        let Ok(smaller) = scene.with_model(model) else { continue };
        if smaller.names().is_empty() {
            continue; // on a bench a rotor of constant speed has no state at all
        }
        let other = smaller.simulate(&smaller.choice(), |_| ());
        let states = smaller.names().len().to_string();
        let row = match other.outcome.failure() {
            None => format!("{:.1e}", difference(run, &other)),
            Some(failure) => pictures::reason(&failure).to_owned(),
        };
        rows.push(vec![model.replace('_', " "), states, other.outcome.work.rates.to_string(), row]);
    }
    let head = ["Model", "States", "Evaluations", "Largest difference of \u{3c9}, rad/s or of the slip"];
    let caption = format!("The same scene with smaller models than {}", scene.machine.name().replace('_', " "));
    (!rows.is_empty()).then(|| Table { caption, head: head.map(String::from).into(), rows })
}

/// Over all samples, of the angular velocity and the rotor's speed: what every model has.
fn difference(a: &Trajectory, b: &Trajectory) -> f64 {
    let common = ["w1", "w2", "w3", "rotor_speed"].into_iter();
    let columns: Vec<(usize, usize)> = common.filter_map(|name| Some((a.column(name)?, b.column(name)?))).collect();
    let rows = a.rows.iter().zip(&b.rows);
    rows.flat_map(|(a, b)| columns.iter().map(|&(i, j)| (a[i] - b[j]).abs())).fold(0.0, f64::max)
}

/// A file's name without its ending, as it may stand in a link.
fn id(file: &Path) -> String {
    let stem = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    stem.chars().map(|c| if c.is_ascii_alphanumeric() || c == '_' { c } else { '-' }).collect()
}
