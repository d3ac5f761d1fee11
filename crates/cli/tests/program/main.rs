//! The program as its users meet it: what it prints, what it writes, how it ends.

mod answers;
mod book;
mod ensembles;
mod formats;
mod killed;
mod motors;
mod refusals;
mod runs;

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_dalembert"));
    command.current_dir(root()).args(arguments);
    command
}

fn run(arguments: &[&str]) -> Output {
    program(arguments).output().expect("the program starts")
}

/// A file for one test.
fn temporary(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("dalembert_{}_{name}", std::process::id()))
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).expect("one JSON object")
}
