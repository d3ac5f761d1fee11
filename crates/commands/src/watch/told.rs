//! The lines by which a stage reports its results, one JSON value per line.

use super::stage::Stage;
use charts::page::live::Part;
use serde::{Deserialize, Serialize};
use std::io::{self, Write};
use std::path::PathBuf;

/// The input of a stage: the first line of its standard input.
#[derive(Debug, Serialize, Deserialize)]
pub struct Given {
    /// The text that replaces the content of the file.
    pub text: String,
}

/// A report of a stage: a line of its standard output.
#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Told {
    /// The content of the part with this id, as HTML.
    Part { id: String, content: String },
    /// The text is not acceptable; the message as a terminal would show it.
    Refused(String),
    /// The path of a further file that the text names.
    Reads(PathBuf),
    /// The stages that apply to the text.
    Then(Vec<Stage>),
}

impl Told {
    /// The report of a part's content.
    pub fn part(part: Part, content: String) -> Self {
        Told::Part { id: part.id().to_owned(), content }
    }

    /// Writes the report to standard output.
    ///
    /// # Errors
    /// The reader has closed the pipe.
    pub fn write(&self) -> io::Result<()> {
        let mut out = io::stdout().lock();
        serde_json::to_writer(&mut out, self)?;
        out.write_all(b"\n")?;
        out.flush()
    }
}
