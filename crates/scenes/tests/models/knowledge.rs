//! Additional knowledge about a system: theory, a closed form, an end of the law, and a name.

use dalembert_scenes::ModelScene;
use simulation::knowledge::{ClosedForm, Diagnosis, Knowledge, submit};
use simulation::models::Modelled;
use simulation::{Axes, IvpScene, Margin, RunNotes, Trajectory};

submit! { Knowledge {
    name: "falling_stone",
    summary: "a stone that falls to the ground",
    parameters: &["g"],
    columns: &["y"],
    equations: &[],
    theory: |scene, choice| {
        vec![format!("it falls for {:.3} s; {} is exact", fall(scene), choice.method)]
    },
    diagnosis: |ended| {
        let lies = ended.has_left_its_law() && ended.last("y").abs() < 1e-9;
        lies.then(|| Diagnosis { what: "it lies".to_owned(), at: Some(fall(ended.scene)) })
    },
    closed_form: |scene, time| {
        let y = height(scene) - value(scene, "g") * time * time / 2.0;
        Some(ClosedForm { what: "Galilei's law", values: vec![("y", y)] })
    },
    margins: |_, names| {
        let place = names.iter().position(|name| name == "y")?;
        let speed = place + names.len() / 2;
        let margin = move |state: &[f64]| Margin {
            value: state[place],
            rate: state[speed],
            what: "the stone is on the ground",
            ..Margin::default()
        };
        Some(Box::new(move |_, state, _| vec![margin(state)]))
    },
} }

fn value(scene: &dyn Modelled, name: &str) -> f64 {
    scene.value(name).expect("it has a value")
}

fn height(scene: &dyn Modelled) -> f64 {
    value(scene, "y")
}

fn fall(scene: &dyn Modelled) -> f64 {
    (2.0 * height(scene) / value(scene, "g")).sqrt()
}

const STONE: &str = "title = \"a stone\"\nknown_as = \"falling_stone\"\ngravity = \"-g*N.y\"\n\n[parameters]\ng = \"10 m/s^2\"\n\n\
    [coordinates]\ny = \"m\"\n\n[bodies.stone]\ncentre = \"O + y*N.y\"\nmass = \"(1 kg)\"\n\n[start]\ny = \"5 m\"\n\n\
    [run]\nspan = \"0.9 s\"\n";

fn run(text: &str) -> (Trajectory, RunNotes) {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = scene.run().choice();
    let trajectory = scene.problem(Axes::First).simulate(&choice, |_| ());
    let told = scene.told(&choice, &trajectory);
    (trajectory, told)
}

#[test]
fn a_run_that_reaches_its_end_has_theory_and_a_closed_form() {
    let (trajectory, told) = run(STONE);
    assert!(trajectory.outcome.reached(), "{:?}", trajectory.stopped());
    assert_eq!(told.theory, ["it falls for 1.000 s; Dormand-Prince 8(5,3) is exact"]);
    assert_eq!(told.diagnosis, None);
    assert!(told.closed_form.is_some_and(|(what, off)| what == "Galilei's law" && off < 1e-12), "{told:?}");
}

#[test]
fn a_run_that_leaves_its_law_is_diagnosed_beside_the_closed_form() {
    let (trajectory, told) = run(&STONE.replace("0.9 s", "2 s"));
    assert_eq!(trajectory.left, Some("the stone is on the ground"));
    assert!((trajectory.outcome.time - 1.0).abs() < 1e-12, "{}", trajectory.outcome.time);
    let diagnosis = told.diagnosis.expect("it is named");
    assert!(diagnosis.starts_with("it lies; by the closed form at t = 1.000000000000 s"), "{diagnosis}");
}

#[test]
fn a_run_that_an_event_ends_is_diagnosed_by_its_event_where_nothing_else_is_known() {
    let event = "[[event]]\nname = \"low\"\nwhen = \"y - (1 m)\"\nend = true\n\n[start]";
    let (trajectory, told) = run(&STONE.replace("[start]", event));
    assert!(trajectory.outcome.reached() && trajectory.left.is_none());
    assert!((trajectory.outcome.time - 0.8_f64.sqrt()).abs() < 1e-12, "{}", trajectory.outcome.time);
    assert_eq!(told.diagnosis.as_deref(), Some("the event `low` ends the run"));
}

#[test]
fn without_the_key_nothing_is_known() {
    let (trajectory, told) = run(&STONE.replace("known_as = \"falling_stone\"\n", "").replace("0.9 s", "2 s"));
    assert!(trajectory.outcome.reached());
    assert_eq!(told, RunNotes::default());
}
