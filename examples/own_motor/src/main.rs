//! The program `dalembert` with one motor more, which every scene that it reads may name.
//!
//! It turns a fan, in step with the field: the load angle g settles where U'(g) is the torque of air and bearings.

mod salient_pole;

use std::process::ExitCode;

fn main() -> ExitCode {
    dalembert::commands::run()
}
