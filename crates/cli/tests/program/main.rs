//! The program at the command line: its output, its files, its exit codes.

mod answers;
mod choice;
mod clock;
mod documents;
mod ensembles;
mod exports;
mod failures;
mod formats;
mod killed;
mod limits;
mod models;
mod motors;
mod odd_data;
mod outputs;
mod plain_answers;
mod pulses;
mod references;
mod refusals;
mod reviews;
mod runs;
mod sketches;
mod watch;

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The command that starts the program in the project's folder.
fn program(arguments: &[&str]) -> Command {
    program_in(&root(), arguments)
}

/// The command that starts the program in a folder; `DALEMBERT_RUNNER` states the emulator if its processor is emulated.
fn program_in(folder: &Path, arguments: &[&str]) -> Command {
    let binary = env!("CARGO_BIN_EXE_dalembert");
    let runner = std::env::var("DALEMBERT_RUNNER").unwrap_or_default();
    let mut words = runner.split_whitespace().chain([binary]);
    let mut command = Command::new(words.next().unwrap_or(binary));
    command.current_dir(folder).args(words).args(arguments);
    command
}

fn run(arguments: &[&str]) -> Output {
    program(arguments).output().expect("the program starts")
}

/// A path for a temporary file of one test.
fn temporary(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("dalembert_{}_{name}", std::process::id()))
}

/// A table written by a command, without the comments about its origin at its head.
fn table_at(path: impl AsRef<Path>) -> String {
    let text = std::fs::read_to_string(path).expect("it was written");
    let (comments, rows): (Vec<&str>, Vec<&str>) = text.split_inclusive('\n').partition(|line| line.starts_with("# "));
    for fact in ["# made by: dalembert ", "# scene: ", "# sha256 of the scene: ", "# method: "] {
        assert!(comments.iter().any(|comment| comment.starts_with(fact)), "{fact}: {comments:?}");
    }
    rows.concat()
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).expect("one JSON object")
}
