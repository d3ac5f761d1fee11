//! Scene files: the keys with which each opens, and the family of systems that reads the rest.

use super::issue::{Issue, SceneError};
use super::table::{At, Table};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::string::FromUtf8Error;
use units::nearest;

/// Bytes of a scene file: the largest that the project holds has a hundredth of them.
const MOST_BYTES: u64 = 1_000_000;

/// The key that marks a file whose system is written in it.
pub const MODEL: &str = "coordinates";

/// The keys with which every scene file opens.
pub struct Opening {
    pub title: String,
    /// The motion that the scene shows, and its difficulty.
    pub description: String,
    /// The name of the system.
    pub system: At<String>,
}

/// Systems that are read, run and shown in one way.
pub trait Family: Sized {
    /// The name of the family in messages: "a system with ...".
    const KIND: &'static str;

    /// (name in scene files, description) of each system.
    fn systems() -> Vec<(&'static str, &'static str)>;

    /// Reads the rest of a file whose system is of the family; errors go into the list.
    fn read(opening: Opening, top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self>;

    /// Reads a file.
    ///
    /// # Errors
    /// All that is wrong with it, each at its place.
    fn open(path: &Path) -> Result<Self, SceneError> {
        Self::parse(&path.display().to_string(), &read_text(path)?)
    }

    /// Reads a text; `name` is its name in messages.
    ///
    /// # Errors
    /// All that is wrong with it, each at its place.
    fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        parse(name, text)
    }
}

/// The text of a scene file, of a size that a scene has.
///
/// # Errors
/// Where there is no such file, or it is no text.
pub fn read_text(path: &Path) -> Result<String, SceneError> {
    let name = path.display().to_string();
    let needed = "a TOML file that describes a scene is accepted; the folder `scenes` holds examples";
    if path.is_dir() {
        return Err(SceneError::whole(&name, "this is a folder", needed));
    }
    // the size of a device cannot be asked for
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes));
    read.map_err(|error| SceneError::whole(&name, unreadable(&error), needed))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(SceneError::whole(&name, format!("this file has more than {MOST_BYTES} bytes"), needed));
    }
    String::from_utf8(bytes).map_err(|error| no_text(name, &error, needed))
}

/// The error at the first byte that is no text; for a file with zeros, which no editor writes, an error of the whole
/// file.
fn no_text(path: String, error: &FromUtf8Error, needed: &str) -> SceneError {
    let (bytes, start) = (error.as_bytes(), error.utf8_error().valid_up_to());
    if bytes.contains(&0) {
        return SceneError::whole(&path, format!("this is no text: {}", error.utf8_error()), needed);
    }
    // bytes that are not UTF-8 become one letter, and places before it stay
    let text = String::from_utf8_lossy(bytes).into_owned();
    let byte = bytes.get(start).copied().unwrap_or_default();
    let label = format!("the byte {byte:#04x}, in Latin-1 the letter {}", char::from(byte));
    let issue = Issue::at(start..start + char::REPLACEMENT_CHARACTER.len_utf8(), "this file is no UTF-8", label);
    SceneError { path, text, issues: vec![issue.accepted("a file that an editor saves as UTF-8")] }
}

/// Reads a text that opens with the name of a system.
pub fn parse<F: Family>(name: &str, text: &str) -> Result<F, SceneError> {
    tables(name, text, |top, issues| opening::<F>(top).and_then(|opening| F::read(opening, top, issues)))
}

/// Reads a text as TOML, and its tables by a reader; errors of either are returned together.
///
/// # Errors
/// All that is wrong with it, each at its place.
pub fn tables<T>(
    name: &str,
    text: &str,
    read: impl FnOnce(&mut Table<'_>, &mut Vec<Issue>) -> Option<T>,
) -> Result<T, SceneError> {
    if text.trim().is_empty() {
        return Err(SceneError::whole(name, "this file is empty", "the folder `scenes` holds examples"));
    }
    let (entries, errors) = toml::de::DeTable::parse_recoverable(text);
    // text after the first fault of syntax is often read wrongly because of it
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

/// The systems of a family, from its crate: messages can then tell a system of another command from an unknown one.
pub struct KnownSystems(pub fn() -> Vec<(&'static str, &'static str)>);

inventory::collect!(KnownSystems);

/// Whether any family has a system of this name.
fn is_known(name: &str) -> bool {
    inventory::iter::<KnownSystems>().any(|systems| systems.0().iter().any(|(known, _)| *known == name))
}

/// Whether a family has a system of this name.
pub fn knows<F: Family>(name: &str) -> bool {
    F::systems().iter().any(|(known, _)| *known == name)
}

/// The opening keys; `None` where the system is not of the family: its other keys cannot be judged then.
fn opening<F: Family>(top: &mut Table<'_>) -> Option<Opening> {
    let title = one_line(&top.text("title", "one line that says what happens").value);
    let description = top.optional_text("description", "what happens and why it is hard");
    top.read_allowed();
    if let (Some(span), false) = (top.place_of(MODEL), top.has("system")) {
        let title = "this command reads only scenes of the built-in systems";
        let issue = Issue::at(span, title, "this file has coordinates of its own");
        let accepted = "`derive`, `prove`, `conform`, `draw`, `export`, `watch`, `review`, `linearise`, `inverse`, `regulate`, `regimes`, `stationary`, `numerical-stability`, `run`, `ensemble`, `chart`, `choose` and `reference` read it";
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

/// A text on one line.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The systems of a family, the one that was probably meant first.
fn accepted<F: Family>(name: &str) -> String {
    let systems = F::systems();
    let list: Vec<String> = systems.iter().map(|(name, what)| format!("`{name}`: {what}")).collect();
    match nearest(name, systems.iter().map(|(known, _)| *known)) {
        Some(nearest) => format!("is `{nearest}` meant? Known: {}", list.join("; ")),
        None => format!("known: {}", list.join("; ")),
    }
}

/// The reason in words that are equal on every platform where it matters.
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
