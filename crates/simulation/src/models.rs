//! The interface to readers of files that define a system by text.

use crate::ensemble::EnsembleScene;
use crate::ivp_scene::IvpScene;
use crate::law::SymbolicLaw;
use reader::{MODEL, SceneError, read_text};
use std::fmt;
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// A scene whose system is defined by a file.
pub trait Modelled: IvpScene + fmt::Debug {
    /// The symbolic law; for a law that changes at events, the law at the start.
    fn symbolic_law(&self) -> Arc<dyn SymbolicLaw>;

    /// Whether that law has explicit expressions, is valid throughout the motion, and is short enough to be rewritten.
    fn is_written(&self) -> bool;

    /// For each state, whether one of these columns of a run depends on it.
    fn states_behind(&self, columns: &[String]) -> Vec<bool>;

    /// The name of the [`crate::knowledge`] of the system, if its file gives one.
    fn known_as(&self) -> Option<&'static str>;

    /// The value of a parameter, or of a coordinate or a speed at the start, by name, in SI units.
    fn value(&self, name: &str) -> Option<f64>;

    /// The scene with other values of parameters or of the start, in SI units.
    ///
    /// # Errors
    /// The unknown name, or the reason why there is no start.
    fn with_values(&self, values: &[(&str, f64)]) -> Result<Arc<dyn Modelled>, String>;

    /// The scene in a limit: some elements removed, others rigid.
    ///
    /// # Errors
    /// A name that is no parameter, or the reason why there is no such scene.
    fn in_the_limit(&self, limit: Limit<'_>) -> Result<Arc<dyn Modelled>, String>;
}

/// Parameters in a limit.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limit<'a> {
    /// Parameters that are zero: conditions that thereby become irrelevant are not watched.
    pub zero: &'a [&'a str],
    /// Parameters of springs and dampers that tend to infinity: their elongation, or its rate, is constrained to zero.
    pub unbounded: &'a [&'a str],
}

/// Reads a text; the first argument is its name in messages.
type Reader<T> = fn(&str, &str) -> Result<T, SceneError>;

/// The readers of files that define a system by text.
#[derive(Clone, Copy, Debug)]
pub struct ModelReaders {
    pub scene: Reader<Arc<dyn Modelled>>,
    pub ensemble: Reader<EnsembleScene>,
    /// Whether a crate provides a system of this name whose scene runs as a model.
    pub runs: fn(&str) -> bool,
    /// Whether a crate provides a model for this name, run or not.
    pub knows: fn(&str) -> bool,
}

static READERS: OnceLock<ModelReaders> = OnceLock::new();

/// Registers the readers of files with `[coordinates]`. Only the first call has an effect.
pub fn read_models_by(readers: ModelReaders) {
    READERS.get_or_init(|| readers);
}

/// The registered readers; `None` if no crate has registered any.
pub fn readers() -> Option<&'static ModelReaders> {
    READERS.get()
}

/// Opens a file that defines a system.
///
/// # Errors
/// All faults of the file, with their positions.
pub fn open(path: &Path) -> Result<Arc<dyn Modelled>, SceneError> {
    let (text, name) = (read_text(path)?, path.display().to_string());
    match readers() {
        Some(readers) if holds_model(&text) => (readers.scene)(&name, &text),
        Some(_) => Err(SceneError::whole(&name, "this file holds no system of its own", ACCEPTED)),
        None => Err(SceneError::whole(&name, "no reader of such files is given", "one is given by `read_models_by`")),
    }
}

const ACCEPTED: &str = "a file with [coordinates] is accepted; the folder `scenes/models` holds examples";

/// Whether the system of a file runs as a model: the file has coordinates, or names a system that a crate provides.
pub fn holds_model(text: &str) -> bool {
    holds(text, |readers, name| (readers.runs)(name))
}

/// Whether there is a model with the equations of a file, whatever law its scene runs.
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
