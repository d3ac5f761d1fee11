//! Contacts with Coulomb friction in systems as text, compared with closed forms, with references of many digits, and with equivalent texts.

mod alternating_impacts;
mod belts;
mod bounces;
mod closed_forms;
mod exact;
mod feet;
mod guides;
mod impacts;
mod ladders;
mod rational_regimes;
mod references;
mod refusals;
mod regimes;
mod simultaneous_impacts;
mod space;
mod starts;
mod stools;
mod tripods;

use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, IvpScene, Trajectory};

const METHODS: [Method; 3] = [Method::DormandPrince8, Method::Taylor, Method::Radau5];

fn runs(text: &str, method: Method, tolerance: f64) -> Trajectory {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { method, tolerance, ..scene.run().choice() };
    scene.problem(choice.axes).simulate(&choice, |_| {})
}

fn stored(name: &str) -> String {
    let path = format!("{}/../../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A stored text with other values of parameters, of its start and of its run.
fn edited(name: &str, values: &[(&str, &str)]) -> String {
    let mut section = String::new();
    let mut left = values.to_vec();
    let mut lines = Vec::new();
    for line in stored(name).lines() {
        if line.starts_with('[') {
            section = line.to_owned();
        }
        let key = line.split(" = ").next().unwrap_or_default();
        let place = left.iter().position(|(known, _)| *known == key);
        match place.filter(|_| ["[parameters]", "[start]", "[run]"].contains(&&*section)) {
            Some(place) => lines.push(format!("{key} = \"{}\"", left.remove(place).1)),
            None => lines.push(line.to_owned()),
        }
    }
    assert!(left.is_empty(), "{name} has no {left:?}");
    lines.join("\n")
}

fn last(trajectory: &Trajectory, name: &str) -> f64 {
    trajectory.last[trajectory.column(name).unwrap_or_else(|| panic!("{name}"))]
}

fn close(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} and {known}");
}

/// The times of the events of a run, without its start.
fn events(trajectory: &Trajectory) -> Vec<f64> {
    trajectory.passages.iter().skip(1).map(|passage| passage.time).collect()
}

/// A rod with one end on a rough line, at an angle, with an angular velocity and the speed of the end in m/s.
fn rod(angle: &str, spin: &str, slide: f64) -> String {
    let slide = format!("{slide} m/s");
    edited("friction/jam", &[("theta", angle), ("\"theta'\"", spin), ("\"x'\"", &slide)])
}
