//! Enclosed eigenvalues at steady motions beside closed forms and published figures.

use dalembert_scenes::ModelScene;
use dalembert_scenes::steady_motions::{EnclosedSpectrum, EnclosedVerdict, ZeroReason};

fn scene(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn spectrum(text: &str) -> EnclosedSpectrum {
    let scene = scene(text);
    EnclosedSpectrum::near(&scene.model, &scene.start, || true).unwrap_or_else(|why| panic!("{why}"))
}

const BICYCLE: &str = include_str!("../../../scenes/foreign/bicycle.toml");

/// Upright, the rear wheel turning so fast.
fn bicycle(rear: f64) -> EnclosedSpectrum {
    let upright = BICYCLE.replace("lean = \"0.05 rad\"", "lean = \"0 rad\"");
    spectrum(&upright.replace("\"-16.6 rad/s\"", &format!("\"{rear:?} rad/s\"")))
}

#[test]
fn bicycle_now() {
    let t = std::time::Instant::now();
    let found = bicycle(-5.0 / 0.3);
    eprintln!("{found:#?} {:?} {:?}", found.verdict(), t.elapsed());
}
