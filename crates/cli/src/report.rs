//! The report: one page with the ledger of every paper and the runs and charts of every scene.

use crate::ending::{Ending, save};
use crate::pictures;
use crate::progress::Progress;
use crate::rough;
use crate::sphere;
use crate::studies;
use crate::timings;
use charts::{Parameter, Report, SceneSection, Table, Verdict, WorkPrecision, significant, tolerance};
use derivations::machines::Quantity;
use derivations::scene::{AnyScene, Axes, Scene, Trajectory, Trials};
use integrators::{Failure, Reference};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::time::Duration;

/// Runs and charts the scenes, adds them to a report that holds the ledger, and writes the page.
pub fn write(path: &Path, folder: &Path, files: &[PathBuf], mut report: Report) -> Result<Ending, Ending> {
    // all are read before the first is run: what is wrong is told at once
    let (mut scenes, mut rough) = (Vec::new(), Vec::new());
    for file in files {
        match AnyScene::open(file)? {
            AnyScene::Driven(scene) => scenes.push((id(file), *scene)),
            AnyScene::Rough(scene) => rough.push((id(file), scene)),
        }
    }
    let mut progress = Progress::new("runs and references");
    let prepared = side_by_side(&scenes, prepare, |done| progress.set(REFERENCES * done));
    drop(progress);
    let mut progress = Progress::new("methods measured");
    let (mut all_reached, mut digits) = (true, f64::INFINITY);
    for (done, ((_, scene), Prepared { mut section, reached, reference })) in scenes.iter().zip(prepared).enumerate() {
        progress.set(REFERENCES + (1.0 - REFERENCES) * done as f64 / scenes.len() as f64);
        all_reached &= reached && reference.is_ok();
        match reference {
            Ok(reference) => {
                digits = digits.min(reference.digits);
                let measured = scene.measure_by(reference, Axes::First, &Trials::default());
                section.work = pictures::work_precision(scene, &measured).into();
                section.note = pictures::measured_by(scene, &measured);
            }
            Err(failure) => section.note = format!("No chart, because the reference stopped: {failure}."),
        }
        report.scenes.push(section);
    }
    drop(progress);
    report.stability = derivations::governors::stability().into_iter().map(pictures::stability).collect();
    report.approximations = vec![pictures::series_errors(&derivations::governors::series_errors())];
    report.friction = derivations::regimes::maps::maps().into_iter().map(pictures::areas).collect();
    report.rough = side_by_side(&rough, |(id, scene)| rough::section(id, scene), |_| ());
    report.studies = vec![studies::gains(), studies::drive()];
    report.spheres = sphere::all(scenes.iter().map(|(_, scene)| scene));
    match timings::read(folder) {
        Ok(timings) => report.timings = vec![timings],
        Err(reason) => report.timings_missing = reason,
    }
    report.summary = format!("{} {}", report.summary, found(&report, digits));
    save(path, &charts::page::render(&report).html)?;
    Ok(if all_reached { Ending::Done } else { Ending::Stopped })
}

/// The share of the work that comes before the measurements.
const REFERENCES: f64 = 0.1;
/// References share the processors, so that one of them has less than when it is alone.
const PATIENCE: Duration = Duration::from_secs(15);

/// What came out, and where to begin to read.
fn found(report: &Report, digits: f64) -> String {
    let claims: usize = report.papers.iter().map(|paper| paper.claims.len()).sum();
    let mut text = String::new();
    if claims > 0 {
        text += &format!("Of {claims} claims, {}. ", counted(report));
    }
    if report.count(Verdict::Refuted) > 0 {
        text += "Begin with the findings: each refuted statement with exact values for which it fails, and the proved \
                 statement that holds instead. ";
    }
    if digits.is_finite() {
        let count = report.scenes.len();
        let scenes = if count == 1 { "The scene is".to_owned() } else { format!("The {count} scenes are") };
        text += &format!(
            "{scenes} measured by references on which two methods agree to {digits:.0} digits or more: look for the one \
             nearest to your own problem, whose charts tell which method is cheapest at which accuracy."
        );
    }
    text.trim_end().to_owned()
}

/// `149 are proved, 11 refuted, 3 definitions`: the most frequent first.
fn counted(report: &Report) -> String {
    let mut counts = Verdict::ALL.map(|verdict| (report.count(verdict), verdict));
    counts.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    let name = |count: usize, verdict: Verdict| match verdict {
        Verdict::Definition if count > 1 => "definitions",
        other => other.name(),
    };
    let present = counts.into_iter().filter(|(count, _)| *count > 0).enumerate();
    let one =
        |(place, (count, verdict))| format!("{count} {}{}", if place == 0 { "are " } else { "" }, name(count, verdict));
    present.map(one).collect::<Vec<_>>().join(", ")
}

/// Does the same to all scenes, as many at a time as there are processors; results in the scenes' order.
fn side_by_side<S: Sync, T: Send>(items: &[S], work: impl Fn(&S) -> T + Sync, mut done: impl FnMut(f64)) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let mut results: Vec<Option<T>> = items.iter().map(|_| None).collect();
    std::thread::scope(|scope| {
        let (sender, receiver) = mpsc::channel();
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from).min(items.len()) {
            let (sender, next, work) = (sender.clone(), &next, &work);
            scope.spawn(move || {
                while let Some((at, item)) =
                    Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|at| Some((at, items.get(at)?)))
                {
                    // the other end lives as long as this scope
                    let _ = sender.send((at, work(item)));
                }
            });
        }
        drop(sender);
        for (count, (at, result)) in receiver.iter().enumerate() {
            results[at] = Some(result);
            done((count + 1) as f64 / items.len() as f64);
        }
    });
    results.into_iter().flatten().collect()
}

/// A page with nothing but a scene and its charts.
pub fn of_scene(scene: &Scene, work: Vec<WorkPrecision>, note: String) -> String {
    let run = scene.simulate(&scene.choice(), |_| ());
    let section = SceneSection { work, note, ..described("scene", scene, &run) };
    let report = Report { scenes: vec![section], ..titled(&scene.title, &scene.description) };
    charts::page::render(&report).html
}

/// A report without content yet.
pub fn titled(title: &str, summary: &str) -> Report {
    let generated_by = concat!("dalembert ", env!("CARGO_PKG_VERSION")).to_owned();
    Report { title: title.to_owned(), summary: summary.to_owned(), generated_by, ..Default::default() }
}

/// A scene's section without its charts, whether its run reached the end, and what its methods are measured by.
struct Prepared {
    section: SceneSection,
    reached: bool,
    reference: Result<Reference, Failure>,
}

fn prepare((id, scene): &(String, Scene)) -> Prepared {
    let run = scene.simulate(&scene.choice(), |_| ());
    let mut section = described(id, scene, &run);
    section.tables.extend(ladder(scene, &run));
    Prepared { section, reached: run.outcome.reached(), reference: scene.reference(Axes::First, PATIENCE) }
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
        ("method".to_owned(), format!("{}, tolerance {}", choice.method, tolerance(choice.tolerance))),
        ("work".to_owned(), run.outcome.work.to_string()),
    ];
    if let Some(failure) = run.outcome.failure() {
        facts.push(("stopped".to_owned(), failure.to_string()));
    }
    for deviation in &run.outcome.deviations {
        facts.push((deviation.name.replace('_', " "), format!("kept to {}", significant(deviation.largest, 2))));
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
            None => significant(difference(run, &other), 2),
            Some(failure) => pictures::reason(&failure).to_owned(),
        };
        rows.push(vec![model.replace('_', " "), states, other.outcome.work.rates.to_string(), row]);
    }
    let head = ["Model", "States", "Evaluations", "Largest difference of \u{3c9} or \u{3c6}\u{307}, rad/s"];
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
