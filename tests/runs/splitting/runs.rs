//! The runs of the tests: scenes with their own motor or with another one.

use dalembert_derivations::studies::scene::Scene;
use integrators::{Method, Outcome, Span, Splitting, Tolerance, integrate};
use reader::Family;
use simulation::{Axes, Problem};
use std::path::Path;

/// Scenes by file and model, from no motor to all bars; they are nonlinear and not symmetric.
pub const SCENES: [(&str, Option<&str>); 6] = [
    ("constant_speed", None),
    ("free_rotor", None),
    ("asynchronous_drive", None),
    ("spin_up", Some("synchronous")),
    ("spin_up", Some("equivalent_windings")),
    ("pull_out", None),
];

pub fn scene(name: &str, model: Option<&str>) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
    let scene = Scene::open(&path).unwrap_or_else(|error| panic!("{error}"));
    model.map_or(scene.clone(), |model| scene.with_model(model).unwrap_or_else(|error| panic!("{error}")))
}

pub fn problem(name: &str, model: Option<&str>, axes: Axes) -> Problem {
    scene(name, model).problem(axes)
}

pub fn split(splitting: Splitting, steps: u32) -> Method {
    Method::Split { splitting, steps }
}

/// A run that must reach its end.
pub fn run(problem: &Problem, method: Method, span: &Span<'_, f64>) -> Outcome<f64> {
    let outcome = integrate(&*problem.law, method, &Tolerance::both(1e-9), span, &mut ());
    assert!(outcome.reached(), "{method}: {:?}", outcome.end);
    outcome
}

/// The largest error of a component of a state, relative to its magnitude plus one.
pub fn error(state: &[f64], exact: &[f64]) -> f64 {
    state.iter().zip(exact).map(|(y, e)| (y - e).abs() / (1.0 + e.abs())).fold(0.0, f64::max)
}
