//! A system that is written in its file, as its users meet it.

use crate::{json, program, root, run, temporary};
use std::path::Path;

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
    for command in ["bodies", "stationary", "regimes", "motor"] {
        let output = run(&[command, MODEL]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{command}: {message}");
        assert!(message.contains("does not read a system that is written in its file"), "{command}: {message}");
    }
}

#[test]
fn an_ensemble_of_a_file_goes_on_where_it_was_killed() {
    let [scene, path, whole] = ["pendula.toml", "pendula.csv", "pendula_whole.csv"].map(temporary);
    let text = std::fs::read_to_string(root().join(MODEL)).expect("it is there");
    std::fs::write(&scene, text.replace("members = 10000", "members = 60")).expect("it can be written");
    let asked = |out: &Path, threads: &str| {
        let arguments = ["ensemble", &scene.to_string_lossy(), "--threads", threads, "--out"];
        program(&arguments).arg(out).output().expect("it starts")
    };
    assert!(asked(&whole, "1").status.success());
    let table = std::fs::read_to_string(&whole).expect("it was written");
    assert_eq!(table.lines().count(), 61);
    assert!(table.starts_with(
        "member,parameters.m2 [kg],parameters.l2 [m],start.a [rad],start.b' [rad/s],stopped,time [s],steps,a [rad],"
    ));
    // a row that is cut in the middle, as by a kill
    std::fs::write(&path, &table[..table.len() / 2]).expect("it can be written");
    let again = asked(&path, "3");
    let told = String::from_utf8_lossy(&again.stdout).into_owned();
    assert!(again.status.success() && told.contains("were there already"), "{told}");
    assert_eq!(std::fs::read_to_string(&path).expect("it was written"), table);
    // another length of a rod is another ensemble
    std::fs::write(&scene, text.replace("members = 10000", "members = 60").replace("l1 = \"1 m\"", "l1 = \"2 m\""))
        .expect("it can be written");
    let other = asked(&path, "1");
    let said = String::from_utf8_lossy(&other.stderr).into_owned();
    assert!(other.status.code() == Some(2) && said.contains("line 2: another ensemble"), "{said}");
    [scene, path, whole].iter().for_each(|path| std::fs::remove_file(path).expect("it is there"));
}
