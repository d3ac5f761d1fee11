//! `choose` prints a command, and this command runs the chosen model.

use crate::{json, root, run};
use serde_json::Value;
use std::path::PathBuf;

/// All scenes of the project, and those of the folder `odd` of these tests.
fn scenes() -> Vec<PathBuf> {
    let mut folders = vec![root().join("scenes"), root().join("crates/cli/tests/program/odd")];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
            if entry.is_dir() {
                folders.push(entry);
            } else if entry.extension().is_some_and(|end| end == "toml") {
                found.push(entry);
            }
        }
    }
    found.sort();
    found
}

#[test]
fn what_is_taken_runs_by_the_words_that_are_printed() {
    let mut taken = 0;
    for scene in scenes() {
        let path = scene.to_string_lossy();
        // each run of this scene takes half a minute, since its contacts change often
        if path.ends_with("wheelset.toml") {
            continue;
        }
        let output = run(&["choose", &path, "--tol", "1e-1", "--format", "json", "--seconds", "20"]);
        if !matches!(output.status.code(), Some(0)) {
            // the model stops, or the scene is of another kind
            continue;
        }
        let receipt = json(&output);
        let words: Vec<&str> =
            receipt["command"].as_array().expect("words").iter().map(|word| word.as_str().expect("a word")).collect();
        let ran = run(&[&words[..], &["--format", "json", "--seconds", "20"]].concat());
        let told = String::from_utf8_lossy(&ran.stderr);
        assert_eq!(ran.status.code(), Some(0), "{words:?}: {told}");
        let models = receipt["models"].as_array().expect("a list");
        let line = models.iter().find(|model| model["model"] == receipt["taken"]).expect("it is one of them");
        assert_eq!(line["run_takes_it"], Value::from(true), "{path}");
        assert_eq!(json(&ran)["model"], receipt["taken"], "{words:?}");
        taken += 1;
    }
    assert!(taken > 25, "{taken}");
}

#[test]
fn the_same_scene_has_the_same_choice_and_ties_go_to_the_smaller_model() {
    let scene = "crates/cli/tests/program/odd/choose_by_noise.toml";
    let chosen = || {
        let receipt = json(&run(&["choose", scene, "--tol", "1e-3", "--format", "json"]));
        (receipt["taken"].clone(), receipt["cheapest"].clone(), receipt["saved"].clone(), receipt["deciding"].clone())
    };
    let first = chosen();
    assert_eq!(first.0, "series to eps");
    assert!((0..3).all(|_| chosen() == first), "{first:?}");
}

#[test]
fn a_receipt_says_when_it_promises_and_what_is_left_out() {
    let output = run(&["choose", "scenes/stiff_damper.toml", "--tol", "1e-2"]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    for words in [
        "taken: fast windings at the present slip",
        "run it: dalembert run scenes/stiff_damper.toml --model 'fast windings at the present slip' ",
        "the largest error of the whole run",
    ] {
        assert!(told.contains(words), "{words} in {told}");
    }
}

/// A stiff spring is replaced by its equilibrium, unless an output needs its transient.
#[test]
fn a_smaller_model_of_a_system_as_text_is_found_and_run_by_its_name() {
    let scene = "scenes/models/stiff_spring.toml";
    let receipt = json(&run(&["choose", scene, "--tol", "1e-2", "--format", "json"]));
    assert_eq!(receipt["taken"], "quasi-steady x");
    assert!(receipt["saved"].as_f64().expect("a number") > 2.0, "{receipt}");
    let asked = json(&run(&["choose", scene, "--tol", "1e-2", "--outputs", "x'", "--format", "json"]));
    assert_eq!(asked["taken"], "as written in its file");
    for (model, told) in [
        ("quasi-steady z", "no state is called `z`; known: x, phi, x', phi'"),
        ("quasi-steady phi", "not linear in them"),
        ("fixed x", "x moves at the speed x': both are fixed, or neither"),
        ("without z", "no parameter is called `z`; known: m, M, l, k, c"),
        ("unfollowed x,x'", "which must be followed"),
        ("slow x", "\"quasi-steady X\""),
        ("fixed x,x'; unfollowed phi,phi'", "no state is left to be followed"),
    ] {
        let refused = run(&["run", scene, "--model", model]);
        assert_eq!(refused.status.code(), Some(2), "{model}");
        let said = String::from_utf8_lossy(&refused.stderr);
        assert!(said.contains(told), "{told} in {said}");
    }
    let machine = "scenes/models/induction_machine.toml";
    let shown = json(&run(&["run", machine, "--model", "unfollowed a,b,A,B", "--format", "json"]));
    assert!(shown["state"]["a"].is_null() && shown["state"]["theta'"].is_number(), "{shown}");
}

/// A motion that overflows ends with every method, and no model is chosen for it.
#[test]
fn a_motion_that_overflows_and_outputs_without_values_are_told() {
    let file = std::env::temp_dir().join(format!("dalembert-overflows-{}.toml", std::process::id()));
    let text = "title = \"grows\"\n[coordinates]\nx = \"m\"\n[bodies.p]\ncentre = \"O + x*N.x\"\nmass = \"1 kg\"\n[[force]]\non = \"p\"\n\
                is = \"(1 N/m)*x*N.x\"\n[outputs]\nroot = \"sqrt((2 m) - x)\"\n[start]\nx = \"1 m\"\n[run]\nspan = \"800 s\"\noutputs = [\"x\"]\n";
    std::fs::write(&file, text).expect("it can be written");
    let path = file.to_string_lossy().into_owned();
    for method in ["taylor", "dormand_prince_8"] {
        let ran = run(&["run", &path, "--method", method]);
        assert_eq!(ran.status.code(), Some(1), "{method}");
    }
    let told = |outputs: &str| {
        let output = run(&["choose", &path, "--outputs", outputs, "--tol", "1e-2"]);
        assert_eq!(output.status.code(), Some(1));
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    assert!(told("x").contains("not finite after t = "), "{}", told("x"));
    std::fs::write(&file, text.replace("800 s", "3 s")).expect("it can be written");
    assert!(told("root").contains("the output root has no value at t = "), "{}", told("root"));
    std::fs::remove_file(&file).expect("it can be removed");
}
