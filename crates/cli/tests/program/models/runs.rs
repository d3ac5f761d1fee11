//! Runs and ensembles of a system described in a file.

use super::{MODEL, PENDULUM, SPRING, printed};
use crate::{json, program, root, run, table_at, temporary};
use std::path::Path;

#[test]
fn rows_of_a_run_have_the_units_of_their_values() {
    let (path, table) = (temporary("units.toml"), temporary("units.csv"));
    std::fs::write(&path, SPRING.replace("F = \"N\"", "F = \"1 N\"")).expect("it is written");
    let (path, table) = (path.display().to_string(), table.display().to_string());
    printed(&["run", &path, "--out", &table]);
    let rows = table_at(&table);
    let heading = rows.lines().next().unwrap_or_default();
    // x is written in millimetres in the file, and in metres in the table
    assert_eq!(heading, "time [s],x [m],x' [m/s],pull [N],kinetic_energy [J],potential_energy [J],work [J]");
    for file in [path, table] {
        std::fs::remove_file(file).expect("it is there");
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
    // a row cut in the middle, as by a kill
    std::fs::write(&path, &table[..table.len() / 2]).expect("it can be written");
    let again = asked(&path, "3");
    let told = String::from_utf8_lossy(&again.stdout).into_owned();
    assert!(again.status.success() && told.contains("were there already"), "{told}");
    assert_eq!(std::fs::read_to_string(&path).expect("it was written"), table);
    // another length of a rod defines another ensemble
    std::fs::write(&scene, text.replace("members = 10000", "members = 60").replace("l1 = \"1 m\"", "l1 = \"2 m\""))
        .expect("it can be written");
    let other = asked(&path, "1");
    let said = String::from_utf8_lossy(&other.stderr).into_owned();
    assert!(other.status.code() == Some(2) && said.contains("line 2: another ensemble"), "{said}");
    [scene, path, whole].iter().for_each(|path| std::fs::remove_file(path).expect("it is there"));
}

#[test]
fn an_angle_of_several_turns_is_told_by_its_place_and_the_event_that_ends_a_run_by_its_name() {
    let scene = temporary("warned.toml");
    std::fs::write(&scene, PENDULUM).expect("it can be written");
    let file = scene.to_string_lossy().into_owned();
    for command in [&["run"][..], &["derive"], &["prove"], &["linearise"]] {
        let output = run(&[command, &[file.as_str()]].concat());
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{message}");
        let place = format!("warning: {file}:15:9: 30 rad are 4.8 turns");
        assert!(message.contains(&place) && message.contains("\"30 deg\""), "{message}");
    }
    let members = "[ensemble]\nmembers = 2\n[ensemble.vary]\nstart.theta = { from = 20, to = \"30 deg\" }\n";
    let start = PENDULUM.replace("theta = 30", "theta = \"30 deg\"");
    let start = start.replace("[[event]]\nname = \"low\"\nwhen = \"theta - (32 rad)\"\nend = true\n", "");
    std::fs::write(&scene, start + members).expect("it can be written");
    let table = temporary("warned.csv");
    let output = run(&["ensemble", &file, "--out", &table.to_string_lossy()]);
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains(": 20 rad are 3.2 turns") && message.contains("\"20 deg\""), "{message}");
    // the lower bound 20 rad exceeds the upper bound 30 deg: the ensemble is refused
    assert!(output.status.code() == Some(2) && !table.exists(), "{message}");
    std::fs::write(&scene, PENDULUM).expect("it can be written");
    let quiet = run(&["run", &file, "--quiet"]);
    assert!(quiet.stderr.is_empty(), "{}", String::from_utf8_lossy(&quiet.stderr));
    let text = String::from_utf8_lossy(&quiet.stdout).into_owned();
    let reached = text.lines().find(|line| line.starts_with("reached")).expect("it reaches its end");
    assert!(reached.contains("t = ") && reached.ends_with("s: the event `low` ends the run"), "{reached}");
    assert!(!text.contains("diagnosis"), "{text}");
    std::fs::remove_file(&scene).expect("it is there");
}

/// The angle reaches 32 rad between two samples; a run that stops also ends between two samples.
#[test]
fn the_table_of_a_run_ends_where_the_run_ends() {
    let (scene, table) = (temporary("ends.toml"), temporary("ends.csv"));
    std::fs::write(&scene, PENDULUM.replace("theta = 30", "theta = \"30 rad\"")).expect("it can be written");
    let (file, out) = (scene.to_string_lossy().into_owned(), table.to_string_lossy().into_owned());
    let output = run(&["run", &file, "--samples", "3", "--format", "json", "--out", &out]);
    let found = json(&output);
    let text = table_at(&table);
    let last: Vec<f64> = text.lines().last().expect("rows").split(',').filter_map(|cell| cell.parse().ok()).collect();
    let end = found["time"].as_f64().expect("a number");
    assert!(last[0].to_bits() == end.to_bits() && end % 3.0 != 0.0, "{text}");
    assert!(found["state"]["theta"].as_f64().is_some_and(|theta| theta.to_bits() == last[1].to_bits()), "{text}");
    assert_eq!(text.lines().count(), 2 + 1 + (end / 3.0) as usize, "{text}");
    [scene, table].iter().for_each(|path| std::fs::remove_file(path).expect("it is there"));
}
