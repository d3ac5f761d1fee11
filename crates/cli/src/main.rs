//! The program `dalembert`: its commands, with the motors and the pages of claims of the workbench.

use machines as _;
use std::process::ExitCode;
use theorems as _;

fn main() -> ExitCode {
    commands::run()
}
