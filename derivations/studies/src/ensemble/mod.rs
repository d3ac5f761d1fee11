//! Ensembles of scenes with a motor.
//!
//! # Overview
//! * [`open`]: reads a scene with a table `[ensemble]` from a file;
//! * [`known`]: the numbers that may vary;
//! * [`kind`]: the law with a symbol for each number that may vary; `driven_system`: the members.

mod driven_system;
pub mod kind;
pub mod known;

use crate::scene::Scene;
use reader::{Family, Issue, Opening, SceneError, Table};
use simulation::ensemble::EnsembleScene;
use simulation::models;
use std::path::Path;

/// Reads an ensemble file of any family of scenes.
///
/// # Errors
/// All faults of the file, with their positions.
pub fn open(path: &Path) -> Result<EnsembleScene, SceneError> {
    parse(&path.display().to_string(), &reader::read_text(path)?)
}

/// Reads an ensemble from a text; messages use `name` for it.
///
/// # Errors
/// All faults of the text, with their positions.
pub fn parse(name: &str, text: &str) -> Result<EnsembleScene, SceneError> {
    match models::readers() {
        Some(readers) if models::holds_model(text) => (readers.ensemble)(name, text),
        _ => reader::parse(name, text).map(|Driven(scene)| scene),
    }
}

/// An ensemble of a scene with a motor.
struct Driven(EnsembleScene);

impl Family for Driven {
    const KIND: &'static str = "a system with a motor, which ensembles have";

    fn systems() -> Vec<(&'static str, &'static str)> {
        Scene::systems()
    }

    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self> {
        driven_system::read(opening, top, issues).map(Driven)
    }
}
