//! The program `dalembert`.
//!
//! # Overview
//! * [`arguments`]: what can be asked on the command line;
//! * [`run`], [`scenes`]: one file for each command;
//! * [`summary`], [`csv`]: a run as text, JSON and a table;
//! * [`ending`]: exit codes, and writing that survives a closed pipe.

mod arguments;
mod csv;
mod ending;
mod progress;
mod run;
mod scenes;
mod summary;

use arguments::{Arguments, Command};
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let ending = match arguments.command {
        Command::Run(asked) => run::run(&asked),
        Command::Scenes { folder } => scenes::list(&folder),
    };
    ending.unwrap_or_else(|refused| refused).tell()
}
