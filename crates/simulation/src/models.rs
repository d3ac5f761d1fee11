//! The readers of files whose system is written in them.

use crate::ensemble::EnsembleScene;
use crate::law::SymbolicLaw;
use crate::smooth::Smooth;
use reader::{MODEL, SceneError, read_text};
use std::fmt;
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// A scene whose system is data.
pub trait Modelled: Smooth + fmt::Debug {
    /// The law over expressions; of one that changes at events, the law of the start.
    fn symbolic_law(&self) -> Arc<dyn SymbolicLaw>;

    /// The name under which more is known of it, where its file gives one: see [`crate::knowledge`].
    fn known_as(&self) -> Option<&'static str>;

    /// A parameter, or a coordinate or a speed at the start, by its name, in SI units.
    fn value(&self, name: &str) -> Option<f64>;

    /// The scene with other values of these.
    ///
    /// # Errors
    /// The name that it does not know, or why nothing starts so.
    fn with_values(&self, values: &[(&str, f64)]) -> Result<Arc<dyn Modelled>, String>;
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

/// Opens a file whose system is written in it.
///
/// # Errors
/// All that is wrong with it, each at its place.
pub fn open(path: &Path) -> Result<Arc<dyn Modelled>, SceneError> {
    let (text, name) = (read_text(path)?, path.display().to_string());
    match readers() {
        Some(readers) if holds_model(&text) => (readers.scene)(&name, &text),
        Some(_) => Err(SceneError::whole(&name, "this file holds no system of its own", ACCEPTED)),
        None => Err(SceneError::whole(&name, "no reader of such files is given", "one is given by `read_models_by`")),
    }
}

const ACCEPTED: &str = "a file with [coordinates] is accepted; the folder `scenes/models` holds examples";

/// Whether a file holds its own system: it names coordinates, and no system of a list.
pub fn holds_model(text: &str) -> bool {
    let (entries, _) = toml::de::DeTable::parse_recoverable(text);
    entries.get_ref().contains_key(MODEL) && !entries.get_ref().contains_key("system")
}
