//! The program `dalembert`.
//!
//! # Overview
//! * [`arguments`]: what can be asked on the command line;
//! * [`report`], [`run`], [`chart`], [`scenes`]: one file for each command;
//! * [`summary`], [`csv`], [`pictures`]: a run as text, JSON, a table and the data of pictures;
//! * [`ending`]: exit codes, and writing that survives a closed pipe.

mod arguments;
mod chart;
mod csv;
mod ending;
mod pictures;
mod progress;
mod report;
mod run;
mod scenes;
mod summary;

use arguments::{Arguments, Command};
use clap::Parser;
use ending::Ending;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let ending = match arguments.command {
        None => report(&arguments.report),
        Some(Command::Run(asked)) => run::run(&asked),
        Some(Command::Chart(asked)) => chart::chart(&asked),
        Some(Command::Scenes { folder }) => scenes::list(&folder),
    };
    ending.unwrap_or_else(|refused| refused).tell()
}

/// The main job.
fn report(asked: &arguments::Report) -> Result<Ending, Ending> {
    let summary = "Every scene run, and every method on it measured by a reference that two methods confirm.";
    report::write(&asked.out, &scenes::files(&asked.scenes)?, report::titled("dalembert", summary))
}
