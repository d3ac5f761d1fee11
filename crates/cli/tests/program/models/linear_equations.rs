//! Linear equations, forces for a given motion, equilibria.

use super::{MODEL, SPRING, printed, refused};
use crate::{json, run, temporary};

#[test]
fn linear_equations_are_printed_in_every_format() {
    let path = temporary("spring.toml");
    std::fs::write(&path, SPRING).expect("it is written");
    let path = path.display().to_string();
    let point = &json(&run(&["linearise", &path, "--input", "F", "--format", "json"]))["points"][0];
    assert_eq!(point["states"], serde_json::json!(["x", "x'"]));
    assert_eq!(point["A"], serde_json::json!([[0.0, 1.0], [-9.0, 0.0]]));
    assert_eq!(point["B"], serde_json::json!([[0.0], [0.5]]));
    assert_eq!((&point["C"], &point["D"]), (&serde_json::json!([[18.0, 0.0]]), &serde_json::json!([[0.0]])));
    assert_eq!(point["point"], "equilibrium");
    let text = printed(&["linearise", &path, "--input", "F"]);
    assert!(
        text.contains("+ 3 i")
            && text.contains("not decided by linear equations: 2 eigenvalues lie on the imaginary axis"),
        "{text}"
    );
    let table = printed(&["linearize", &path, "--input", "F", "--format", "csv"]);
    assert!(table.contains("0.0,A,x' [m/s],x [m],-9.0") && table.contains("0.0,B,x' [m/s],F [N],0.5"), "{table}");
    refused(&["linearise", &path], "there are no linear equations: the parameter `F` has no value");
    refused(&["linearise", &path], "`derive` and `prove` need none");
    refused(&["linearise", &path, "--input", "G"], "no parameter is called `G`");
    refused(&["linearise", &path, "--times", "-1"], "a time that is not negative");
    std::fs::write(&path, SPRING.replace("F = \"N\"\n", "F = \"0 N\"\n")).expect("it is written");
    refused(&["linearise", &path, "--times", "0,1,1.5"], "--times 1.5: the run ends at t = 1 s");
    std::fs::remove_file(&path).expect("it is there");
}

/// A letter of `[inputs]` is an input without `--input`; a point without degrees of freedom has an empty state; quasi-velocities are not
/// used about an equilibrium.
#[test]
fn inputs_of_the_file_empty_states_and_equilibria_are_accepted() {
    let path = temporary("odd_point.toml");
    let file = path.display().to_string();
    let input = SPRING.replace("F = \"N\"\n", "").replace("[points]", "[inputs]\nF = \"N\"\n[points]");
    std::fs::write(&path, &input).expect("it is written");
    let of =
        |more: &[&str]| json(&run(&[&["linearise", &file, "--format", "json"], more].concat()))["points"][0].clone();
    assert_eq!(of(&["--input", "F"]), of(&[]));
    assert_eq!(of(&["--input", "F"])["inputs"], serde_json::json!(["F"]));
    let held = input.replace("[run]", "[[constraint]]\nzero = \"x\"\n[run]");
    std::fs::write(&path, held).expect("it is written");
    let text = printed(&["linearise", &file]);
    assert!(text.contains("x is empty: the constraints determine every coordinate and every speed"), "{text}");
    assert!(text.contains("no motion near this point is possible") && !text.contains("eigenvalues\n"), "{text}");
    let fast =
        input.replace("[points]", "[speeds]\nv = \"2*x'\"\n[points]").replace("[run]", "[start]\nv = \"3 m/s\"\n[run]");
    std::fs::write(&path, fast).expect("it is written");
    assert_eq!(of(&["--about", "equilibrium"])["speeds"], serde_json::json!([0.0]));
    std::fs::remove_file(&path).expect("it is there");
}

#[test]
fn a_run_is_linearised_at_its_instants() {
    let along = json(&run(&["linearise", MODEL, "--times", "0.5,0,0.25", "--format", "json"]));
    let points = along["points"].as_array().expect("a list");
    let times: Vec<f64> = points.iter().filter_map(|point| point["time"].as_f64()).collect();
    assert_eq!(times, [0.5, 0.0, 0.25]);
    let start = json(&run(&["linearise", MODEL, "--format", "json"]));
    assert_eq!(points[1]["A"], start["points"][0]["A"]);
    assert_eq!(points[0]["point"], "moving point");
}

/// A body that rotates about its middle axis, which is unstable: a free frame has three rotations and three speeds in the linear equations.
#[test]
fn a_free_frame_is_linearised_by_its_turns() {
    let body = "scenes/models/tumbling_body.toml";
    let point = &json(&run(&["linearise", body, "--format", "json"]))["points"][0];
    let turns = ["turn about F.x", "turn about F.y", "turn about F.z"];
    let states = ["x", turns[0], turns[1], turns[2], "x'", "F.wx", "F.wy", "F.wz"];
    assert_eq!(point["states"], serde_json::json!(states));
    assert_eq!(
        (point["A"].as_array().map(Vec::len), point["coordinates"].as_array().map(Vec::len)),
        (Some(8), Some(5))
    );
    let text = printed(&["linearise", body]);
    assert!(text.contains("  F.wx = 0.01 rad/s, F.wx' = 0 rad/s^2") && text.contains("F.q0 = "), "{text}");
    let table = printed(&["linearise", body, "--times", "0,1", "--format", "csv"]);
    assert!(table.contains("1.0,A,turn about F.x [rad],F.wx [rad/s],1.0"), "{table}");
}

#[test]
fn forces_for_a_motion_are_printed_or_refused_with_the_rank() {
    let crank = "scenes/models/slider_crank.toml";
    let motion = ["inverse", crank, "--motion", "theta = 0.3*sin(t*(5 rad/s))", "--samples", "4"];
    let table = printed(&[&motion[..], &["--unknown", "T"]].concat());
    assert_eq!(table.lines().count(), 6);
    assert!(
        table.starts_with("time [s],theta [rad],phi [rad],s [m],theta' [rad/s],")
            && table.contains(",theta'' [rad/s^2],")
            && table.contains(",T [N m],lambda1 pin along R.x [N],lambda2 pin along R.y [N]"),
        "{table}"
    );
    let twice = printed(&[&motion[..], &["--unknown", "T", "--unknown", "T"]].concat());
    assert_eq!(twice, table);
    refused(&motion, "the system is underactuated: 2 of 3 equations");
    refused(&["inverse", crank, "--motion", "theta"], "a coordinate and an expression of t");
    refused(&["inverse", crank, "--motion", "omega = t/(1 s)"], "no coordinate has this name");
    refused(&["inverse", crank, "--motion", "theta = 2*q"], "a prescribed motion");
    let body = "scenes/models/tumbling_body.toml";
    let free = ["inverse", body, "--motion", "x = (0 m)", "--motion"];
    refused(&[&free[..], &["F = t*(1 rad/s) about z"]].concat(), "the system is underactuated: 0 of 4 equations");
    refused(&[&free[..], &["F = t*(1 rad/s)"]].concat(), "turns one after the other");
}

#[test]
fn redundant_coordinates_are_called_so() {
    let said = |scene: &str| printed(&["chart", scene, "--seconds", "2"]);
    let (crank, pendulum) = (said("scenes/models/slider_crank.toml"), said("scenes/models/double_pendulum.toml"));
    assert!(crank.contains("redundant coordinates") && !crank.contains("minimal coordinates"), "{crank}");
    assert!(pendulum.contains("minimal coordinates"), "{pendulum}");
}

#[test]
fn a_completed_start_and_a_feedback_that_is_no_part_of_a_are_told() {
    let path = temporary("told.toml");
    let file = path.display().to_string();
    let tied = SPRING.replace("F = \"N\"", "F = \"1 N\"").replace("[coordinates]\n", "[coordinates]\ny = \"m\"\n");
    let tied = tied.replace(
        "[outputs]",
        "[[constraint]]\nzero = \"y - 2*x - (1 m)\"\n[start]\nx = \"0.25 m\"\ny = \"guess 1 m\"\n[outputs]",
    );
    std::fs::write(&path, &tied).expect("it is written");
    let text = printed(&["run", &file]);
    assert!(text.contains("start                completed: y = 1.500000000 m\n"), "{text}");
    let object = json(&run(&["run", &file, "--format", "json"]));
    assert_eq!(object["completed_start"], serde_json::json!({ "y": 1.5 }));
    let pushed = SPRING
        .replace("F = \"N\"\n", "")
        .replace("[[force]]", "[inputs]\nF = { unit = \"N\", value = \"-k*x\" }\n[[force]]");
    std::fs::write(&path, &pushed).expect("it is written");
    let said = String::from_utf8_lossy(&run(&["linearise", &file]).stderr).into_owned();
    assert!(said.contains("A does not hold the feedback by `F`"), "{said}");
    let timed = pushed.replace("-k*x\" }", "(1 N)*sin(t*(1 rad/s))\" }");
    std::fs::write(&path, &timed).expect("it is written");
    let told = run(&["linearise", &file]).stderr;
    assert!(!String::from_utf8_lossy(&told).contains("feedback"));
    std::fs::remove_file(&path).expect("it is there");
}

#[test]
fn angles_of_a_motion_without_a_unit_are_warned_of() {
    let crank = "scenes/models/slider_crank.toml";
    let warned = |motion: &str| {
        let output = run(&["inverse", crank, "--motion", motion, "--unknown", "T"]);
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    for motion in ["theta=30", "theta = 30 + 0.1*sin(t*(1 rad/s))"] {
        let told = warned(motion);
        assert!(told.contains("--motion:1:") && told.contains("30 rad are 4.8 turns"), "{motion}: {told}");
        assert!(told.contains("(30 deg)"), "{motion}: {told}");
    }
    assert!(!warned("theta=(30 deg)").contains("turns"));
    let body = run(&["inverse", "scenes/models/tumbling_body.toml", "--motion", "F=90 about x"]);
    let told = String::from_utf8_lossy(&body.stderr).into_owned();
    assert!(told.contains("90 rad are 14.3 turns"), "{told}");
}

/// Whipple's bicycle upright at 5 m/s, from the nonlinear text: exact zeros with their reasons, and entries proved by enclosures.
#[test]
fn enclosed_eigenvalues_are_told_with_the_reasons_of_zeros() {
    let upright = ["linearise", "scenes/foreign/bicycle.toml", "--set", "lean=0", "--set", "rear'=-16.666666666666668"];
    let text = printed(&upright);
    assert!(
        text.contains("zero, exactly: 6 (5 of x, y, yaw, rear, front, on which nothing depends; 1 of the energy"),
        "{text}"
    );
    assert!(
        text.contains("by enclosures, but for 6 zeros") && text.contains("asymptotically stable in all others"),
        "{text}"
    );
    let point = json(&run(&[&upright[..], &["--format", "json"]].concat()))["points"][0].clone();
    assert_eq!(point["enclosed"]["discs"].as_array().map(Vec::len), Some(4));
    assert_eq!(point["enclosed"]["stability"], "asymptotically stable");
    refused(&["linearise", MODEL, "--set", "zz=0"], "nothing is called `zz`");
    refused(&["linearise", MODEL, "--set", "a=1 rad"], "a name with a number in SI units");
}

#[test]
fn exact_boundaries_are_told_along_a_parameter() {
    let path = temporary("upright.toml");
    let file = path.display().to_string();
    let text = "title = \"Upright\"\n[parameters]\nm = \"2 kg\"\nl = \"0.3 m\"\ng = \"9.81 m/s^2\"\np = \"7 N m\"\nd = \"0.1 N m s\"\n\
        [coordinates]\ntheta = \"rad\"\n[energies]\nkinetic = \"m/2*l^2*theta'^2\"\npotential = \"m*g*l*cos(theta)\"\n\
        [[force]]\nalong = \"theta\"\nis = \"-p*theta - d*theta'\"\n[run]\nspan = \"1 s\"\n";
    std::fs::write(&path, text).expect("it is written");
    let told = printed(&["linearise", &file, "--along", "p"]);
    assert!(
        told.contains("p < 5.886: unstable: one eigenvalue") && told.contains("p > 5.886: stable: 2 eigenvalues"),
        "{told}"
    );
    assert!(told.contains("at p = 2943/500 = 5.886"), "{told}");
    assert!(
        printed(&["linearise", &file]).contains("asymptotically stable, by Routh's criterion with exact fractions")
    );
    refused(&["linearise", &file, "--along", "q"], "no parameter is called so");
    refused(
        &["linearise", MODEL, "--set", "a=0", "--set", "b=0", "--along", "l1"],
        "some eigenvalues are opposite to others",
    );
    std::fs::remove_file(&path).expect("it is there");
}

/// A pendulum released in a horizontal position has the period `4 K(1/2) sqrt(l/g)`.
#[test]
fn multipliers_of_a_swing_are_told() {
    let swing = ["linearise", "scenes/foreign/cartesian_pendulum.toml", "--period"];
    let told = printed(&[&swing[..], &["2.367841947576237"]].concat());
    assert!(told.contains("1 since the motion may begin later; 1 of the energy, which is kept"), "{told}");
    refused(&[&swing[..], &["2.3"]].concat(), "the motion does not return: it misses its beginning by");
    refused(&[&swing[..], &["-1"]].concat(), "a time above zero");
}
