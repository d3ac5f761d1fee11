//! Scene files: the keys that every scene file has, and the families of built-in systems that read the other keys.

use super::issue::{Issue, SceneError};
use super::table::{At, Table};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::string::FromUtf8Error;
use units::nearest;

/// The largest size of a scene file in bytes, a hundred times the largest scene of the project.
const MOST_BYTES: u64 = 1_000_000;

/// The key that marks a file which describes its own system, in place of a built-in one.
pub const MODEL: &str = "coordinates";

/// The keys that every scene file has.
pub struct Opening {
    pub title: String,
    /// Describes the motion, and its numerical difficulty.
    pub description: String,
    /// The name of the built-in system.
    pub system: At<String>,
}

/// A family of built-in systems with a common reader.
pub trait Family: Sized {
    /// The name of the family in messages: "a system with ...".
    const KIND: &'static str;

    /// Returns (name in scene files, description) of each system.
    fn systems() -> Vec<(&'static str, &'static str)>;

    /// Reads the other keys of a file whose system belongs to the family. Errors are appended to `issues`.
    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self>;

    /// Reads a scene file.
    ///
    /// # Errors
    /// The file cannot be read, or contains errors; the result lists all errors with their positions.
    fn open(path: &Path) -> Result<Self, SceneError> {
        Self::parse(&path.display().to_string(), &read_text(path)?)
    }

    /// Reads the text of a scene file; messages call the file `name`.
    ///
    /// # Errors
    /// The result lists all errors of the text with their positions.
    fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        parse(name, text)
    }
}

/// Reads the text of a scene file.
///
/// # Errors
/// The file does not exist, cannot be read, is a folder, is larger than 1 MB, or is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, SceneError> {
    let name = path.display().to_string();
    let needed = "a TOML file that describes a scene is accepted; the folder `scenes` holds examples";
    if path.is_dir() {
        return Err(SceneError::whole(&name, "this is a folder", needed));
    }
    // read with a limit: a device has no size that could be checked first
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes));
    read.map_err(|error| SceneError::whole(&name, unreadable(&error), needed))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(SceneError::whole(&name, format!("this file has more than {MOST_BYTES} bytes"), needed));
    }
    String::from_utf8(bytes).map_err(|error| no_text(name, &error, needed))
}

/// Returns the error at the first byte that is not UTF-8. For a file with zero bytes, which is no text at all, the error concerns the whole file.
fn no_text(path: String, error: &FromUtf8Error, needed: &str) -> SceneError {
    let (bytes, start) = (error.as_bytes(), error.utf8_error().valid_up_to());
    if bytes.contains(&0) {
        return SceneError::whole(&path, format!("this is no text: {}", error.utf8_error()), needed);
    }
    // each invalid byte becomes one replacement character; earlier positions do not change
    let text = String::from_utf8_lossy(bytes).into_owned();
    let byte = bytes.get(start).copied().unwrap_or_default();
    let label = format!("the byte {byte:#04x}, in Latin-1 the letter {}", char::from(byte));
    let issue = Issue::at(start..start + char::REPLACEMENT_CHARACTER.len_utf8(), "this file is no UTF-8", label);
    SceneError { path, text, issues: vec![issue.accepted("a file that an editor saves as UTF-8")] }
}

/// Reads the text of a scene file of the family `F`; messages call the file `name`.
///
/// # Errors
/// The result lists all errors of the text with their positions.
pub fn parse<F: Family>(name: &str, text: &str) -> Result<F, SceneError> {
    tables(name, text, |top, issues| opening::<F>(top).and_then(|opening| F::read(opening, top, issues)))
}

/// Parses a text as TOML, and reads its tables with the function `read`.
///
/// # Errors
/// The result lists all errors of the text with their positions; after an error of the TOML syntax only this one.
pub fn tables<T>(
    name: &str,
    text: &str,
    read: impl FnOnce(&mut Table<'_>, &mut Vec<Issue>) -> Option<T>,
) -> Result<T, SceneError> {
    if text.trim().is_empty() {
        return Err(SceneError::whole(name, "this file is empty", "the folder `scenes` holds examples"));
    }
    let (entries, errors) = toml::de::DeTable::parse_recoverable(text);
    // later syntax errors are often consequences of the first
    let mut issues: Vec<Issue> = errors.iter().take(1).map(of_syntax).collect();
    let mut scene = None;
    if issues.is_empty() {
        let mut top = Table::top(text, &entries);
        scene = read(&mut top, &mut issues);
        issues.extend(top.finish());
    }
    issues.sort_by_key(|issue| issue.span.as_ref().map_or(0, |span| span.start));
    match scene {
        Some(scene) if issues.is_empty() => Ok(scene),
        _ => Err(SceneError { path: name.to_owned(), text: text.to_owned(), issues }),
    }
}

/// The systems of a family, registered by its crate. With this list a message distinguishes a system of another family from an unknown name.
pub struct KnownSystems(pub fn() -> Vec<(&'static str, &'static str)>);

inventory::collect!(KnownSystems);

/// Returns whether any registered family has a system of this name.
fn is_known(name: &str) -> bool {
    inventory::iter::<KnownSystems>().any(|systems| systems.0().iter().any(|(known, _)| *known == name))
}

/// Returns whether the family `F` has a system of this name.
pub fn knows<F: Family>(name: &str) -> bool {
    F::systems().iter().any(|(known, _)| *known == name)
}

/// Reads the common keys. Returns `None` if the system does not belong to the family `F`, since its other keys cannot be checked then.
fn opening<F: Family>(top: &mut Table<'_>) -> Option<Opening> {
    let title = one_line(&top.text("title", "one line that says what happens").value);
    let description = top.optional_text("description", "what happens and why it is hard");
    top.read_allowed();
    if let (Some(span), false) = (top.place_of(MODEL), top.has("system")) {
        let title = "this command reads only scenes of the built-in systems";
        let issue = Issue::at(span, title, "this file has coordinates of its own");
        let accepted = "commands that accept this file: `derive`, `prove`, `conform`, `draw`, `export`, `watch`, `review`, `linearise`, `inverse`, `regulate`, `regimes`, `stationary`, `numerical-stability`, `run`, `ensemble`, `chart`, `choose` and `reference`";
        top.report(issue.accepted(accepted));
        top.known_all();
        return None;
    }
    let system = top.text("system", "name of what moves");
    let name = system.value.as_str();
    if knows::<F>(name) {
        let description = description.map_or_else(String::new, |text| text.value.trim().to_owned());
        return Some(Opening { title, description, system });
    }
    if !name.is_empty() {
        let title = match is_known(name) {
            true => format!("`{name}` is not {}", F::KIND),
            false => format!("unknown system `{name}`"),
        };
        top.report(Issue::at(system.span.clone(), title, "not accepted here").accepted(accepted::<F>(name)));
    }
    top.known_all();
    None
}

/// Replaces every sequence of white space, including line breaks, by one space.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Returns the list of systems for a message, preceded by the name most similar to `name`.
fn accepted<F: Family>(name: &str) -> String {
    let systems = F::systems();
    let list: Vec<String> = systems.iter().map(|(name, what)| format!("`{name}`: {what}")).collect();
    match nearest(name, systems.iter().map(|(known, _)| *known)) {
        Some(nearest) => format!("is `{nearest}` meant? Known: {}", list.join("; ")),
        None => format!("known: {}", list.join("; ")),
    }
}

/// Returns the reason of an error, with wording that does not depend on the platform for the two most frequent reasons.
fn unreadable(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::PermissionDenied => "this file may not be read".to_owned(),
        _ => error.to_string(),
    }
}

fn of_syntax(error: &toml::de::Error) -> Issue {
    Issue::at(error.span().unwrap_or(0..0), "this is not TOML", error.message())
}
