//! The stages of the page, each a separate process.
//!
//! Computer algebra cannot be interrupted from within. A process can be killed at any time, which frees its memory, and a crash affects only one
//! part of the page. The program therefore starts itself once for each stage, sends the text, and reads lines with results.

mod claims;
mod motion;
mod sketch;
mod system;

use super::told::{Given, Told};
use crate::exit::Exit;
use ::scenes::with_ways_to_a_system;
use clap::ValueEnum;
use reader::SceneError;
use serde::{Deserialize, Serialize};
use std::io::{self, BufRead, Read};
use std::path::Path;

/// A stage, the computation of some parts of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "snake_case")]
pub enum Stage {
    /// Reads the text and derives its equations.
    System,
    /// Compares the equations of all principles, and judges conservation laws.
    Verdicts,
    /// Draws the system and, if the text has a run, runs the scene.
    Motion,
    /// Judges the claims of a paper.
    Claims,
}

impl Stage {
    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Stage::System => "system",
            Stage::Verdicts => "verdicts",
            Stage::Motion => "motion",
            Stage::Claims => "claims",
        }
    }
}

/// The reason for which a stage ends early.
enum Broken {
    /// The text is not acceptable.
    Refused(String),
    /// The reader of the results has ended.
    Unread,
}

impl From<SceneError> for Broken {
    fn from(error: SceneError) -> Self {
        Broken::Refused(with_ways_to_a_system(error).render(false))
    }
}

impl From<io::Error> for Broken {
    fn from(_: io::Error) -> Self {
        Broken::Unread
    }
}

/// Runs a stage on the text from standard input; `path` is the name of the file in messages.
pub fn work(stage: Stage, path: &Path) -> Result<Exit, Exit> {
    let mut line = String::new();
    let unread = |error: &dyn std::fmt::Display| Exit::refused(format!("a stage is started by `watch` alone: {error}"));
    io::stdin().lock().read_line(&mut line).map_err(|error| unread(&error))?;
    let Given { text } = serde_json::from_str(&line).map_err(|error| unread(&error))?;
    end_with_the_input();
    let done = match stage {
        Stage::System => system::tell(path, text),
        Stage::Verdicts => system::tell_verdicts(path, text),
        Stage::Motion => motion::tell(path, &text),
        Stage::Claims => claims::tell(path, text),
    };
    match done {
        Ok(()) => Ok(Exit::Done),
        // nobody reads a message any more
        Err(Broken::Unread) => Ok(Exit::Stopped),
        Err(Broken::Refused(why)) => {
            let _ = Told::Refused(why).write();
            Ok(Exit::Stopped)
        }
    }
}

/// Ends this process when the program that started it ends for whatever reason, which closes standard input.
fn end_with_the_input() {
    let watched = std::thread::Builder::new().name("input".to_owned()).spawn(|| {
        let _ = io::stdin().lock().read_to_end(&mut Vec::new());
        std::process::exit(1);
    });
    // if no thread can be created, the stage ends at its deadline
    drop(watched);
}
