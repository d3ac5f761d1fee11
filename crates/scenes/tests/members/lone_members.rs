//! Ensemble members whose law changes at events, contacts or diodes: each equals the run of a file with its values.

use super::{ensemble, rows, text, with};
use dalembert_scenes::ModelScene;
use simulation::IvpScene;

/// Final time and last row of the run of one file with its own method.
fn run_of(text: &str) -> (f64, Vec<f64>) {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = scene.run().choice();
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    assert_eq!(trajectory.stopped(), None);
    (trajectory.outcome.time, trajectory.last)
}

fn rows_are_runs(text: &str, edit: impl Fn(&str, &[f64]) -> String) {
    let all = rows(&ensemble(text), 2);
    for row in &all {
        let last = row.last.as_ref().unwrap_or_else(|| panic!("{row:?}"));
        let (time, shown) = run_of(&edit(text, &row.drawn));
        assert_eq!((row.stopped.as_ref(), last.time), (None, time));
        let found = last.state.iter().copied().map(Some).chain(last.derived.iter().copied());
        assert!(shown.iter().copied().map(Some).eq(found), "member {}", row.number);
    }
    assert_eq!(all, rows(&ensemble(text), 1));
}

#[test]
fn balls_bounce_each_with_its_own_restitution() {
    let ensemble = "members = 5\n[ensemble.vary]\nparameters.e = { from = \"0.75\", to = \"0.9\" }\nstart.y = { from = \"0.5 m\", to = \"2 m\" }\n";
    let short = with(&text("bouncing_ball", ensemble), "span = \"3 s\"", "span = \"1.5 s\"");
    rows_are_runs(&short, |text, drawn| {
        let [e, y] = drawn else { panic!("two numbers vary") };
        with(&with(text, "e = 0.8", &format!("e = {e:?}")), "y = \"1 m\"", &format!("y = \"{y:?} m\""))
    });
}

#[test]
fn sliders_stick_and_rectifiers_conduct_each_with_its_own_numbers() {
    let friction = "members = 3\n[ensemble.vary]\nparameters.mu = { from = \"0.05\", to = \"0.3\" }\n";
    rows_are_runs(&text("rough_slider_crank", friction), |text, drawn| {
        let line = text.lines().find(|line| line.starts_with("mu = ")).expect("it has friction");
        with(text, line, &format!("mu = {:?}", drawn[0]))
    });
    let load = "members = 3\n[ensemble.vary]\nparameters.c = { from = \"0.005 N m s\", to = \"0.02 N m s\" }\n";
    let short = with(&text("rectifier_drive", load), "span = \"0.1 s\"", "span = \"0.03 s\"");
    rows_are_runs(&short, |text, drawn| with(text, "c = \"0.01 N m s\"", &format!("c = \"{:?} N m s\"", drawn[0])));
}

/// Currents without inertia are completed from the values of each member.
#[test]
fn bridges_charge_capacitors_each_with_its_own_load() {
    let load = "members = 3\n[ensemble.vary]\nparameters.R = { from = \"50 ohm\", to = \"200 ohm\" }\n";
    let short = with(&text("bridge_rectifier", load), "span = \"0.05 s\"", "span = \"0.02 s\"");
    rows_are_runs(&short, |text, drawn| with(text, "R = \"100 ohm\"", &format!("R = \"{:?} ohm\"", drawn[0])));
}

/// A negative coefficient of friction stops its own member only, with a reason.
#[test]
fn a_member_that_cannot_start_says_why() {
    let friction = "members = 2\n[ensemble.vary]\nparameters.mu = { values = \"0.1 -0.1\" }\n";
    let found = rows(&ensemble(&text("rough_slider_crank", friction)), 2);
    assert_eq!(found[0].stopped, None);
    let why = found[1].stopped.as_deref().unwrap_or_default();
    assert!(why.contains("a coefficient of friction is negative"), "{why}");
}
