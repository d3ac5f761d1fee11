//! A system that is written in its file, as its users meet it.

use crate::{json, run};

const MODEL: &str = "scenes/models/double_pendulum.toml";

#[test]
fn every_principle_and_notation_gives_the_equations() {
    for principle in ["lagrange", "virtual-power", "appell", "gauss"] {
        for format in ["text", "latex", "mathml", "sympy", "c", "python", "rust"] {
            let output = run(&["derive", MODEL, "--principle", principle, "--format", format]);
            assert_eq!(
                output.status.code(),
                Some(0),
                "{principle} {format}: {}",
                String::from_utf8_lossy(&output.stderr)
            );
            assert!(output.stdout.len() > 100, "{principle} {format}");
        }
    }
    let refused = run(&["derive", MODEL, "--principle", "hamel"]);
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        refused.status.code() == Some(2) && message.contains("virtual-power, lagrange, appell, gauss"),
        "{message}"
    );
}

#[test]
fn verdicts_of_a_proof_are_read_by_programs() {
    let proved = json(&run(&["prove", MODEL, "--format", "json"]));
    let rows = proved.as_array().expect("a list");
    assert_eq!(rows.len(), 3);
    assert!(rows.iter().all(|row| row["verdict"] == "proved" && row["principles"][0] == "lagrange"), "{proved}");
}

#[test]
fn what_does_not_read_such_a_file_says_so() {
    for command in ["ensemble", "bodies", "stationary", "regimes", "motor"] {
        let output = run(&[command, MODEL]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{command}: {message}");
        assert!(message.contains("does not read a system that is written in its file"), "{command}: {message}");
    }
}
