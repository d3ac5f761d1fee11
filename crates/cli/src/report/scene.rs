//! A scene in the report: its data, its run, its smaller models.

use crate::pictures;
use charts::{Parameter, SceneSection, Table, significant, tolerance};
use derivations::machines::Quantity;
use derivations::scene::{Axes, Measured, Scene, Trajectory, Trials};
use integrators::Failure;
use std::time::Duration;

/// References share the processors, so that one of them has less than when it is alone.
const PATIENCE: Duration = Duration::from_secs(15);

/// A scene's section without its charts, whether its run reached the end, and the errors of its methods.
pub struct Prepared {
    pub section: SceneSection,
    pub reached: bool,
    pub measured: Result<Measured, Failure>,
}

/// Runs a scene, computes its reference, and the errors of all methods by that.
pub fn prepare((id, scene): &(String, Scene)) -> Prepared {
    let run = scene.simulate(&scene.choice(), |_| ());
    let mut section = described(id, scene, &run);
    section.tables.extend(ladder(scene, &run));
    let reference = scene.reference(Axes::First, PATIENCE);
    let measured = reference.map(|reference| scene.judge_by(reference, Axes::First, &Trials::default()));
    Prepared { section, reached: run.outcome.reached(), measured }
}

/// A scene's section with its run and without its charts.
pub fn described(id: &str, scene: &Scene, run: &Trajectory) -> SceneSection {
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
