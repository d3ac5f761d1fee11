//! Reactions of constraints in loads and events, compared with motions in coordinates without constraints and with closed forms.

mod beside;
mod dry_friction;
mod refusals;
mod touches;

use ::machines as _;
use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, IvpScene, Trajectory};

fn scene(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn runs_by(text: &str, method: Method) -> Trajectory {
    let scene = scene(text);
    let choice = Choice { method, tolerance: 1e-12, ..scene.run().choice() };
    let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
    assert_eq!(trajectory.stopped(), None, "{method}");
    trajectory
}

fn runs(text: &str) -> Trajectory {
    runs_by(text, Method::DormandPrince8)
}

fn last(trajectory: &Trajectory, name: &str) -> f64 {
    trajectory.last[trajectory.column(name).unwrap_or_else(|| panic!("{name}"))]
}

fn close(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} and {known}");
}

/// A bead on the parabola y = a x^2 with a force.
fn bead(definitions: &str, force: &str, rest: &str) -> String {
    format!(
        "title = \"bead\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"0.3 kg\"\na = \"2 1/m\"\nmu = \"0.2\"\nc = \"0.4 s/m\"\n\
         g = \"9.81 m/s^2\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n\
         [definitions]\n{definitions}\n[bodies]\nbead = {{ centre = \"P\", mass = \"m\" }}\n\
         [[constraint]]\nname = \"wire\"\nzero = \"y - a*x^2\"\n[[force]]\non = \"bead\"\nis = \"{force}\"\n\
         [start]\nx = \"1 m\"\n{rest}\n[run]\nspan = \"2 s\"\n"
    )
}
