//! Linear equations at times of a run: behind events, and up to the end of the run.

use super::{scene, stored};
use dalembert_scenes::linearisation::points::{NoInstance, along};
use simulation::IvpScene;
use std::time::Duration;

const ALLOWED: Duration = Duration::from_secs(60);

fn at(text: &str, time: f64) -> Result<Vec<f64>, NoInstance> {
    along(&scene(text), &[time], ALLOWED).map(|found| found[0].1.clone())
}

fn text(name: &str) -> String {
    std::fs::read_to_string(stored(&format!("models/{name}"))).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn instants_behind_events_are_those_of_the_run() {
    let text = text("bouncing_ball");
    let scene = scene(&text);
    let choice = simulation::Choice { tolerance: 1e-11, ..scene.run().choice() };
    let run = scene.problem(choice.axes).simulate(&choice, |_| {});
    let place = run.times.len() * 2 / 3;
    let state = at(&text, run.times[place]).unwrap_or_else(|why| panic!("{why}"));
    assert!(run.passages.iter().any(|passage| passage.time > 0.0 && passage.time < run.times[place]));
    state
        .iter()
        .zip(&run.rows[place])
        .for_each(|(found, known)| assert!((found - known).abs() < 1e-8, "{found} {known}"));
}

#[test]
fn an_instant_at_which_friction_holds_has_no_linear_equations() {
    let held = at(&text("dry_friction"), 23.0);
    assert!(matches!(held, Err(NoInstance::Held { switch: 0, .. })), "{held:?}");
    assert!(at(&text("dry_friction"), 2.0).is_ok());
}

/// Two equal cranks under a rod as long as the distance of their pivots; all links become collinear.
#[test]
fn an_instant_behind_a_singular_position_is_none_of_the_run() {
    let text = "title = \"parallelogram\"\n[parameters]\nl = \"0.1 m\"\nd = \"0.3 m\"\nJ = \"0.01 kg m^2\"\n\
                [coordinates]\na = \"rad\"\nb = \"rad\"\n[points]\nP = \"O + l*(cos(a)*N.x + sin(a)*N.y)\"\n\
                Q = \"O + d*N.x + l*(cos(b)*N.x + sin(b)*N.y)\"\n[bodies.first]\nturns = \"a\"\ninertia = \"J\"\n\
                [bodies.second]\nturns = \"b\"\ninertia = \"J\"\n[[constraint]]\nzero = \"distance(P, Q) - d\"\n\
                [start]\na = \"60 deg\"\nb = \"60 deg\"\n\"a'\" = \"2 rad/s\"\n\"b'\" = \"2 rad/s\"\n[run]\nspan = \"3 s\"\n";
    assert!(at(text, 0.5).is_ok());
    let ended = at(text, 2.0);
    assert!(
        matches!(ended, Err(NoInstance::Ended { time, .. }) if (time - std::f64::consts::FRAC_PI_3).abs() < 1e-2),
        "{ended:?}"
    );
}
