//! `dalembert draw`: sketches of systems, static and animated.

use crate::{root, run, temporary};

/// The sketch that `draw` prints.
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
    refused(&[scene, "--out", "sketch.png"], "`dalembert draw` writes .svg files only");
    refused(&[scene, "--animate", "--span", "9..11"], "a part of 0..10 is accepted");
    refused(&[scene, "--animate", "--span", "2..1"], "the earlier first");
    refused(&[scene, "--span", "1..2"], "--animate");
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
    let edited = written.replace("At 0.5 s.", "Half a second later.");
    std::fs::write(&path, &edited).expect("it can be written");
    refused(&[scene, "--out", name], "is no unchanged picture of `dalembert draw`");
    assert_eq!(std::fs::read_to_string(&path).expect("it is there"), edited);
    std::fs::remove_file(&path).expect("it is there");
}

/// Runs `draw` on a text.
fn of_text(name: &str, text: &str, arguments: &[&str]) -> std::process::Output {
    let path = temporary(name);
    std::fs::write(&path, text).expect("it can be written");
    let output = run(&[&["draw", path.to_str().expect("a name is text")], arguments].concat());
    std::fs::remove_file(&path).expect("it is there");
    output
}

const LONG: &str = "title = \"l\"\ngravity = \"-g*N.y\"\nparameters = { m = \"1 kg\", l = \"1 m\", g = \"9.81 m/s^2\" }\n\
    coordinates = { a = \"rad\", b = \"rad\" }\nframes = { A = \"N turned a about z\", B = \"N turned b about z\" }\n\
    points = { P = \"O - l*A.y\", Q = \"P - l*B.y\" }\nbodies = { p = { centre = \"P\", mass = \"m\" }, q = { centre = \"Q\", mass = \"m\" } }\n\
    start = { a = \"100 deg\", b = \"170 deg\" }\nrun = { span = \"400 s\", samples = 9 }\n";

#[test]
fn a_long_run_is_shown_in_part_by_pictures_close_enough_to_keep_its_bars_together() {
    let output = of_text("long.toml", LONG, &["--animate"]);
    let svg = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(svg.contains("of a run of 400 s") && svg.contains("keyTimes"), "{svg}");
    // the second bar hangs on the end of the first: both rotate, and successive positions of marks and bars are close
    let lists = svg.split("type=\"translate\" values=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let pair = |text: &str| text.split_once(' ').map(|(x, y)| (number(x), number(y))).expect("two numbers");
    let lists: Vec<Vec<(f64, f64)>> = lists.map(|list| list.split(';').map(pair).collect()).collect();
    let moved: Vec<_> = lists.iter().filter(|places| places.len() > 2).collect();
    assert!(moved.len() > 3 && moved.iter().all(|places| (100..=300).contains(&places.len())));
    let ways = moved
        .iter()
        .flat_map(|places| places.windows(2))
        .map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1));
    assert!(ways.fold(0.0, f64::max) < 0.05 * 520.0 && svg.contains("type=\"rotate\""));
}

#[test]
fn a_run_that_an_event_ends_early_has_its_pictures_before_the_event() {
    let text = "title = \"e\"\ngravity = \"-g*N.y\"\nparameters = { m = \"1 kg\", g = \"9.81 m/s^2\" }\ncoordinates = { x = \"m\", y = \"m\" }\n\
        bodies = { p = { centre = \"O + x*N.x + y*N.y\", mass = \"m\" } }\nstart = { y = \"1 m\", \"x'\" = \"1 m/s\" }\n\
        run = { span = \"100000 s\", samples = 5 }\nevent = [{ when = \"y\", direction = \"down\", end = true }]\n";
    let output = of_text("early.toml", text, &["--animate"]);
    let svg = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.code() == Some(0) && svg.contains("0.452 s"), "{}", String::from_utf8_lossy(&output.stderr));
    let (values, _) = svg.split_once("values=\"").and_then(|(_, rest)| rest.split_once('"')).expect("it moves");
    assert!(values.split(';').count() > 25, "{values}");
}

#[test]
fn a_place_that_is_too_far_is_told_with_its_coordinate_and_its_line() {
    let output = of_text("far.toml", &LONG.replace("l = \"1 m\"", "l = \"1e200 m\""), &[]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(2) && said.contains("`P` is ") && said.contains("far.toml"), "{said}");
    let text =
        LONG.replace("\"O - l*A.y\"", "\"O - l*A.y + z*N.z\"").replace("b = \"rad\" }", "b = \"rad\", z = \"m\" }");
    let output = of_text("far.toml", &text.replace("start = {", "start = { z = \"-2e120 m\","), &[]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.contains("far.toml:4:") && said.contains("it is -2e120 m at the start"), "{said}");
}

#[test]
fn values_of_a_run_that_is_not_drawn_are_checked_as_everywhere() {
    let text = |run: &str| {
        format!(
            "coordinates = {{ x = \"m\" }}\nparameters = {{ m = \"kg\" }}\nbodies = {{ bob = {{ centre = \"O + x*N.x\", mass = \"m\" }} }}\n{run}"
        )
    };
    for run in ["", "[run]\nspan = \"1 s\"\noutputs = [\"x\"]\n"] {
        assert_eq!(of_text("sound_run.toml", &text(run), &[]).status.code(), Some(0), "{run}");
    }
    for (run, why) in [
        ("span = \"-1 s\"", "`span` must be positive"),
        ("span = \"1 m\"", "span"),
        ("span = \"1 s\"\ntolerance = 2", "`tolerance` is out of range"),
        ("span = \"1 s\"\noutputs = [\"y\"]", "y"),
        ("span = \"1 s\"\nspam = 1", "spam"),
        ("tolerance = 1e-8", "span"),
    ] {
        let output = of_text("wrong_run.toml", &text(&format!("[run]\n{run}\n")), &[]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && said.contains(why), "{run}: {said}");
    }
}
