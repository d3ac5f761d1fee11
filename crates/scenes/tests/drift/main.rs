//! Projection onto constraints in runs: residuals, errors, energies, events, allocations.

mod allocations;
mod errors;
mod events;
mod residuals;

// registers the motors of the catalogue
use dalembert_scenes::ModelScene;
use integrators::Method;
use machines as _;
use simulation::work_precision::{Formulation, SharedIndex2Dae, Treated};
use simulation::{IvpScene, Law};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use studies as _;

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name).with_extension("toml")
}

fn parsed(text: &str) -> ModelScene {
    ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"))
}

fn scene(name: &str) -> ModelScene {
    parsed(&std::fs::read_to_string(path(name)).expect("it is there"))
}

/// The law of a scene without projection onto its constraints.
fn plain(scene: &ModelScene) -> Arc<dyn Law> {
    let ways = scene.ways().into_iter();
    let found = ways.filter(|way| way.formulation == Formulation::IndexReduced).find_map(|way| match way.law {
        Treated::Free(law) => Some(law),
        _ => None,
    });
    found.expect("it is offered")
}

/// The constraints that a run of a scene enforces: those of positions, and the rates of all.
fn kept(scene: &ModelScene) -> Arc<dyn SharedIndex2Dae> {
    let found = scene.ways().into_iter().find_map(|way| match way.law {
        Treated::Held(law) => Some(law),
        _ => None,
    });
    found.expect("it is offered")
}

/// One method of each kind.
const METHODS: [Method; 11] = [
    Method::Taylor,
    Method::DormandPrince8,
    Method::DormandPrince5,
    Method::Verner9,
    Method::GraggBulirschStoer,
    Method::Radau5,
    Method::Kvaerno5,
    Method::Rodas4,
    Method::BaderDeuflhard,
    Method::RadauIIA { stages: 3 },
    Method::Gauss { stages: 3 },
];
