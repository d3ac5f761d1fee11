//! The report: one page with the ledger of every paper and the runs and charts of every scene.

use crate::crew::Crew;
use crate::ending::{Ending, save};
use crate::ledger;
use crate::pictures;
use crate::progress::Progress;
use crate::rough;
use crate::sphere;
use crate::studies::{Drive, Gains};
use crate::timings;
use charts::{
    Areas, PaperSection, Parameter, Report, SceneSection, Sphere, Table, Verdict, WorkPrecision, significant, tolerance,
};
use derivations::machines::Quantity;
use derivations::scene::{AnyScene, Axes, Measured, Scene, Trajectory, Trials};
use derivations::{friction::RoughScene, governors, papers, regimes};
use integrators::Failure;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Judges the ledger, runs and charts the scenes, and writes the page.
pub fn write(path: &Path, folder: &Path, files: &[PathBuf]) -> Result<Ending, Ending> {
    // all are read before the first is run: what is wrong is told at once
    let (mut scenes, mut rough) = (Vec::new(), Vec::new());
    for file in files {
        match AnyScene::open(file)? {
            AnyScene::Driven(scene) => scenes.push((id(file), *scene)),
            AnyScene::Rough(scene) => rough.push((id(file), *scene)),
        }
    }
    let mut parts = Parts::of(&scenes, &rough);
    let mut progress = Progress::new("ledger, runs, references, maps");
    parts.compute(&scenes, &rough, |done| progress.set(done));
    drop(progress);
    let mut progress = Progress::new("methods timed");
    parts.take_times(&scenes, |done| progress.set(done));
    drop(progress);
    let sound = parts.papers.iter().flatten().all(|(_, sound)| *sound);
    let reached = parts.prepared.iter().flatten().all(|one| one.reached && one.measured.is_ok());
    let report = parts.report(&scenes, folder);
    save(path, &charts::page::render(&report).html)?;
    Ok(if sound && reached { Ending::Done } else { Ending::Stopped })
}

/// What the page is made of. Most parts wait for nothing and are computed side by side; times are taken afterwards,
/// while nothing else runs.
struct Parts {
    papers: Vec<Option<(PaperSection, bool)>>,
    prepared: Vec<Option<Prepared>>,
    rough: Vec<Option<SceneSection>>,
    stability: Option<Vec<Areas>>,
    approximations: Option<charts::Trajectory>,
    friction: Option<Vec<Areas>>,
    spheres: Option<Vec<Sphere>>,
    gains: Gains,
    drive: Drive,
}

impl Parts {
    fn of(scenes: &[(String, Scene)], rough: &[(String, RoughScene)]) -> Self {
        Parts {
            papers: papers::ALL.iter().map(|_| None).collect(),
            prepared: scenes.iter().map(|_| None).collect(),
            rough: rough.iter().map(|_| None).collect(),
            stability: None,
            approximations: None,
            friction: None,
            spheres: None,
            gains: Gains::default(),
            drive: Drive::default(),
        }
    }

    fn compute(&mut self, scenes: &[(String, Scene)], rough: &[(String, RoughScene)], done: impl FnMut(f64)) {
        let mut crew = Crew::default();
        for (place, paper) in self.papers.iter_mut().zip(papers::ALL) {
            crew.add(1.0, place, move || ledger::judged(paper));
        }
        for (place, scene) in self.prepared.iter_mut().zip(scenes) {
            crew.add(1.5, place, move || prepare(scene));
        }
        for (place, (id, scene)) in self.rough.iter_mut().zip(rough) {
            crew.add(0.3, place, move || rough::section(id, scene));
        }
        self.gains.enlist(&mut crew);
        self.drive.enlist(&mut crew);
        crew.add(1.5, &mut self.stability, || governors::stability().into_iter().map(pictures::stability).collect());
        crew.add(0.1, &mut self.approximations, || pictures::series_errors(&governors::series_errors()));
        crew.add(0.1, &mut self.friction, || regimes::maps::maps().into_iter().map(pictures::areas).collect());
        crew.add(0.2, &mut self.spheres, || sphere::all(scenes.iter().map(|(_, scene)| scene)));
        crew.work(done);
    }

    fn take_times(&mut self, scenes: &[(String, Scene)], mut done: impl FnMut(f64)) {
        let whole = (scenes.len() + 1) as f64;
        for (count, ((_, scene), prepared)) in scenes.iter().zip(self.prepared.iter_mut().flatten()).enumerate() {
            if let Ok(measured) = &mut prepared.measured {
                scene.take_times(measured, Axes::First, &Trials::default());
            }
            done((count + 1) as f64 / whole);
        }
        self.gains.take_times();
    }

    fn report(self, scenes: &[(String, Scene)], folder: &Path) -> Report {
        let mut report = titled("dalembert", SUMMARY);
        let mut digits = f64::INFINITY;
        for ((_, scene), Prepared { mut section, measured, .. }) in
            scenes.iter().zip(self.prepared.into_iter().flatten())
        {
            match measured {
                Ok(measured) => {
                    digits = digits.min(measured.reference.digits);
                    section.work = pictures::work_precision(scene, &measured).into();
                    section.note = pictures::measured_by(scene, &measured);
                }
                Err(failure) => section.note = format!("No chart, because the reference stopped: {failure}."),
            }
            report.scenes.push(section);
        }
        report.papers = self.papers.into_iter().flatten().map(|(section, _)| section).collect();
        report.rough = self.rough.into_iter().flatten().collect();
        report.stability = self.stability.unwrap_or_default();
        report.approximations = self.approximations.into_iter().collect();
        report.friction = self.friction.unwrap_or_default();
        report.spheres = self.spheres.unwrap_or_default();
        report.studies = vec![self.gains.study(), self.drive.study()];
        match timings::read(folder) {
            Ok(timings) => report.timings = vec![timings],
            Err(reason) => report.timings_missing = reason,
        }
        report.summary = format!("{} {}", report.summary, found(&report, digits));
        report
    }
}

const SUMMARY: &str = "Equations of motion derived from bodies and energies; every statement of a paper judged by exact \
                       arithmetic; every method on every scene measured by a reference that two methods confirm.";
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

/// A scene's section without its charts, whether its run reached the end, and the errors of its methods.
struct Prepared {
    section: SceneSection,
    reached: bool,
    measured: Result<Measured, Failure>,
}

fn prepare((id, scene): &(String, Scene)) -> Prepared {
    let run = scene.simulate(&scene.choice(), |_| ());
    let mut section = described(id, scene, &run);
    section.tables.extend(ladder(scene, &run));
    let reference = scene.reference(Axes::First, PATIENCE);
    let measured = reference.map(|reference| scene.judge_by(reference, Axes::First, &Trials::default()));
    Prepared { section, reached: run.outcome.reached(), measured }
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
