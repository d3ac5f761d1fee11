//! A system that is written in its file, as its users meet it.

mod equations;
mod linear_equations;
mod proofs;
mod quasi_velocities;
mod refusals;
mod runs;

use crate::run;

const MODEL: &str = "scenes/models/double_pendulum.toml";

fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {message}");
    String::from_utf8(output.stdout).expect("it is text")
}

fn refused(arguments: &[&str], why: &str) {
    let output = run(arguments);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(message.contains(why), "{arguments:?}: {message}");
}
