//! Data for which a law, a theory or a closed form has no value: the output has finite numbers, or states that there is none.

use crate::{program, root, temporary};
use std::path::Path;

/// A scene with one value replaced.
fn with(scene: &str, datum: &str, value: &str) -> String {
    let text = std::fs::read_to_string(root().join(scene)).expect("a scene");
    let key = format!("{datum} = ");
    assert!(text.lines().any(|line| line.starts_with(&key)), "{scene} has no {datum}");
    let lines = text.lines().map(|line| if line.starts_with(&key) { format!("{key}{value}") } else { line.to_owned() });
    lines.collect::<Vec<_>>().join("\n")
}

/// The first word that stands for an infinite or undefined number, if any.
fn no_number(text: &str) -> Option<&str> {
    let words = text.split(|letter: char| !(letter.is_alphanumeric() || letter == '_'));
    let is = |word: &&str| ["nan", "inf", "infinity"].contains(&word.to_ascii_lowercase().as_str());
    words.into_iter().find(is)
}

/// Runs every command on a scene, and checks the output and the written files.
fn all_of(name: &str, text: &str) {
    let scene = temporary(&format!("{name}.toml"));
    std::fs::write(&scene, text).expect("a scene is written");
    let path = scene.to_string_lossy().into_owned();
    let [table, picture] = ["csv", "svg"].map(|end| temporary(&format!("{name}.{end}")));
    let file = |path: &Path| path.to_string_lossy().into_owned();
    let commands: [&[&str]; 12] = [
        &["run", &path, "--seconds", "2", "--out", &file(&table)],
        &["run", &path, "--seconds", "2", "--format", "json"],
        &["run", &path, "--seconds", "2", "--method", "euler:3"],
        &["run", &path, "--seconds", "2", "--method", "radau_5", "--tol", "0.5"],
        &["choose", &path, "--tol", "1e-1", "--out", &file(&picture)],
        &["choose", &path, "--tol", "1e-3", "--format", "json"],
        &["derive", &path, "--format", "c"],
        &["derive", &path],
        &["bodies", &path],
        &["regimes", &path],
        &["stationary", &path],
        &["conform", &path],
    ];
    for command in commands {
        let output = program(command).output().expect("the program starts");
        let code = output.status.code();
        assert!(matches!(code, Some(0..=2)), "{name}, {command:?}: {code:?}");
        let mut told = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
        for written in [&table, &picture] {
            told += &std::fs::read_to_string(written).unwrap_or_default();
            let _ = std::fs::remove_file(written);
        }
        let lost = no_number(&told);
        assert!(lost.is_none(), "{name}, {command:?}: {lost:?} in\n{told}");
    }
    std::fs::remove_file(&scene).expect("it is there");
}

#[test]
fn no_command_answers_with_what_is_no_number() {
    for (name, scene, datum, value) in [
        ("no_second_moment", "scenes/governors/between_discs_blow_up.toml", "M2", "\"0 N m\""),
        ("no_first_moment", "scenes/governors/drum_programme.toml", "M1", "\"0 N m\""),
        ("no_stiffness_across", "scenes/governors/elastic_unstable.toml", "across", "\"0 N/m\""),
        ("no_moment", "scenes/governors/elastic_stable.toml", "m1", "\"0 N m\""),
        ("no_field", "scenes/bench.toml", "b0", "\"0 N m\""),
        ("no_speed_of_the_field", "scenes/machines/reluctance.toml", "field_speed", "\"0 rad/s\""),
        ("no_sliding", "scenes/failures/straightening_rod.toml", "\"x'\"", "\"0 m/s\""),
        ("no_friction", "scenes/friction/jam.toml", "f", "\"0\""),
        ("no_gravity", "scenes/closed_forms/lagrange_top.toml", "gravity", "\"0 m/s^2\""),
    ] {
        all_of(name, &with(scene, datum, value));
    }
    for name in ["choose_by_noise", "derive_minus_inf"] {
        all_of(name, &odd(name));
    }
}

/// The text of a scene of the folder `odd`.
fn odd(name: &str) -> String {
    let folder = root().join("crates/cli/tests/program/odd");
    std::fs::read_to_string(folder.join(name).with_extension("toml")).expect("a scene")
}

#[test]
fn a_rate_that_is_no_number_ends_the_run_with_a_reason() {
    let output = program(&["run", "crates/cli/tests/program/odd/rod_rate_nan.toml"]).output().expect("it starts");
    assert_eq!(output.status.code(), Some(1));
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(no_number(&told).is_none() && told.contains("left its law"), "{told}");
}

#[test]
fn code_with_a_constant_beyond_the_range_of_doubles_is_refused() {
    let scene = "crates/cli/tests/program/odd/derive_minus_inf.toml";
    for language in ["c", "python", "rust"] {
        let output = program(&["derive", scene, "--format", language]).output().expect("it starts");
        assert_eq!(output.status.code(), Some(2), "{language}");
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(message.contains("beyond the range of double precision"), "{message}");
    }
}

/// Three Euler steps for the whole run: the final speeds are far from those of any motor.
#[test]
fn constant_steps_whose_error_is_as_large_as_the_state_are_no_success() {
    for scene in ["scenes/bench.toml", "scenes/spin_up.toml", "scenes/free_rotor.toml"] {
        let output = program(&["run", scene, "--method", "euler:3"]).output().expect("it starts");
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(output.status.code(), Some(1), "{scene}: {told}");
        assert!(told.contains("they do not follow the law"), "{told}");
    }
    let followed =
        program(&["run", "scenes/bench.toml", "--method", "runge_kutta_4:4000"]).output().expect("it starts");
    assert_eq!(followed.status.code(), Some(0));
}

#[test]
fn what_the_prover_gives_up_is_undecided() {
    let scene = "crates/cli/tests/program/odd/conform_gave_up.toml";
    let output = program(&["conform", scene]).output().expect("it starts");
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(told.contains("\nundecided ") && !told.contains("\nfails "), "{told}");
    assert_eq!(output.status.code(), Some(1), "{told}");
}
