//! Drives and circuits in scene files, compared with closed forms and with formulations by energies.

mod changing_laws;
mod circuits;
mod gears;
mod held_by_constraints;
mod machines;
mod one_ways;
mod program_motors;
mod refusals;
mod without_inertia;

use ::machines as _;
use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, IvpScene, Trajectory};

fn runs(text: &str) -> Trajectory {
    let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice { method: Method::DormandPrince8, tolerance: 1e-12, ..scene.run().choice() };
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    assert_eq!(trajectory.stopped(), None);
    trajectory
}

fn stored(name: &str) -> String {
    let path = format!("{}/../../scenes/models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn last(trajectory: &Trajectory, name: &str) -> f64 {
    trajectory.last[trajectory.column(name).unwrap_or_else(|| panic!("{name}"))]
}

fn close(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} and {known}");
}

/// A motor that turns a disc with the moment of inertia 1e-4 kg m^2.
fn motor(parameters: &str, drive: &str) -> String {
    format!(
        "title = \"motor\"\n[parameters]\nJ = \"1e-4 kg m^2\"\nU = \"12 V\"\n{parameters}[coordinates]\ntheta = \"rad\"\n\
         [bodies.disc]\nturns = \"theta\"\ninertia = \"J\"\n[[drive]]\nname = \"motor\"\nturns = \"theta\"\n{drive}\
         [run]\nspan = \"0.05 s\"\n"
    )
}
