//! The readers of files whose system is written in them.

use crate::ensemble::EnsembleScene;
use crate::ivp_scene::IvpScene;
use crate::law::SymbolicLaw;
use reader::{MODEL, SceneError, read_text};
use std::fmt;
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// A scene whose system is data.
pub trait Modelled: IvpScene + fmt::Debug {
    /// The law over expressions; of one that changes at events, the law of the start.
    fn symbolic_law(&self) -> Arc<dyn SymbolicLaw>;

    /// Whether that law is written down, holds all along a motion, and is short enough to be rewritten.
    fn is_written(&self) -> bool;

    /// Whether one of these columns of a run depends on each state.
    fn states_behind(&self, columns: &[String]) -> Vec<bool>;

    /// The name under which there is knowledge of the system, where its file gives one: see [`crate::knowledge`].
    fn known_as(&self) -> Option<&'static str>;

    /// A parameter, or a coordinate or a speed at the start, by its name, in SI units.
    fn value(&self, name: &str) -> Option<f64>;

    /// The scene with other values of these.
    ///
    /// # Errors
    /// The unknown name, or why there is no start.
    fn with_values(&self, values: &[(&str, f64)]) -> Result<Arc<dyn Modelled>, String>;

    /// The scene without some of its elements, and with others rigid.
    ///
    /// # Errors
    /// The name of no parameter, or why there is no such scene.
    fn in_the_limit(&self, limit: Limit<'_>) -> Result<Arc<dyn Modelled>, String>;
}

/// Parameters at the ends of their ranges.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limit<'a> {
    /// Zero for good: conditions which then choose nothing are not watched.
    pub zero: &'a [&'a str],
    /// Without bound, for springs and dampers: their elongation, or its rate, is held at zero.
    pub unbounded: &'a [&'a str],
}

/// Reads a text, which messages call by the first argument.
type Reader<T> = fn(&str, &str) -> Result<T, SceneError>;

/// Readers of files whose system is written in them.
#[derive(Clone, Copy, Debug)]
pub struct ModelReaders {
    pub scene: Reader<Arc<dyn Modelled>>,
    pub ensemble: Reader<EnsembleScene>,
    /// Whether a system of this name runs as a model that a crate builds.
    pub runs: fn(&str) -> bool,
    /// Whether a crate builds a model for this name, run or not.
    pub knows: fn(&str) -> bool,
}

static READERS: OnceLock<ModelReaders> = OnceLock::new();

/// Gives files with `[coordinates]` their readers; only the first call has an effect.
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

/// Whether the system of a file runs as a model: the file names coordinates, or a system that a crate builds.
pub fn holds_model(text: &str) -> bool {
    holds(text, |readers, name| (readers.runs)(name))
}

/// Whether there is a model for questions on the equations of a file, for any law that its scene runs.
pub fn has_model(text: &str) -> bool {
    holds(text, |readers, name| (readers.knows)(name))
}

fn holds(text: &str, named: impl Fn(&ModelReaders, &str) -> bool) -> bool {
    let (entries, _) = toml::de::DeTable::parse_recoverable(text);
    match entries.get_ref().get("system") {
        None => entries.get_ref().contains_key(MODEL),
        Some(name) => name.get_ref().as_str().is_some_and(|name| readers().is_some_and(|readers| named(readers, name))),
    }
}
