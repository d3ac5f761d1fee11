//! The ladder of models: what is lumped without loss, what an estimate is worth, what is chosen.

mod choice;
mod drawn;
mod estimates;
mod fed;
mod governors;
mod lumping;
mod rough;

use derivations::ladder::followed::followed;
use derivations::ladder::watched::Watched;
use derivations::ladder::{Ladder, Rung};
use derivations::scene::{AnyScene, Axes, Family, MechanismScene, Scene};
use integrators::{Record, Tolerance};
use std::path::PathBuf;

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml")
}

fn scene(name: &str) -> Scene {
    Scene::open(&path(name)).unwrap_or_else(|error| panic!("{error}"))
}

fn mechanism(name: &str, span: &str) -> MechanismScene {
    let text = std::fs::read_to_string(path(name)).expect("a scene");
    let lines = text.lines().map(|line| if line.starts_with("span") { span } else { line });
    match AnyScene::parse(name, &lines.collect::<Vec<_>>().join("\n")) {
        Ok(AnyScene::Mechanism(scene)) => *scene,
        _ => panic!("{name} is a scene of a mechanism"),
    }
}

fn ladder(scene: &Scene) -> Ladder {
    Ladder::of_scene(scene, Axes::First)
}

/// Tight enough for any error that is compared here.
fn tight() -> Tolerance {
    Tolerance::both(1e-11)
}

fn exactly(ladder: &Ladder) -> Record<f64> {
    followed(&*ladder.law, &tight(), ladder.own.span, &ladder.start).expect("it reaches its end").0
}

/// What a rung is truly off, by runs of both models.
fn truly(ladder: &Ladder, rung: &Rung, exact: &Record<f64>, watched: &Watched) -> Option<f64> {
    let (low, _) = followed(&*rung.law, &tight(), ladder.own.span, &rung.start).ok()?;
    Some(ladder.difference(rung, &low, exact, watched))
}
