//! The time per step of the splitting methods in units of a step of the classical Runge-Kutta method, measured
//! alternately: `cargo bench --bench steps`. Also the times at equal accuracy, for a run with the error 1e-6.

use dalembert_derivations::studies::scene::Scene;
use integrators::{Method, Span, Splitting, Tolerance, integrate, interleaved};
use reader::Family;
use simulation::Axes;
use std::path::Path;
use std::time::Duration;

const STEPS: u32 = 20_000;

fn main() {
    println!("{:<20} {:>7} {:>12}  a step as a multiple of that", "scene", "states", "RK4 step, ns");
    for name in ["constant_speed", "free_rotor", "asynchronous_drive", "pull_out"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
        match Scene::open(&path) {
            Ok(scene) => row(name, &scene),
            Err(error) => println!("{error}"),
        }
    }
}

fn row(name: &str, scene: &Scene) {
    let problem = scene.problem(Axes::First);
    let split = Splitting::ALL.map(|splitting| Method::Split { splitting, steps: STEPS });
    let methods: Vec<Method> = [Method::RungeKutta4 { steps: STEPS }].into_iter().chain(split).collect();
    let span = Span::new(0.0, scene.run.span, &problem.state);
    let tolerance = Tolerance::both(1e-9);
    let run = |index: usize| integrate(&*problem.law, methods[index], &tolerance, &span, &mut ()).reached();
    let times = interleaved(methods.len(), Duration::from_secs(4), run);
    let seconds: Vec<f64> = times.iter().map(|time| time.map_or(f64::NAN, |median| median.seconds)).collect();
    print!("{name:<20} {:>7} {:>12.0} ", problem.state.len(), seconds[0] / f64::from(STEPS) * 1e9);
    for (method, time) in Splitting::ALL.iter().zip(&seconds[1..]) {
        print!(" {} {:.2}", method.name(), time / seconds[0]);
    }
    println!();
}
