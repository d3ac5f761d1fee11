//! `dalembert draw`: sketches of systems, still and moving.

use crate::{root, run, temporary};

/// A sketch that is printed.
fn drawn(arguments: &[&str]) -> String {
    let output = run(&[&["draw"], arguments].concat());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {said}");
    String::from_utf8(output.stdout).expect("a picture is text")
}

fn refused(arguments: &[&str], why: &str) {
    let output = run(&[&["draw"], arguments].concat());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(2) && said.contains(why), "{arguments:?}: {said}");
    assert!(output.stdout.is_empty());
}

#[test]
fn a_pendulum_is_a_rod_with_a_mass_on_a_support() {
    let svg = drawn(&["scenes/foreign/cartesian_pendulum.toml"]);
    let (before, style) = svg.split_once("<style>").expect("it has its style");
    let (_, behind) = style.split_once("</style>").expect("the style ends");
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/program"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let lines = format!("{before}{behind}").replace("><", ">\n<");
    settings.bind(|| insta::assert_snapshot!("sketch_of_a_pendulum", lines));
}

#[test]
fn a_moving_sketch_needs_no_script_and_loops() {
    let svg = drawn(&["scenes/models/slider_crank.toml", "--animate"]);
    for part in ["<animateTransform", "repeatCount=\"indefinite\"", "class=\"block", "times slower than the motion"] {
        assert!(svg.contains(part), "{part}");
    }
    assert!(!svg.contains("<script") && !svg.contains("NaN") && svg.len() < 200_000, "{} bytes", svg.len());
}

#[test]
fn a_motion_that_ends_early_is_drawn_up_to_there() {
    let output = run(&["draw", "scenes/friction/climbed_ladder.toml", "--animate"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && said.contains("the motion up to there is drawn"), "{said}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("The motion ends early"));
}

#[test]
fn what_has_no_places_and_times_that_there_are_not_are_refused() {
    refused(&["scenes/models/learning.toml"], "there is nothing to draw");
    let scene = "scenes/models/double_pendulum.toml";
    refused(&[scene, "--time", "11"], "a time from 0 to 10 s is accepted");
    refused(&[scene, "--time", "-1"], "a time from 0 to the end of the run");
    refused(&[scene, "--view", "0,0,0"], "three numbers that are not all zero");
    refused(&[scene, "--animate", "--time", "1"], "cannot be used with");
    refused(&[scene, "--force"], "--out");
    refused(&[scene, "--out", "sketch.png"], "ends in .svg is accepted");
    refused(&["scenes/no_such.toml"], "no_such.toml");
}

#[test]
fn a_picture_of_another_is_left_alone() {
    let path = temporary("sketch.svg");
    let name = path.to_str().expect("a name is text");
    let scene = "scenes/models/double_pendulum.toml";
    std::fs::write(&path, "<svg/>").expect("it can be written");
    refused(&[scene, "--out", name], "is no picture of `dalembert draw`");
    for force in [&["--force"][..], &[]] {
        let output = run(&[&["draw", scene, "--time", "0.5", "--out", name], force].concat());
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    }
    let written = std::fs::read_to_string(&path).expect("it was written");
    assert!(written.starts_with("<!-- dalembert draw, version ") && written.contains("At 0.5 s."));
    std::fs::remove_file(&path).expect("it is there");
}
