//! Model reduction: exact lumping, error estimates, choice of the model.

mod choice;
mod drawn;
mod drawn_texts;
mod estimates;
mod fed;
mod governors;
mod lumping;
mod text_models;

use dalembert_derivations::studies::AnyScene;
use dalembert_derivations::studies::model_reduction::outputs::Watched;
use dalembert_derivations::studies::model_reduction::sampled_run::{followed, followed_at, instants};
use dalembert_derivations::studies::model_reduction::{Estimate, Hierarchy, ReducedModel};
use dalembert_derivations::studies::scene::Scene;
use integrators::{Record, Tolerance};
use reader::Family;
use simulation::Axes;
use std::path::PathBuf;

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml")
}

fn scene(name: &str) -> Scene {
    Scene::open(&path(name)).unwrap_or_else(|error| panic!("{error}"))
}

/// The hierarchy of a text model over another span.
fn of_mechanism(name: &str, span: &str) -> Hierarchy {
    scenes::register(|_| ());
    let text = std::fs::read_to_string(path(name)).expect("a scene");
    let lines = text.lines().map(|line| if line.starts_with("span") { span } else { line });
    match AnyScene::parse(name, &lines.collect::<Vec<_>>().join("\n")) {
        Ok(AnyScene::Model(scene)) => Hierarchy::of_model(&*scene),
        _ => panic!("{name} is a scene of a mechanism"),
    }
}

fn ladder(scene: &Scene) -> Hierarchy {
    Hierarchy::of_scene(scene, Axes::First)
}

/// A tolerance tight enough for every error that is compared here.
fn tight() -> Tolerance {
    Tolerance::both(1e-11)
}

fn exactly(ladder: &Hierarchy) -> Record<f64> {
    followed(&*ladder.law, &tight(), ladder.own.span, &ladder.start).expect("it reaches its end").0
}

/// The full model's states at these times, the last of which is the end.
fn exactly_at(ladder: &Hierarchy, times: &[f64]) -> Record<f64> {
    followed_at(&*ladder.law, &tight(), times, &ladder.start).expect("it reaches its end").0
}

/// The true error of a reduced model, from runs of both models: at the sampled instants, and where the estimate is
/// largest.
fn truly(ladder: &Hierarchy, reduced: &ReducedModel, found: &Estimate, watched: &Watched) -> Option<f64> {
    let mut times: Vec<f64> = instants(ladder.own.span).chain((found.at > 0.0).then_some(found.at)).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let (low, _) = followed_at(&*reduced.law, &tight(), &times, &reduced.start).ok()?;
    Some(ladder.difference(reduced, &low, &exactly_at(ladder, &times), watched))
}

/// The largest error of a reduced model's run after correction by the first-order estimate, at the sampled times.
fn corrected(ladder: &Hierarchy, found: &Estimate, watched: &Watched) -> f64 {
    let times: Vec<f64> = found.corrected.iter().map(|(time, _)| *time).collect();
    let exact = exactly_at(ladder, &times);
    let rows = found.corrected.iter().zip(exact.times.iter().zip(&exact.states));
    rows.map(|((_, row), (time, y))| watched.off(row, &ladder.row(*time, y))).fold(0.0, f64::max)
}
