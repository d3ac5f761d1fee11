//! Linear equations, equilibria and inverse dynamics of scene files, compared with closed forms and with the compiled equations.

mod closed_forms;
mod differences;
mod equilibria;
mod forces;
mod free_frames;
mod instants;
mod multipliers;
mod reactions;
mod steady_currents;
mod voltages;

// registers the motors of the catalogue
use dalembert_scenes::ModelScene;
use dalembert_scenes::linearisation::{Linearisation, VariedEquations};
use machines as _;
use model::Model;
use std::path::{Path, PathBuf};

fn scene(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn stored(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name).with_extension("toml")
}

fn linear(model: &Model, state: &[f64], inputs: &[usize]) -> (VariedEquations, Linearisation) {
    let equations = VariedEquations::of(model, inputs).unwrap_or_else(|why| panic!("{why}"));
    let found = equations.linearised(equations.point(0.0, state)).unwrap_or_else(|why| panic!("{why}"));
    (equations, found)
}

/// An inverted pendulum on a cart with a force: x'' = (F - m g a)/M, a'' = ((M + m) g a - F)/(M l).
const CART: &str = "title = \"A cart with a pole\"\ngravity = \"-g*N.y\"\n[parameters]\nM = \"1.5 kg\"\nm = \"0.25 kg\"\nl = \"0.5 m\"\ng = \"9.8 m/s^2\"\n\
    F = \"0 N\"\n[coordinates]\nx = \"m\"\na = \"rad\"\n[points]\nC = \"O + x*N.x\"\nP = \"C + l*(sin(a)*N.x + cos(a)*N.y)\"\n\
    [bodies.cart]\ncentre = \"C\"\nmass = \"M\"\n[bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n[[force]]\non = \"cart\"\nis = \"F*N.x\"\n\
    [outputs]\ntip = \"x + l*sin(a)\"\npull = \"rate(x')\"\n[run]\nspan = \"1 s\"\n";
