//! The program `dalembert` with one system more, which is better computed than written: scenes name it and give its data.
//!
//! The model is the same as one read from a file; nothing here is compiled for a number of links.

mod chain;

use std::process::ExitCode;

fn main() -> ExitCode {
    dalembert::commands::run()
}
