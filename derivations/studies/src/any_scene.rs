//! A scene of any family. All families are listed here only.

use crate::scene::Scene;
use reader::{Family, Issue, Opening, SceneError, Table};
use simulation::IvpScene;
use simulation::models::{self, Modelled};
use std::sync::Arc;

/// A scene of any family.
#[derive(Clone, Debug)]
pub enum AnyScene {
    /// A gyrostat or a bench with a motor.
    Driven(Box<Scene>),
    /// A system defined by text in its file.
    Model(Arc<dyn Modelled>),
}

impl Family for AnyScene {
    const KIND: &'static str = "a system";

    fn systems() -> Vec<(&'static str, &'static str)> {
        Scene::systems()
    }

    fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        match models::readers() {
            Some(readers) if models::holds_model(text) => (readers.scene)(name, text).map(Self::Model),
            _ => reader::parse(name, text),
        }
    }

    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self> {
        Scene::read(opening, top, issues).map(Box::new).map(Self::Driven)
    }
}

impl AnyScene {
    /// The scene's title.
    pub fn title(&self) -> &str {
        match self {
            Self::Driven(scene) => &scene.title,
            Self::Model(scene) => scene.title(),
        }
    }

    /// The scene as an initial value problem.
    pub fn smooth(&self) -> &dyn IvpScene {
        match self {
            Self::Driven(scene) => &**scene,
            Self::Model(scene) => &**scene,
        }
    }
}
