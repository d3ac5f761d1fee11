//! The readers of files whose system is written in them.

use crate::ensemble::EnsembleScene;
use crate::law::SymbolicLaw;
use crate::smooth::Smooth;
use reader::{MODEL, SceneError};
use std::fmt;
use std::sync::{Arc, OnceLock};

/// A scene whose system is data.
pub trait Modelled: Smooth + fmt::Debug {
    /// The law over expressions; of one that changes at events, the law of the start.
    fn symbolic_law(&self) -> Arc<dyn SymbolicLaw>;
}

/// Reads a text, which messages call by the first argument.
type Reader<T> = fn(&str, &str) -> Result<T, SceneError>;

/// Readers of files whose system is written in them.
#[derive(Clone, Copy, Debug)]
pub struct ModelReaders {
    pub scene: Reader<Arc<dyn Modelled>>,
    pub ensemble: Reader<EnsembleScene>,
}

static READERS: OnceLock<ModelReaders> = OnceLock::new();

/// Gives files with `[coordinates]` their readers; the first ones given hold.
pub fn read_models_by(readers: ModelReaders) {
    READERS.get_or_init(|| readers);
}

/// The readers, where they were given.
pub fn readers() -> Option<&'static ModelReaders> {
    READERS.get()
}

/// Whether a file holds its own system: it names coordinates, and no system of a list.
pub fn holds_model(text: &str) -> bool {
    let (entries, _) = toml::de::DeTable::parse_recoverable(text);
    entries.get_ref().contains_key(MODEL) && !entries.get_ref().contains_key("system")
}
