//! Scenes: a system, a machine, parameters with units, an initial state and a span of time, read from a TOML file.
//!
//! # Overview
//! * [`Scene`]: the checked data; [`Scene::open`] reads a file and tells *all* that is wrong with it, each at its place;
//! * [`units`], [`quantity`]: `"0.02 kg m^2"`;
//! * [`read`], [`issue`]: tables with places, and messages with marks under the value;
//! * [`bodies`], [`machine`], [`start`], [`run`]: the tables of a scene;
//! * [`state`]: the initial state in the axes of either form of the equations, and results back in the axes of the data;
//! * [`problem`], [`simulate`]: the law that any method integrates, and the run;
//! * [`measured`]: every method on a scene, speed against accuracy.

pub mod bodies;
pub mod issue;
pub mod machine;
pub mod measured;
pub mod methods;
pub mod problem;
pub mod quantity;
pub mod read;
pub mod run;
pub mod simulate;
pub mod start;
pub mod state;
pub mod units;

pub use issue::{Issue, SceneError, nearest};
pub use machine::{MachineData, NoModel};
pub use measured::{Measured, Trials};
pub use problem::{Invariant, Problem};
pub use run::Run;
pub use simulate::{Choice, Trajectory};
pub use start::Start;
pub use state::Axes;

use crate::friction::{Rough, RoughScene};
use crate::machines::AnyMachine;
use crate::systems::gyrostat::Gyrostat;
use read::Table;
use std::io;
use std::path::Path;

/// What moves.
#[derive(Clone, Debug, PartialEq)]
pub enum System {
    /// A gyrostat with a motor between carrier and rotor.
    Gyrostat(Box<Gyrostat<f64>>),
    /// A motor alone: a housing at rest, and a rotor with this moment of inertia about its axis, kg m^2.
    Bench { axial: f64 },
}

/// A scene whose data are all admissible.
#[derive(Clone, Debug)]
pub struct Scene {
    pub title: String,
    /// What happens and why it is hard.
    pub description: String,
    pub system: System,
    pub machine: AnyMachine,
    /// The machine's data as they were given: what other machines can be made of.
    pub machine_data: MachineData,
    pub start: Start,
    pub run: Run,
}

impl System {
    /// (name in scene files, what it is).
    pub const LIST: &'static [(&'static str, &'static str)] = &[
        ("gyrostat", "a heavy gyrostat with a fixed point and a motor that drives its rotor"),
        ("bench", "a motor alone, its housing at rest"),
    ];
}

impl Scene {
    /// Reads a file.
    pub fn open(path: &Path) -> Result<Self, SceneError> {
        read_file(path, Self::read)
    }

    /// Reads a text; `name` is what messages call it.
    pub fn parse(name: &str, text: &str) -> Result<Self, SceneError> {
        read_text(name, text, Self::read)
    }

    fn read(top: &mut Table<'_>, issues: &mut Vec<Issue>) -> Option<Self> {
        let title = top.text("title", "one line that says what happens").value;
        let description = top.optional_text("description", "what happens and why it is hard");
        let name = top.text("system", "name of what moves: `gyrostat` or `bench`");
        let system = match name.value.as_str() {
            "gyrostat" => bodies::gyrostat(top, issues).map(|bodies| System::Gyrostat(Box::new(bodies))),
            "bench" => bodies::bench(top, issues).map(|axial| System::Bench { axial }),
            "" => None,
            rough if Rough::knows(rough) => {
                let title = format!("`{rough}` has rough contacts and no machine");
                let issue = Issue::at(name.span, title, "not accepted here");
                top.report(issue.accepted("`dalembert run` and `dalembert regimes` take such a scene"));
                top.known_all();
                return None;
            }
            other => {
                let known: Vec<String> = System::LIST.iter().map(|(name, what)| format!("`{name}`: {what}")).collect();
                let issue = Issue::at(name.span, format!("unknown system `{other}`"), "not known");
                top.report(issue.accepted(known.join("; ")));
                top.known(&["gravity", "carrier", "rotor", "machine", "start", "run"]);
                return None;
            }
        };
        let machine = machine::read(top, issues);
        let on_bench = name.value == "bench";
        let start = start::read(top, issues, on_bench, machine.as_ref().map(|(machine, _)| machine));
        let run = run::read(top, issues, on_bench, machine.as_ref().map(|(machine, _)| machine));
        let ((machine, machine_data), system) = (machine?, system?);
        let description = description.map_or_else(String::new, |text| text.value.trim().to_owned());
        Some(Scene { title, description, system, machine, machine_data, start: start?, run: run? })
    }
}

/// How the top of a file becomes a scene of some kind; what is wrong goes into the list.
type Reader<T> = fn(&mut Table<'_>, &mut Vec<Issue>) -> Option<T>;

/// Reads a file.
pub(crate) fn read_file<T>(path: &Path, read: Reader<T>) -> Result<T, SceneError> {
    let name = path.display().to_string();
    let needed = "a TOML file that describes a scene is accepted; the folder `scenes` holds examples";
    if path.is_dir() {
        return Err(SceneError::whole(&name, "this is a folder", needed));
    }
    let bytes = std::fs::read(path).map_err(|error| SceneError::whole(&name, unreadable(&error), needed))?;
    let text = String::from_utf8(bytes)
        .map_err(|error| SceneError::whole(&name, format!("this is no text: {}", error.utf8_error()), needed))?;
    read_text(&name, &text, read)
}

/// Reads a text; `name` is what messages call it.
pub(crate) fn read_text<T>(name: &str, text: &str, read: Reader<T>) -> Result<T, SceneError> {
    if text.trim().is_empty() {
        return Err(SceneError::whole(name, "this file is empty", "the folder `scenes` holds examples"));
    }
    let (entries, errors) = toml::de::DeTable::parse_recoverable(text);
    let mut issues: Vec<Issue> = errors.iter().map(of_syntax).collect();
    let mut scene = None;
    if issues.is_empty() {
        let mut top = Table::top(&entries);
        scene = read(&mut top, &mut issues);
        issues.extend(top.finish());
    }
    issues.sort_by_key(|issue| issue.span.as_ref().map_or(0, |span| span.start));
    match scene {
        Some(scene) if issues.is_empty() => Ok(scene),
        _ => Err(SceneError { path: name.to_owned(), text: text.to_owned(), issues }),
    }
}

/// A scene of either kind.
#[derive(Clone, Debug)]
pub enum AnyScene {
    /// With a machine.
    Driven(Box<Scene>),
    /// With rough contacts.
    Rough(Box<RoughScene>),
}

impl AnyScene {
    /// Reads a file; its `system` says of which kind it is.
    pub fn open(path: &Path) -> Result<Self, SceneError> {
        let is_rough = std::fs::read_to_string(path).is_ok_and(|text| names_a_rough_system(&text));
        if is_rough {
            RoughScene::open(path).map(|scene| Self::Rough(Box::new(scene)))
        } else {
            Scene::open(path).map(|s| Self::Driven(Box::new(s)))
        }
    }
}

fn names_a_rough_system(text: &str) -> bool {
    let (entries, _) = toml::de::DeTable::parse_recoverable(text);
    entries.get_ref().get("system").is_some_and(|value| value.get_ref().as_str().is_some_and(Rough::knows))
}

/// In the same words on every system where it matters.
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
