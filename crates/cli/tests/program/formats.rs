//! Each output format of results, and the messages printed with them.

use crate::{json, run, temporary};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("it is text")
}

fn keys(object: &Value) -> Vec<&str> {
    object.as_object().map_or_else(Vec::new, |object| object.keys().map(String::as_str).collect())
}

#[test]
fn equations_are_written_in_every_notation() {
    for (format, begins) in [
        ("text", "M = "),
        ("latex", "M = "),
        ("mathml", "<math"),
        ("sympy", "from sympy import "),
        ("c", "// The letters y: "),
        ("python", "# The letters y: "),
        ("rust", "// The letters y: "),
    ] {
        let text = printed(&["derive", "motor", "--format", format]);
        assert!(text.starts_with(begins), "{format}: {text}");
    }
}

/// A new folder for the files of a program.
fn folder(name: &str) -> PathBuf {
    let folder = temporary(name);
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// The numbers that a program prints; `None` if the program is not installed.
fn numbers(command: &mut Command) -> Option<Vec<f64>> {
    let output = command.output().ok()?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("it is text");
    Some(text.split_whitespace().map(|word| word.parse().expect("a number")).collect())
}

/// Left sides minus right sides, by the C code, for letters with the values 0.3, 0.4, ...
fn by_c(system: &str, folder: &Path) -> Option<Vec<f64>> {
    let code = printed(&["derive", system, "--format", "c"]);
    let text = format!(
        "{code}#include <stdio.h>\nint main(void) {{ double y[99], dy[9] = {{0}}; \
         for (int k = 0; k < 99; ++k) y[k] = 0.3 + 0.1 * k; residuals(y, dy); \
         for (int k = 0; k < 9; ++k) printf(\"%.17g\\n\", dy[k]); }}\n"
    );
    let (source, program) = (folder.join("code.c"), folder.join("code.out"));
    std::fs::write(&source, text).expect("it can be written");
    numbers(Command::new("gcc").args(["-Wall", "-Werror", "-O1", "-o"]).arg(&program).arg(source).arg("-lm"))?;
    numbers(&mut Command::new(program))
}

/// Left sides minus right sides, by the SymPy text, with floating-point numbers in place of SymPy's symbols.
fn by_sympy(system: &str, folder: &Path) -> Option<Vec<f64>> {
    const FLOATS: &str = "from math import cos, sin, sqrt\n\ndef symbols(names): return [0.3 + 0.1 * k for k, _ in enumerate(names.split())]\n\
                          def Eq(left, right): return left - right\ndef Rational(above, below): return above / below\n";
    std::fs::write(folder.join("sympy.py"), FLOATS).expect("it can be written");
    let text = printed(&["derive", system, "--format", "sympy"]) + "print(*map(repr, equations))\n";
    std::fs::write(folder.join("code.py"), text).expect("it can be written");
    numbers(Command::new("python3").arg(folder.join("code.py")))
}

#[test]
fn the_c_and_the_sympy_of_a_system_agree_to_rounding() {
    let folder = folder("agree");
    for system in ["gyrostat", "motor"] {
        let (Some(c), Some(sympy)) = (by_c(system, &folder), by_sympy(system, &folder)) else {
            return eprintln!("skipped: there is no `gcc` or no `python3` on this machine");
        };
        let size = c.iter().fold(1.0, |most: f64, value| most.max(value.abs()));
        assert!(sympy.len() >= 3 && sympy.iter().any(|value| value.abs() > 0.1));
        assert!(c.iter().zip(&sympy).all(|(c, sympy)| (c - sympy).abs() < 1e-13 * size), "{system}: {c:?} {sympy:?}");
    }
    std::fs::remove_dir_all(folder).expect("it was made");
}

#[test]
fn a_scene_is_written_over_symbols_too() {
    let text = printed(&["derive", "scenes/bench.toml", "--format", "sympy"]);
    assert!(text.contains("from sympy import") && text.ends_with("equations = rates(y)\n"), "{text}");
}

#[test]
fn scenes_are_listed_as_objects() {
    let scenes = json(&run(&["scenes", "scenes/friction", "--format", "json"]));
    let scenes = scenes.as_array().expect("a list");
    assert!(scenes.len() >= 5 && scenes.iter().all(|scene| keys(scene) == ["path", "system", "title"]), "{scenes:?}");
}

#[test]
fn regimes_are_printed_with_their_margins() {
    let found = json(&run(&["regimes", "scenes/friction/climbed_ladder.toml", "--format", "json"]));
    assert_eq!(keys(&found), ["title", "regimes", "verdict", "determined", "critical_friction"]);
    assert_eq!(keys(&found["regimes"][0]["margins"][0]), ["contact", "condition", "margin", "unit"]);
}

#[test]
fn a_chart_is_one_object_with_every_run() {
    let chart =
        json(&run(&["chart", "scenes/closed_forms/unloaded_motor.toml", "--seconds", "10", "--format", "json"]));
    assert_eq!(keys(&chart), ["title", "reference", "advice", "runs"]);
    let runs = chart["runs"].as_array().expect("a list");
    assert!(runs.len() > 10 && runs.iter().all(|run| run["error"].is_f64() != run["failure"].is_string()), "{runs:?}");
}

#[test]
fn a_quiet_run_names_no_file() {
    let (table, picture) = (temporary("quiet.csv"), temporary("quiet.svg"));
    let (table, picture) = (table.to_str().expect("a name"), picture.to_str().expect("a name"));
    let arguments = ["chart", "scenes/closed_forms/unloaded_motor.toml", "--seconds", "10", "--out"];
    let told = printed(&[&arguments[..], &[table]].concat());
    let quiet = printed(&[&arguments[..], &[picture, "--quiet"]].concat());
    assert!(told.ends_with(&format!("{table}\n")) && !quiet.contains(picture), "{quiet}");
    for file in [table, picture] {
        std::fs::remove_file(file).expect("it was written");
    }
}

#[test]
fn every_shell_completes_every_command() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = printed(&["completions", shell]);
        for command in ["run", "chart", "ledger", "derive", "stationary", "ensemble"] {
            assert!(script.contains(command), "{shell}: {command}");
        }
    }
}

/// A scene with a motor runs by a built-in law; `derive` and `prove` use its equations as a model.
#[test]
fn a_scene_with_a_motor_is_derived_and_proved_as_a_whole() {
    let text = printed(&["derive", "scenes/spin_up.toml", "--principle", "lagrange"]);
    assert!(text.contains("M[phi, C.wx] = A*sin(beta)*cos(alpha)"), "{text}");
    let proved = printed(&["prove", "scenes/bench.toml"]);
    assert!(proved.contains("lagrange = newton-euler: proved"), "{proved}");
}
