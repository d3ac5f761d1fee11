//! Functional mock-up units (FMU) of FMI 3.0 or 2.0: model description, C sources, and binary.
//!
//! The caller supplies the C functions of the system. The functions of the standard, in `sources/`, call them; those of FMI 2.0 call those of
//! FMI 3.0.

mod binary;
mod description;

pub use binary::{Binary, NoBinary};

use crate::archive::{self, Entry, Seal};
use siphasher::sip128::{Hasher128, SipHasher13};
use std::fmt::Write as _;
use std::hash::Hasher;
use std::io::{self, Write};

/// A variable of a unit.
#[derive(Clone, Debug)]
pub struct Variable {
    pub name: String,
    /// The coherent SI unit; `1` for a pure number.
    pub unit: String,
    pub description: String,
    /// The initial value, in `unit`; zero for a dependent variable.
    pub value: f64,
}

/// A version of the FMI standard.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Version {
    Two,
    #[default]
    Three,
}

impl Version {
    /// The name of the source file that is compiled; it includes the others.
    pub(crate) fn main_source(self) -> &'static str {
        match self {
            Version::Two => "fmi2.c",
            Version::Three => "fmi3.c",
        }
    }
}

/// A system as a functional mock-up unit.
#[derive(Clone, Debug)]
pub struct Unit {
    pub version: Version,
    /// The model identifier, an identifier of C.
    pub identifier: String,
    pub title: String,
    /// The origin of the unit in one line, for comments.
    pub origin: String,
    /// The name of the program that writes the unit.
    pub tool: String,
    /// The default tolerance, the error allowed in a step.
    pub tolerance: f64,
    /// The duration of a default simulation in seconds.
    pub span: f64,
    pub states: Vec<Variable>,
    pub parameters: Vec<Variable>,
    pub inputs: Vec<Variable>,
    /// Outputs of the unit.
    pub outputs: Vec<Variable>,
    /// Further dependent quantities, such as energies, which are not outputs of the unit.
    pub locals: Vec<Variable>,
    /// Event indicators: first those of conditions, then those of events; their descriptions are used in messages.
    pub indicators: Vec<Variable>,
    /// The C functions of the system.
    pub source: String,
}

/// The source files with the functions of the standard.
const SOURCES: [(&str, &str); 7] = [
    ("fmi3.c", include_str!("sources/fmi3.c")),
    ("types.h", include_str!("sources/types.h")),
    ("instance.h", include_str!("sources/instance.h")),
    ("pair.h", include_str!("sources/pair.h")),
    ("events.h", include_str!("sources/events.h")),
    ("steps.h", include_str!("sources/steps.h")),
    ("others.h", include_str!("sources/others.h")),
];

/// The source files with the functions of FMI 2.0.
const SOURCES_OF_2: [(&str, &str); 2] =
    [("fmi2.c", include_str!("sources/fmi2.c")), ("types2.h", include_str!("sources/types2.h"))];

/// The seal, in the folder that the standard reserves for tools.
const SEAL: Seal = Seal { path: "extra/dalembert/sha256.txt", file: String::into_bytes };

/// Whether a unit contains the files for which its seal was written; `None` where it has no seal.
pub fn seal_holds(unit: &[u8]) -> Option<bool> {
    SEAL.holds(unit)
}

impl Unit {
    /// The instantiation token, a hash of the source and the origin.
    fn token(&self) -> String {
        let mut hasher = SipHasher13::new();
        hasher.write(self.source.as_bytes());
        hasher.write(self.origin.as_bytes());
        format!("{{{:032x}}}", hasher.finish128().as_u128())
    }

    /// The names and contents of the source files.
    pub fn sources(&self) -> Vec<(&'static str, String)> {
        let mut system = format!("/* {} */\n\n", self.origin.replace("*/", "* /"));
        let _ = writeln!(system, "#define TOKEN {}\n#define TOLERANCE {:?}\n", quoted(&self.token()), self.tolerance);
        system += &self.source;
        let names = self.indicators.iter().map(|indicator| format!("    {},\n", quoted(&indicator.description)));
        let _ = writeln!(
            system,
            "\nstatic const char *const indicator_names[] = {{\n{}    \"\"\n}};",
            names.collect::<String>()
        );
        let of_2: &[(&str, &str)] = if self.version == Version::Two { &SOURCES_OF_2 } else { &[] };
        let own = SOURCES.iter().chain(of_2).map(|&(name, text)| (name, text.to_owned()));
        own.chain([("system.h", system)]).collect()
    }

    /// Writes the unit as a zip archive.
    ///
    /// # Errors
    /// Writing to `out` fails.
    pub fn write(&self, out: impl Write, binary: Option<&Binary>) -> io::Result<()> {
        let (model, build) = (self.description()?, self.build_description()?);
        let sources = self.sources();
        let mut entries = vec![Entry { path: "modelDescription.xml".to_owned(), bytes: &model }];
        if let Some(binary) = binary {
            entries.push(Entry { path: format!("binaries/{}", self.library()), bytes: &binary.bytes });
        }
        entries.extend(build.iter().map(|bytes| Entry { path: "sources/buildDescription.xml".to_owned(), bytes }));
        let files = sources.iter();
        entries.extend(files.map(|(name, text)| Entry { path: format!("sources/{name}"), bytes: text.as_bytes() }));
        archive::write_sealed(out, &entries, SEAL)
    }
}

/// A text as a C string literal.
fn quoted(text: &str) -> String {
    let escaped = |letter: char| match letter {
        '"' | '\\' => format!("\\{letter}"),
        '?' => "\\?".to_owned(),
        letter if letter.is_control() => " ".to_owned(),
        letter => letter.to_string(),
    };
    format!("\"{}\"", text.chars().map(escaped).collect::<String>())
}
