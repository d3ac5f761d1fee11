//! All steady motions of a system described in its file, and the stability of numerical methods on them.

use super::{MODEL, PENDULUM, printed, refused};
use crate::{run, temporary};
use serde_json::Value;

#[test]
fn all_equilibria_of_a_double_pendulum_are_told_with_their_stability() {
    let told = printed(&["stationary", MODEL]);
    assert!(told.contains("4 steady motions, each alone in its box; there are no others"), "{told}");
    assert!(
        told.contains("1  a = 0 rad, b = 0 rad\n     stable, by enclosures: the potential energy has a strict minimum"),
        "{told}"
    );
    assert!(told.contains("unstable, by enclosures: the potential energy decreases in 2 directions"), "{told}");
    let object: Value = serde_json::from_str(&printed(&["stationary", MODEL, "--format", "json"])).expect("it is JSON");
    assert_eq!(object["complete"], true);
    assert_eq!(object["motions"].as_array().map(Vec::len), Some(4));
    assert_eq!(
        (&object["motions"][0]["stability"], &object["motions"][0]["enclosed"]),
        (&"stable".into(), &true.into())
    );
}

#[test]
fn a_family_is_told_with_its_symmetry() {
    let hat = temporary("hat.toml");
    let text = "title = \"A hat\"\n[parameters]\nm = \"1 kg\"\nk = \"1 J\"\na = \"1 m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n\
        [energies]\nkinetic = \"m/2*(x'^2 + y'^2)\"\npotential = \"k*((x^2 + y^2)/a^2 - 1)^2\"\n[run]\nspan = \"1 s\"\n";
    std::fs::write(&hat, text).expect("it can be written");
    let path = hat.to_string_lossy().into_owned();
    refused(&["stationary", &path], "`x`, `y` need a range in SI units");
    let told = printed(&["stationary", &path, "--range", "x=-2..2", "--range", "y=-2..2"]);
    assert!(told.contains("one steady motion, alone in its box, and one family; there are no others"), "{told}");
    assert!(told.contains("a family, a curve: x within -1"), "{told}");
    assert!(told.contains("the cause is an identity: the forces do no work along the displacement (x:"), "{told}");
    let few = run(&["stationary", &path, "--range", "x=-2..2", "--range", "y=-2..2", "--boxes", "10"]);
    assert_eq!(few.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&few.stderr).contains("undecided boxes"));
    std::fs::remove_file(&hat).expect("it is there");
}

#[test]
fn dry_friction_and_contacts_are_told_in_each_combination() {
    let block = "scenes/models/dry_friction.toml";
    let told = printed(&["stationary", block, "--range", "x=-3..3"]);
    assert!(told.contains("where x' = 0") && told.contains("a family, a curve: x from -1 to 1 m"), "{told}");
    let object: Value =
        serde_json::from_str(&printed(&["stationary", block, "--range", "x=-3..3", "--format", "json"]))
            .expect("it is JSON");
    assert_eq!(object["cases"][0]["families"][0]["dimension"], 1);
    refused(&["stationary", "scenes/models/bridge_rectifier.toml"], "steady motions are not sought with this contact");
}

#[test]
fn a_sleigh_runs_straight_in_a_quasi_velocity() {
    let sleigh = ["stationary", "scenes/models/chaplygin_sleigh.toml", "--range", "psi'=-2..2"];
    let told = printed(&[&sleigh[..], &["--range", "velocity(G).B.x=2"]].concat());
    assert!(
        told.contains("given: velocity(G).B.x = 2 m/s") && told.contains("cyclic, nothing depends on them: x, y, psi"),
        "{told}"
    );
    assert!(told.contains("1  psi' = 0 rad/s") && told.contains("asymptotically stable in all others"), "{told}");
}

#[test]
fn what_is_asked_of_another_kind_of_scene_is_refused() {
    refused(&["stationary", MODEL, "--omega0", "3"], "--omega0 is about the built-in gyrostats");
    refused(
        &["stationary", "scenes/spin_up.toml", "--range", "x=1"],
        "--range x is about a system that is written in its file",
    );
    refused(&["stationary", MODEL, "--range", "c=0..1"], "no unknown of the search is called `c`");
    refused(&["stationary", MODEL, "--range", "a=1..0"], "1 is not below 0");
    refused(&["stationary", MODEL, "--range", "a"], "such as x=-0.1..0.1");
    refused(&["stationary", MODEL, "--range", "a=0..90 deg"], "numbers in SI units, without the unit, are accepted");
    refused(&["stationary", MODEL, "--range", "a=0..1", "--range", "a=1..2"], "--range a is given twice");
    refused(&["stationary", MODEL, "--boxes", "0"], "--boxes");
}

/// The constraints `y*(y - 1) = 0` and `y = 0`: near the start the first follows from the second, but the first also allows `y = 1`.
#[test]
fn motions_fulfil_the_constraints_that_follow_from_others_near_the_start() {
    let file = temporary("double_floor.toml");
    let text = "title = \"Bead\"\n[parameters]\nm = \"1 kg\"\nk = \"3 N/m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies.bead]\ncentre = \"O + x*N.x + y*N.y\"\n\
        mass = \"m\"\n[energies]\npotential = \"k/2*(x^2 - (1 m^2))^2/(1 m^2)\"\n[[constraint]]\nname = \"steps\"\nzero = \"y*(y - (1 m))\"\n\
        [[constraint]]\nname = \"floor\"\nzero = \"y\"\n[start]\nx = \"0.5 m\"\n[run]\nspan = \"1 s\"\n";
    std::fs::write(&file, text).expect("it can be written");
    let told = printed(&["stationary", &file.to_string_lossy(), "--range", "x=-2.1..2.3", "--range", "y=-2.2..2.1"]);
    assert!(told.contains("3 steady motions") && !told.contains("y = 1 m"), "{told}");
    std::fs::remove_file(&file).expect("it is there");
}

/// The length of a spring has no derivative at zero: a box about this point is undecided, and no other box.
#[test]
fn a_place_without_slopes_is_told_as_undecided() {
    let file = temporary("no_slope.toml");
    let text = "title = \"Mass on a spring\"\n[parameters]\nm = \"1 kg\"\nk = \"3 N/m\"\nl = \"1 m\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\n\
        P = \"O + x*N.x + y*N.y\"\n[bodies.mass]\ncentre = \"P\"\nmass = \"m\"\n[energies]\npotential = \"k/2*(distance(O, P) - l)^2 + (2 N)*y\"\n[run]\nspan = \"1 s\"\n";
    std::fs::write(&file, text).expect("it can be written");
    let output = run(&["stationary", &file.to_string_lossy(), "--range", "x=-2..2", "--range", "y=-2..2"]);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.code() == Some(1) && told.contains("undecided"), "{told}");
    std::fs::remove_file(&file).expect("it is there");
}

#[test]
fn motions_between_events_are_those_without_them() {
    let pendulum = temporary("watched_pendulum.toml");
    std::fs::write(&pendulum, PENDULUM.replace("end = true", "set = { \"theta'\" = \"-theta'\" }"))
        .expect("it can be written");
    let path = pendulum.to_string_lossy().into_owned();
    let told = printed(&["stationary", &path]);
    assert!(told.contains("2 steady motions, each alone in its box; there are no others"), "{told}");
    std::fs::remove_file(&pendulum).expect("it is there");
}

#[test]
fn steps_that_misjudge_a_motion_of_a_file_are_told_for_each_method() {
    let told = printed(&["numerical-stability", MODEL]);
    // the limit is sqrt(8) over the larger frequency
    assert!(told.contains("Runge-Kutta 4        never correct; damps an undamped mode for h < 0.4887256673; grows although the motion does not for h > 0.4887256673"), "{told}");
    assert!(told.contains("implicit midpoint    correct at every step"), "{told}");
    let object: Value =
        serde_json::from_str(&printed(&["numerical-stability", MODEL, "--format", "json"])).expect("it is JSON");
    let of_first = object["motions"][0]["methods"].as_array().expect("methods");
    assert_eq!(of_first.len(), 8);
    // there the stability function has |R(h mu)| = 1
    let frequency = object["motions"][0]["eigenvalues"][2][1].as_f64().expect("a number").abs();
    assert!((0.4887256673 * frequency - 8f64.sqrt()).abs() < 1e-8);
    refused(&["numerical-stability", MODEL, "--omega0", "3"], "--omega0 is about the built-in machines");
    refused(
        &["numerical-stability", "scenes/bench.toml", "--range", "x=1"],
        "--range x is about a system that is written in its file",
    );
}

/// Forces that fall faster than the speeds leave the linear equations, which then keep their energy: x'' + 4 x = 0.
#[test]
fn steps_at_rest_are_told_where_drag_grows_with_a_power_of_the_speed() {
    for (name, drag) in
        [("cubic", "-(2 N s^3/m^3)*x'^3*N.x"), ("quadratic", "-(2 N s^2/m^2)*norm(velocity(b))*velocity(b)")]
    {
        let file = std::env::temp_dir().join(format!("dalembert_{name}_drag_{}.toml", std::process::id()));
        let text = format!(
            "title = \"Drag\"\n[coordinates]\nx = \"m\"\n[bodies]\nb = {{ centre = \"O + x*N.x\", mass = \"1 kg\" }}\n[[force]]\non = \"b\"\n\
             is = \"-(4 N/m)*x*N.x\"\n[[force]]\non = \"b\"\nis = \"{drag}\"\n"
        );
        std::fs::write(&file, text).expect("it is written");
        let told = printed(&["numerical-stability", &file.to_string_lossy(), "--range", "x=-1..1"]);
        assert!(told.contains("eigenvalues, 1/s: ±2.0000000000i"), "{told}");
        assert!(told.contains("grows although the motion does not for h > 1.414213562"), "{told}");
        std::fs::remove_file(&file).expect("it is there");
    }
}

/// A blocked motor at the current limit of its amplifier: the current decays at the rate R/L = 2000/s, and Euler's method is stable for
/// steps up to 2 L/R.
#[test]
fn steps_on_a_motion_of_a_law_with_conditions_are_those_of_its_side() {
    let scene = "scenes/foreign/stalled_motor.toml";
    let asked = ["numerical-stability", scene, "--range", "theta=-1..1", "--range", "motor.q'=-20..20"];
    let told = printed(&asked);
    assert!(
        told.contains("where asked - most > 0") && told.contains("Euler                correct up to h = 0.001;"),
        "{told}"
    );
    let object: Value =
        serde_json::from_str(&printed(&[&asked[..], &["--format", "json"]].concat())).expect("it is JSON");
    let rate = object["cases"][0]["motions"][0]["eigenvalues"][1][0].as_f64().expect("a number");
    assert!((rate + 2000.0).abs() < 1e-9, "{object}");
}

/// Runge-Kutta 4 damps each oscillation about an equilibrium as its stability function predicts, for every frequency.
#[test]
fn the_drift_of_oscillations_is_that_of_the_stability_function() {
    let options =
        ["--drift=steady", "--steps", "40", "--periods", "200", "--method", "runge_kutta_4", "--format", "json"];
    let object: Value =
        serde_json::from_str(&printed(&[&["numerical-stability", MODEL], &options[..]].concat())).expect("it is JSON");
    let z = std::f64::consts::TAU / 40.0;
    let part = (40.0 * (-z.powi(6) / 72.0 + z.powi(8) / 576.0).ln_1p()).exp_m1();
    let oscillations = object["motions"][0]["oscillations"].as_array().expect("a list");
    assert_eq!(oscillations.len(), 2);
    for row in oscillations.iter().map(|one| &one["methods"][0]) {
        let [exact, run] = [&row["exact"], &row["run"]["change"]].map(|value| value.as_f64().expect("a number"));
        assert!((exact / part - 1.0).abs() < 1e-12 && (run / part - 1.0).abs() < 1e-3, "{row}");
    }
    refused(&["numerical-stability", "scenes/bench.toml", "--drift=steady"], "--drift=steady is about a system");
    refused(&["numerical-stability", MODEL, "--steps", "3"], "--drift");
}

#[test]
fn branches_and_maps_are_drawn() {
    let (shaft, branches, map) = (temporary("drawn.toml"), temporary("branches.svg"), temporary("map.svg"));
    let text = "title = \"A cubic spring\"\n[parameters]\nm = \"1 kg\"\nk = \"1 N/m\"\nc = \"1 N/m^3\"\nF = \"0 N\"\n[coordinates]\nx = \"m\"\n\
        [bodies.ball]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n[energies]\npotential = \"-k/2*x^2 + c/4*x^4 - F*x\"\n";
    std::fs::write(&shaft, text).expect("it can be written");
    let path = shaft.to_string_lossy().into_owned();
    let along = ["stationary", &path, "--range", "x=-2..2", "--along", "F=-1..1"];
    printed(&[&along[..], &["--values", "9", "--picture", &branches.to_string_lossy()]].concat());
    let svg = std::fs::read_to_string(&branches).expect("it is drawn");
    assert!(svg.contains("branch unstable") && svg.contains("(fold)") && svg.contains(">F, N<"), "{svg}");
    let told =
        printed(&[&along[..], &["--along", "k=-1..1", "--values", "6", "--out", &map.to_string_lossy()]].concat());
    assert!(told.contains("A  1 steady motion: 1 stable") && told.contains("B  3 steady motions: 2 stable"), "{told}");
    assert!(std::fs::read_to_string(&map).expect("it is drawn").contains("3 steady motions: 2 stable"));
    refused(
        &["stationary", &path, "--range", "x=-2..2", "--out", "q.svg"],
        "--along NAME=FROM..TO is accepted with it",
    );
    [shaft, branches, map].iter().for_each(|path| std::fs::remove_file(path).expect("it is there"));
}

#[test]
fn values_at_which_motions_change_are_enclosed_along_a_parameter() {
    let shaft = temporary("shaft.toml");
    let text = "title = \"A pendulum on a turning shaft\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n[parameters]\nm = \"1 kg\"\nl = \"0.5 m\"\n\
        [coordinates]\nphi = \"rad\"\ntheta = \"rad\"\n[frames]\nA = \"N turned phi about z\"\nB = \"A turned theta about x\"\n\
        [bodies]\nbob = { centre = \"O - l*B.z\", mass = \"m\" }\n\
        shaft = { frame = \"A\", inertia = \"0.2*(1 kg m^2)\" }\n[start]\ntheta = \"0.5 rad\"\n[run]\nspan = \"1 s\"\n";
    std::fs::write(&shaft, text).expect("it can be written");
    let path = shaft.to_string_lossy().into_owned();
    // the bifurcation is at w^2 = g/l
    let told = printed(&["stationary", &path, "--along", "phi'=1..8.03"]);
    assert!(told.contains("at phi' = 4.4294469") && told.contains("two motions leave a third (pitchfork)"), "{told}");
    assert!(told.contains("phi' from 1 to") && told.contains("rad/s: 2 motions: 1 stable, 1 unstable"), "{told}");
    let by_length =
        ["stationary", &path, "--range", "phi'=5", "--along", "l=0.1..0.93", "--values", "5", "--format", "json"];
    let object: Value = serde_json::from_str(&printed(&by_length)).expect("it is JSON");
    assert_eq!(object["samples"].as_array().map(Vec::len), Some(5));
    let ends = &object["changes"][0]["between"];
    let [from, to] = [0, 1].map(|k| ends[k].as_f64().expect("a number"));
    assert!(from < 9.81 / 25.0 && 9.81 / 25.0 < to && to - from < 1e-5, "{from} {to}");
    refused(&["stationary", &path, "--along", "n=0..1"], "no parameter and no speed is called `n`");
    refused(&["stationary", &path, "--along", "m=-1..-0.5", "--values", "2"], "at m = -0.5");
    // values without a system are reported, and the search goes on with the others
    let output = run(&["stationary", &path, "--along", "m=-1..1", "--values", "5"]);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(
        told.contains("not sought at m = -1: its equations have no values: the mass of `bob` must be positive")
            && told.contains("not sought at m = 0: "),
        "{told}"
    );
    assert!(String::from_utf8_lossy(&output.stdout).contains("m from 0.5 to 1 kg: 2 motions: 1 stable, 1 unstable"));
    refused(&["stationary", &path, "--values", "5"], "--along");
    refused(&["stationary", &path, "--along", "theta=0..1"], "`theta` is a coordinate");
    refused(&["stationary", &path, "--along", "phi'=0..1", "--range", "phi'=1"], "leave one of the two out");
    refused(&["stationary", &path, "--range", "phi=1"], "`phi` is cyclic: no equation depends on it");
    // with other values of the parameters
    let told = printed(&["stationary", &path, "--range", "phi'=5", "--set", "l=0.1"]);
    assert!(told.contains("2 steady motions"), "{told}");
    let told = printed(&["stationary", &path, "--set", "phi'=6", "--set", "l=0.4"]);
    assert!(told.contains("given: phi' = 6 rad/s") && told.contains("4 steady motions"), "{told}");
    refused(&["stationary", &path, "--set", "n=1"], "nothing is called `n`");
    refused(&["stationary", &path, "--set", "m=0"], "the mass of `bob` must be positive");
    refused(&["stationary", &path, "--set", "m=1", "--set", "m=2"], "--set m is given twice");
    refused(&["stationary", &path, "--set", "m=one"], "a name with a number in SI units");
    refused(&["stationary", &path, "--set", "m=2", "--along", "m=1..2"], "leave one of the two out");
    std::fs::remove_file(&shaft).expect("it is there");
}
