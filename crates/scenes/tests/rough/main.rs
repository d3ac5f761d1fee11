//! Contacts with Coulomb friction on systems that are text: beside the program's own rough systems, closed forms, and other texts.

mod belts;
mod bounces;
mod exact;
mod feet;
mod guides;
mod impacts;
mod ladders;
mod rational_regimes;
mod refusals;
mod regimes;
mod space;
mod stools;
mod tripods;

use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Choice, Smooth, Trajectory};

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

/// A rod of the length 2 l with one end on a rough line.
fn rod(angle: &str, spin: &str, slide: f64) -> String {
    format!(
        "title = \"rod\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\nf = \"2\"\n\
         [coordinates]\nx = \"m\"\ny = \"m\"\ntheta = \"rad\"\n[frames]\nR = \"N turned theta about z\"\n\
         [points]\nG = \"O + x*N.x + y*N.y\"\nE = \"G - l*R.x\"\n\
         [bodies.rod]\nframe = \"R\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"m*l^2/3\"\n\
         [[contact]]\nname = \"end\"\nof = \"rod at E\"\nthrough = \"O\"\nnormal = \"N.y\"\nfriction = \"f\"\ntouching = true\n\
         [outputs]\nsliding = \"sliding(end)\"\n\
         [start]\ntheta = \"{angle}\"\n\"theta'\" = \"{spin}\"\n\"x'\" = \"guess {slide} m/s\"\n\
         [run]\nspan = \"1 s\"\ntolerance = 1e-10\n"
    )
}
