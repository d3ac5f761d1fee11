//! Commands that refuse the given file.

use super::{BLOCK, MODEL, PENDULUM, refused};
use crate::{run, temporary};

#[test]
fn what_does_not_read_such_a_file_says_so() {
    for command in ["bodies", "motor"] {
        let output = run(&[command, MODEL]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{command}: {message}");
        assert!(message.contains("this command reads only scenes of the built-in systems"), "{command}: {message}");
    }
}

#[test]
fn a_file_that_names_no_system_is_led_to_one() {
    let scene = temporary("nameless.toml");
    let file = scene.to_string_lossy().into_owned();
    let told = |text: &str, command: &str, parts: &[&str]| {
        std::fs::write(&scene, text).expect("it can be written");
        let output = run(&[command, &file]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert_eq!(message.matches("error:").count(), 1, "{message}");
        parts.iter().for_each(|part| assert!(message.contains(part), "{part}\n{message}"));
    };
    let ways = ["this file names no system", "[coordinates] names what moves", "`system = "];
    let without = PENDULUM.replace("[coordinates]\ntheta = \"rad\"\n", "");
    for command in ["run", "derive", "prove", "chart", "linearise", "reference"] {
        told(&without, command, &[&ways[..], &["nameless.toml:2:1"]].concat());
    }
    told(&PENDULUM.replace("[coordinates]", "[coordinate]"), "run", &["nameless.toml:3:2", "is `coordinates` meant?"]);
    told("title = \"Empty\"\n", "run", &["this file names no system", "`dalembert scenes` lists them"]);
    let paper = "title = \"Paper\"\nmodel = \"scene.toml\"\n[[claim]]\nequation = \"eq1\"\n";
    told(paper, "derive", &["this file is a paper", "nameless.toml:2:1", "`judge` and `watch`"]);
    std::fs::remove_file(&scene).expect("it is there");
}

#[test]
fn the_place_of_what_a_command_cannot_take_is_shown() {
    let path = temporary("taken.toml");
    let file = path.display().to_string();
    std::fs::write(&path, BLOCK.replace("\"f1'\" = \"1 m/s\"\n", "")).expect("it is written");
    refused(&["linearise", &file], "taken.toml:14:20");
    refused(&["run", &file, "--method", "strang:1000"], "strang:1000 does not apply to");
    refused(&["inverse", &file, "--motion", "f1 = (1 m)*sin(tt)"], "--motion:1:16");
    refused(&["inverse", &file, "--motion", "f1 = 30 mm"], "30 mm");
    refused(&["inverse", &file, "--motion", "f1 = (1 s)"], "--motion:1:6");
    std::fs::remove_file(&path).expect("it is there");
}

#[test]
fn a_byte_that_is_no_text_is_told_at_its_line() {
    let path = temporary("latin.toml");
    std::fs::write(&path, b"title = \"x\"\n[coordinates]\nx = \"m\"   # gr\xf6\xdfe\n").expect("it is written");
    let file = path.to_str().expect("a path in UTF-8");
    refused(&["run", file], "latin.toml:3:15");
    refused(&["derive", file], "the byte 0xf6, in Latin-1 the letter ö");
    std::fs::remove_file(path).expect("it is there");
}

#[test]
fn a_formula_that_cannot_be_read_leaves_the_other_claims_judged() {
    let path = temporary("half_read.toml");
    let claim = |number: u32, formula: &str| {
        format!("[[claim]]\nequation = \"{number}\"\nkind = \"formula\"\nformula = '{formula}'\n")
    };
    let letters = "[letters]\n'm' = \"(1 kg)\"\n'\\theta' = \"theta\"\n'T' = \"kinetic_energy\"\n";
    let text = format!("{PENDULUM}\n{letters}{}{}", claim(1, r"T = \sin\theta m"), claim(2, r"T = T"));
    std::fs::write(&path, text).expect("it is written");
    let file = path.display().to_string();
    let output = run(&["judge", &file]);
    let [told, warned] = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    assert_eq!(output.status.code(), Some(2), "{told}{warned}");
    assert!(
        told.contains("proved") && told.contains("half_read/eq2") && told.ends_with("2 claims: 1 proved, 1 not read\n"),
        "{told}"
    );
    assert!(warned.contains("^^^^") && warned.contains("argument of `\\sin` ends"), "{warned}");
    let output = run(&["judge", &file, "--json"]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    let all: serde_json::Value = serde_json::from_str(&told).expect("it is JSON");
    assert!(all[1]["verdict"].is_null() && all[1]["error"]["line"].is_u64(), "{told}");
    std::fs::remove_file(&path).expect("it is there");
}
