//! A scene in the report: its data, its run, its reduced models.

use crate::pictures;
use crate::speed::tables::floors;
use crate::summary::{EventReport, told_passages};
use charts::{Parameter, SceneSection, Table, significant, tolerance};
use integrators::Failure;
use simulation::events::Passage;
use simulation::references::Unknown;
use simulation::work_precision::judged_across_events;
use simulation::{Atlas, Axes, IvpScene, Stored, Trajectory, Trials, judged};
use std::time::Duration;
use studies::AnyScene;
use studies::scene::Scene;

/// The time limit for a reference of a scene with a motor. References are computed in parallel, so that each takes longer than alone.
const PATIENCE: Duration = Duration::from_secs(15);
/// The time limit for a reference of a system that is defined in its file; `dalembert chart` allows more.
const OF_A_MECHANISM: Duration = Duration::from_secs(8);
/// The largest number of evaluations in one run of such a system, whose law is expensive.
const EVALUATIONS: u64 = 20_000;
/// The time for measuring times of a scene with a motor, and of any other scene.
const TIMED: [Duration; 2] = [Duration::from_millis(800), Duration::from_millis(500)];

/// The section of a scene without its charts, the outcome of its run, and the errors of all methods.
pub struct Prepared {
    pub section: SceneSection,
    /// Whether the law changes at events.
    pub across_events: bool,
    /// A message where the result is not as expected.
    pub unreached: Option<String>,
    pub atlas: Result<Atlas, NoReference>,
    pub trials: Trials,
    /// The time for measuring the times of the runs.
    pub timed: Duration,
}

/// A scene with the reference that is stored next to its file.
pub struct Read {
    pub id: String,
    pub scene: AnyScene,
    pub kept: Option<Stored>,
}

/// The reason for which methods are not compared on a scene.
pub enum NoReference {
    Stopped(Failure),
    /// No reference across the events could be computed.
    Unknown(Unknown),
    /// The run ends early for a known reason.
    Ends,
}

/// Runs a scene, computes its reference, and computes the errors of all methods against it.
pub fn prepare(Read { id, scene: any, kept }: &Read) -> Prepared {
    let scene = any.smooth();
    let choice = scene.run().choice();
    let problem = scene.problem(Axes::First);
    let run = problem.simulate(&choice, |_| ());
    let mut section = described(id, scene, &run);
    let of_a_mechanism = matches!(any, AnyScene::Model(_));
    let across_events = scene.hybrid().is_some();
    let usual = Trials::default().with(scene.run().method);
    let [motor, mechanism] = TIMED;
    let (patience, timed, trials) = match of_a_mechanism {
        true => (OF_A_MECHANISM, mechanism, Trials { evaluations: EVALUATIONS, ..usual }),
        false => (PATIENCE, motor, usual),
    };
    // a scene may demonstrate a failure; its early end is then not a fault
    let atlas = match (scene.told(&choice, &run).diagnosis, scene.hybrid()) {
        (Some(_), None) => Err(NoReference::Ends),
        (_, Some(hybrid)) => {
            judged_across_events(hybrid, &trials, kept.as_ref(), patience).map_err(NoReference::Unknown)
        }
        (None, None) => {
            judged(&|reference| scene.observed(reference), &problem, scene.ways(), &trials, kept.as_ref(), patience)
                .map_err(NoReference::Stopped)
        }
    };
    if let AnyScene::Driven(scene) = any {
        section.tables.extend(ladder(scene, &run, atlas.as_ref().ok()));
    }
    let unreached = match &atlas {
        Err(NoReference::Ends) => None,
        // not a fault: a reference across events may need more time than the report allows; the page says so
        Err(NoReference::Unknown(_)) => None,
        Err(NoReference::Stopped(failure)) if of_a_mechanism && failure.is_broken_off() => None,
        Err(NoReference::Stopped(failure)) => Some(format!("its reference stopped: {failure}")),
        // not a fault: a motion may end where its law ends, for example by jamming; the reference confirms it, and the page says so
        Ok(_) if run.left.is_some() => None,
        Ok(_) => run.stopped().map(|why| format!("its run stopped: {why}")),
    };
    let unreached = unreached.map(|why| format!("{id}: {why}"));
    Prepared { section, across_events, unreached, atlas, trials, timed }
}

/// The section of a scene with its run, without its charts.
pub fn described(id: &str, scene: &dyn IvpScene, run: &Trajectory) -> SceneSection {
    let parameters = scene.parameters().into_iter().map(|datum| Parameter {
        symbol: datum.name.replace('_', " "),
        value: datum.value,
        unit: datum.unit.to_string(),
        meaning: datum.meaning.to_string(),
    });
    SceneSection {
        id: id.to_owned(),
        title: scene.title().to_owned(),
        description: scene.description().to_owned(),
        parameters: parameters.collect(),
        facts: facts(scene, run),
        tables: if run.passages.is_empty() { Vec::new() } else { vec![log(run)] },
        trajectory: Some(pictures::trajectory(scene, run)),
        ..Default::default()
    }
}

/// The table of the events of a run, each with the law after it, and of its end.
fn log(run: &Trajectory) -> Table {
    let time = |time: f64| format!("{time:.6}");
    let events = told_passages(&run.passages).into_iter().map(|told| match told {
        EventReport::Passage(Passage { time: at, what, then, .. }) => {
            vec![time(*at), what.clone(), then.clone().unwrap_or_default()]
        }
        EventReport::LeftOut(count) => vec![String::new(), format!("{count} more"), String::new()],
    });
    let end = run.stopped().unwrap_or_else(|| "the end of the run".to_owned());
    Table {
        caption: "What happened, and why".to_owned(),
        head: ["Time, s", "What happened", "From here on"].map(String::from).into(),
        rows: events.chain([vec![time(run.outcome.time), end, String::new()]]).collect(),
    }
}

fn facts(scene: &dyn IvpScene, run: &Trajectory) -> Vec<(String, String)> {
    let choice = scene.run().choice();
    let told = scene.told(&choice, run);
    let mut facts = vec![
        ("model".to_owned(), scene.model().replace('_', " ")),
        ("method".to_owned(), format!("{}, tolerance {}", choice.method, tolerance(choice.tolerance))),
        ("work".to_owned(), run.outcome.work.to_string()),
    ];
    facts.extend(told.theory.into_iter().map(|said| ("theory".to_owned(), said)));
    facts.extend(run.stopped().map(|why| ("stopped".to_owned(), why)));
    facts.extend(told.diagnosis.map(|what| ("diagnosis".to_owned(), what)));
    let failures = told.failures.into_iter();
    facts.extend(
        failures
            .flat_map(|failure| [("failure".to_owned(), failure.to_string()), ("remedy".to_owned(), failure.remedy)]),
    );
    for deviation in &run.outcome.deviations {
        let kept = match deviation.largest.is_finite() {
            true => format!("changed by at most {}", significant(deviation.largest, 2)),
            false => format!("without a value at {} s", significant(deviation.at, 6)),
        };
        facts.push((deviation.name.replace('_', " "), kept));
    }
    if let Some((what, deviation)) = told.closed_form {
        facts.push(("closed form".to_owned(), format!("off by {} from {what}", significant(deviation, 2))));
    }
    facts
}

/// The table of reduced models of the scene's motor: states, evaluations, difference of the run; `None` where there are none.
fn ladder(scene: &Scene, run: &Trajectory, atlas: Option<&Atlas>) -> Option<Table> {
    let models = scene.given.models();
    let floors = atlas.map(floors).unwrap_or_default();
    let floor = |model: &str| floors.iter().find(|(known, _)| *known == model).map_or("—", |(_, said)| said).to_owned();
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
            Some(failure) => failure.name().to_owned(),
        };
        rows.push(vec![model.replace('_', " "), states, other.outcome.work.rates.to_string(), row, floor(model)]);
    }
    let head =
        ["Model", "States", "Evaluations", "Largest difference of \u{3c9} or \u{3c6}\u{307}, rad/s", "In the charts"];
    let caption = format!("The same scene with smaller models than {}", scene.machine.name().replace('_', " "));
    (!rows.is_empty()).then(|| Table { caption, head: head.map(String::from).into(), rows })
}

/// The largest difference, over all samples, of the angular velocities and the speed of the rotor, which all models have, in rad/s.
fn difference(a: &Trajectory, b: &Trajectory) -> f64 {
    let common = ["w1", "w2", "w3", "rotor_speed"].into_iter();
    let columns: Vec<(usize, usize)> = common.filter_map(|name| Some((a.column(name)?, b.column(name)?))).collect();
    let rows = a.rows.iter().zip(&b.rows);
    rows.flat_map(|(a, b)| columns.iter().map(|&(i, j)| (a[i] - b[j]).abs())).fold(0.0, f64::max)
}
