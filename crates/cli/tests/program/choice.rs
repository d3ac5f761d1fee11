//! What `choose` takes can be run by the words that it prints.

use crate::{json, root, run};
use serde_json::Value;
use std::path::PathBuf;

/// All scenes, those of odd data among them.
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
        let output = run(&["choose", &path, "--tol", "1e-1", "--format", "json"]);
        if !matches!(output.status.code(), Some(0)) {
            // a model that stops, or a scene of another kind
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
    assert_eq!(first.0, "as written in its file");
    assert!((0..3).all(|_| chosen() == first), "{first:?}");
}

#[test]
fn a_receipt_says_when_it_promises_and_which_cheaper_model_cannot_be_run() {
    let output = run(&["choose", "scenes/stiff_damper.toml", "--tol", "1e-2"]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    for words in [
        "taken: multi_current",
        "run it: dalembert run scenes/stiff_damper.toml ",
        "cannot be asked for it: fast windings resistive",
        "the largest error of the whole run",
    ] {
        assert!(told.contains(words), "{words} in {told}");
    }
}
