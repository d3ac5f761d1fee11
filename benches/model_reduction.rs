//! Effectivity of the error estimates of reduced models, which is the estimate divided by the true error: for the
//! scenes with a motor, for 1,000 random motors, and for 1,000 random text models, for which the chosen models are
//! evaluated too. Run it by `cargo bench --bench model_reduction`, optionally followed by another number, and by
//! `texts` for the text models only.

#[path = "../tests/motions/model_reduction/drawn.rs"]
mod drawn;
#[path = "../tests/motions/model_reduction/drawn_texts.rs"]
mod drawn_texts;
#[path = "model_reduction/texts.rs"]
mod texts;

use dalembert_derivations::studies::model_reduction::sampled_run::{followed_at, instants};
use dalembert_derivations::studies::model_reduction::{Hierarchy, Loss};
use dalembert_derivations::studies::scene::Scene;
use integrators::Tolerance;
use reader::Family;
use simulation::Axes;
use std::collections::BTreeMap;
use std::path::Path;

const SCENES: [&str; 7] =
    ["bench", "spin_up", "pull_out", "hanging_rest", "permanent_rotation", "stiff_damper", "asynchronous_drive"];
/// The tolerance of reference runs, and the least error that is compared with them.
const TIGHT: f64 = 1e-11;
const LEAST: f64 = 1e-8;
/// The classes of estimates, by the fraction that the second order contributes.
const DOUBTS: [f64; 3] = [0.1, 0.5, f64::INFINITY];

/// A reduced model of a scene: (name, true error, first order, second order).
type Seen = (&'static str, f64, f64, f64);

fn main() {
    let count = std::env::args().find_map(|word| word.parse().ok()).unwrap_or(1_000);
    if std::env::args().any(|word| word == "texts") {
        return texts::survey(count);
    }
    println!("scene               model                             true error  estimate  effectivity  2nd/1st");
    for name in SCENES {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
        let Ok(scene) = Scene::open(&path) else { continue };
        for (model, error, first, second) in seen(&scene).0 {
            let (effectivity, doubt) = (first / error, second / first);
            println!("{name:<19} {model:<33} {error:>10.2e} {first:>9.2e} {effectivity:>12.4} {doubt:>8.1e}");
        }
    }
    let mut by_doubt: [Vec<f64>; DOUBTS.len()] = Default::default();
    let mut by_model: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    let mut lost = 0;
    for seed in 0..count {
        let Ok(scene) = Scene::parse("drawn", &drawn::scene(seed)) else { continue };
        let (all, without) = seen(&scene);
        lost += without;
        for (model, error, first, second) in all {
            let place = DOUBTS.iter().position(|most| second / first <= *most).unwrap_or(DOUBTS.len() - 1);
            by_doubt[place].push(first / error);
            if place < 2 {
                by_model.entry(model).or_default().push(first / error);
            }
        }
    }
    println!("\n{count} random motors: quantiles of the effectivity index\n");
    println!("                                    number       1 %       5 %      50 %      95 %      99 %");
    for (most, found) in DOUBTS.iter().zip(&mut by_doubt) {
        row(&format!("second order up to {most} of the first"), found);
    }
    for (model, found) in &mut by_model {
        row(model, found);
    }
    println!("without a run or an estimate: {lost}\n");
    texts::survey(count);
}

fn row(name: &str, found: &mut [f64]) {
    found.sort_by(f64::total_cmp);
    let quantile = |q: f64| found.get((found.len().saturating_sub(1) as f64 * q).round() as usize);
    let cell = |q| quantile(q).map_or(format!("{:>10}", "-"), |value| format!("{value:>10.4}"));
    let cells = [0.01, 0.05, 0.5, 0.95, 0.99].map(cell).concat();
    println!("{name:<36}{:>6}{cells}", found.len());
}

/// The effectivities for every approximate reduced model, and the number of models without an estimate.
fn seen(scene: &Scene) -> (Vec<Seen>, usize) {
    let ladder = Hierarchy::of_scene(scene, Axes::First);
    let span = ladder.own.span;
    let (mut all, mut lost) = (Vec::new(), 0);
    let Ok((watched, _)) = ladder.watched(&scene.run.outputs) else { return (all, 1) };
    for reduced in ladder.models.iter().filter(|reduced| matches!(reduced.loss, Loss::Small { .. })) {
        let estimate = ladder.estimate(reduced, &watched, 1e-6);
        // also the time at which the estimate is largest
        let mut times: Vec<f64> = instants(span).chain(estimate.as_ref().ok().map(|found| found.at)).collect();
        times.retain(|time| *time > 0.0);
        times.sort_by(f64::total_cmp);
        times.dedup();
        let run = |law, start: &Vec<f64>| followed_at(law, &Tolerance::both(TIGHT), &times, start);
        match (run(&*reduced.law, &reduced.start), run(&*ladder.law, &ladder.start), estimate) {
            (Ok((low, _)), Ok((exact, _)), Ok(found)) => {
                let error = ladder.difference(reduced, &low, &exact, &watched);
                if error > LEAST {
                    all.push((reduced.name, error, found.first, found.second));
                }
            }
            _ => lost += 1,
        }
    }
    (all, lost)
}
