//! The lines in which a stage tells its results: one JSON value each.

use super::stage::Stage;
use charts::page::live::Part;
use serde::{Deserialize, Serialize};
use std::io::{self, Write};
use std::path::PathBuf;

/// The work that a stage is given: the first line of its standard input.
#[derive(Debug, Serialize, Deserialize)]
pub struct Given {
    /// The text in the place of that of the file.
    pub text: String,
}

/// A result of a stage: a line of its standard output.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Told {
    /// The content of a part, by its id: HTML.
    Part { id: String, content: String },
    /// The text is not acceptable: a message as a terminal shows it.
    Refused(String),
    /// A file beside the one that is followed.
    Reads(PathBuf),
    /// Stages that apply to the text.
    Then(Vec<Stage>),
}

impl Told {
    /// The content of a part.
    pub fn part(part: Part, content: String) -> Self {
        Told::Part { id: part.id().to_owned(), content }
    }

    /// Writes the line.
    ///
    /// # Errors
    /// Nobody reads it.
    pub fn write(&self) -> io::Result<()> {
        let mut out = io::stdout().lock();
        serde_json::to_writer(&mut out, self)?;
        out.write_all(b"\n")?;
        out.flush()
    }
}
