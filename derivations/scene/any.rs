//! A scene of any family: the one place that lists the families.

use super::file::{self, Family, Opening, knows};
use super::issue::Issue;
use super::read::Table;
use super::{MechanismScene, Scene, SceneError, Smooth};
use crate::ensemble::EnsembleScene;
use crate::friction::RoughScene;
use std::fmt;
use std::sync::{Arc, OnceLock};

/// A scene of any family.
#[derive(Clone, Debug)]
pub enum AnyScene {
    /// With a motor.
    Driven(Box<Scene>),
    /// With rough contacts.
    Rough(Box<RoughScene>),
    /// Governors, drives, bodies that roll.
    Mechanism(Box<MechanismScene>),
    /// A system that is written in the file.
    Model(Arc<dyn Modelled>),
}

/// A scene whose system is data.
pub trait Modelled: Smooth + fmt::Debug {}

/// Reads a text, which messages call by the first argument.
type Reader<T> = fn(&str, &str) -> Result<T, SceneError>;

/// Readers of files whose system is written in them.
#[derive(Clone, Copy, Debug)]
pub struct ModelReaders {
    pub scene: Reader<Arc<dyn Modelled>>,
    pub ensemble: Reader<EnsembleScene>,
}

/// The key by which a file is known whose system is written in it.
pub(super) const MODEL: &str = "coordinates";

static MODEL_READERS: OnceLock<ModelReaders> = OnceLock::new();

/// Gives files with `[coordinates]` their readers; the first ones given hold.
pub fn read_models_by(readers: ModelReaders) {
    MODEL_READERS.get_or_init(|| readers);
}

/// An ensemble of whatever family.
pub(crate) fn parse_ensemble(name: &str, text: &str) -> Result<EnsembleScene, SceneError> {
    match MODEL_READERS.get() {
        Some(readers) if holds_model(text) => (readers.ensemble)(name, text),
        _ => file::parse(name, text),
    }
}

impl Family for AnyScene {
    const KIND: &'static str = "a system";

    fn systems() -> Vec<(&'static str, &'static str)> {
        [Scene::systems(), RoughScene::systems(), MechanismScene::systems()].concat()
    }

    fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        match MODEL_READERS.get() {
            Some(readers) if holds_model(text) => (readers.scene)(name, text).map(Self::Model),
            _ => file::parse(name, text),
        }
    }

    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self> {
        match opening.system.value.as_str() {
            rough if knows::<RoughScene>(rough) => {
                RoughScene::read(opening, top, issues).map(Box::new).map(Self::Rough)
            }
            one if knows::<MechanismScene>(one) => {
                MechanismScene::read(opening, top, issues).map(Box::new).map(Self::Mechanism)
            }
            _ => Scene::read(opening, top, issues).map(Box::new).map(Self::Driven),
        }
    }
}

impl AnyScene {
    /// The scene's title.
    pub fn title(&self) -> &str {
        match self {
            Self::Driven(scene) => &scene.title,
            Self::Rough(scene) => &scene.title,
            Self::Mechanism(scene) => scene.title(),
            Self::Model(scene) => scene.title(),
        }
    }

    /// As one initial value problem, where it is one: with rough contacts it is many.
    pub fn smooth(&self) -> Option<&dyn Smooth> {
        match self {
            Self::Driven(scene) => Some(&**scene),
            Self::Mechanism(scene) => Some(&**scene),
            Self::Model(scene) => Some(&**scene),
            Self::Rough(_) => None,
        }
    }
}

/// Whether a file holds its own system: it names coordinates, and no system of the list.
pub fn holds_model(text: &str) -> bool {
    let (entries, _) = toml::de::DeTable::parse_recoverable(text);
    entries.get_ref().contains_key(MODEL) && !entries.get_ref().contains_key("system")
}
