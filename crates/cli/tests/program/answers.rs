//! Results in JSON about steady motions, motors, failures and models, with the evidence for each result.

use crate::{json, run, temporary};
use serde_json::Value;

#[test]
fn stationary_motions_come_with_their_certificates() {
    let output = run(&["stationary", "scenes/spin_up.toml", "--omega0", "40", "--format", "json"]);
    assert_eq!(output.status.code(), Some(0));
    let all = json(&output);
    let case = &all["cases"][0];
    let (motions, certificate) = (case["motions"].as_array().expect("a list"), &case["certificate"]);
    assert_eq!(
        (case["complete"].as_bool(), certificate["real_roots"].as_u64()),
        (Some(true), Some(motions.len() as u64))
    );
    assert_eq!(
        (certificate["by_sturm"].clone(), certificate["morse"].as_i64()),
        (certificate["real_roots"].clone(), Some(2))
    );
    assert_eq!(all["motor"]["angles"].as_array().map(Vec::len), Some(2));
    for motion in motions {
        for (value, ends) in motion["direction"].as_array().unwrap().iter().zip(motion["box"].as_array().unwrap()) {
            let (value, low, high) = (value.as_f64(), ends[0].as_f64(), ends[1].as_f64());
            assert!(low <= value && value <= high);
        }
    }
    let cone = json(&run(&["stationary", "scenes/spin_up.toml", "--cone", "--format", "json"]));
    assert_eq!(cone["cone"][0]["complete"], true);
}

#[test]
fn a_motor_under_load_has_a_pull_in_below_its_pull_out() {
    let output = run(&["motor", "scenes/bench.toml", "--format", "json"]);
    assert_eq!(output.status.code(), Some(0));
    let all = json(&output);
    let pull_out = all["pull_out"]["load"].as_f64().expect("a load");
    assert!((pull_out - 0.135).abs() < 1e-13, "{pull_out}");
    let motors = all["motors"].as_array().expect("a list");
    assert_eq!(motors.len(), 5, "with 0, 1, 2, 3 and its own 8 bars");
    for motor in motors {
        let pull_in = motor["pull_in"].as_f64().expect("a load");
        assert!(pull_in < pull_out);
        let shares = motor["shares"].as_array().expect("a list");
        assert_eq!(shares.last().expect("a load beyond the pull-out")["in_step"], 0);
        for share in shares {
            // below the pull-in load a motor with bars comes into step from every start, except for runs out of time
            let (load, slipping) = (share["load"].as_f64().expect("a load"), share["slipping"].as_u64());
            assert!(load >= pull_in || slipping == Some(0) || motor["bars"] == 0, "{motor}");
        }
    }
}

#[test]
fn a_way_to_fail_is_told_with_thresholds_that_agree() {
    let output = run(&["failures", "gains", "--format", "json"]);
    assert_eq!(output.status.code(), Some(0));
    let ways = json(&output);
    let [way] = &ways.as_array().expect("a list")[..] else { panic!("one way: {ways}") };
    assert_eq!((&way["name"], &way["scene"]), (&Value::from("gains"), &Value::from("drive/euler_overdamped.toml")));
    let thresholds = way["thresholds"].as_array().expect("a list");
    assert!(thresholds.len() == 2 && thresholds.iter().all(|it| it["agrees"] == true), "{way}");
    assert!(way["trials"].as_array().is_some_and(|all| all.iter().any(|it| it["fate"] == "holds")), "{way}");
}

#[test]
fn each_stationary_motion_has_a_verdict_for_each_angle_of_the_rotor() {
    let all = json(&run(&["stationary", "scenes/spin_up.toml", "--omega0", "20", "--format", "json"]));
    let motions = all["cases"][0]["motions"].as_array().expect("a list");
    let mut asymptotically = 0;
    for motion in motions {
        let [driven_away, held] = &motion["stability"].as_array().expect("a list")[..] else { panic!("two angles") };
        assert_eq!(driven_away["verdict"], "unstable");
        assert_eq!(held["structural_zeros"], serde_json::json!(["|v|", "x.v"]));
        // with a motor no root is on the axis, and the number of negative squares of the energy is that of roots with positive real part
        let (roots, energy) = (&held["roots"], &held["energy"]);
        assert_eq!((roots["axis"].as_u64(), &roots["right"]), (Some(0), &energy["negative"]));
        asymptotically += usize::from(held["verdict"] == "asymptotically stable modulo the integrals");
    }
    assert_eq!((motions.len(), asymptotically), (4, 1));
    let text = run(&["stationary", "scenes/constant_speed.toml", "--omega0", "20"]);
    let text = String::from_utf8_lossy(&text.stdout).into_owned();
    for words in [
        "stable: E - W p' at fixed integrals is definite",
        "not decided: no root has a positive real part",
        "unstable: 2 of 4 roots",
    ] {
        assert!(text.contains(words), "{words} in {text}");
    }
}

#[test]
fn a_receipt_names_what_was_taken_and_what_it_promises() {
    let output = run(&["choose", "scenes/stiff_damper.toml", "--tol", "1e-3", "--format", "json"]);
    assert_eq!(output.status.code(), Some(0));
    let receipt = json(&output);
    let models = receipt["models"].as_array().expect("a list");
    assert_eq!((&models[0]["model"], &models[0]["loss"]), (&Value::from("multi_current"), &Value::from("own")));
    assert_eq!(models[1]["loss"]["exact"], true);
    let taken = models.iter().find(|model| model["model"] == receipt["taken"]).expect("it is one of them");
    for number in ["promised", "measured"] {
        assert!(taken["run"][number].as_f64().is_some_and(|error| error <= 1e-3), "{number}: {taken}");
    }
    let far = models.iter().find(|model| model["model"] == "synchronous").expect("it is on the ladder");
    assert!(far["run"].is_null() && far["verdict"] == "too far", "{far}");
}

#[test]
fn a_receipt_across_events_takes_the_model_of_the_file_and_a_scene_that_stops_has_none() {
    let asked =
        ["choose", "scenes/friction/pushed_ladder.toml", "--tol", "1e-3", "--outputs", "alpha", "--format", "json"];
    let output = run(&asked);
    assert_eq!(output.status.code(), Some(0));
    let receipt = json(&output);
    let own = &receipt["models"][0]["model"];
    assert_eq!((&receipt["taken"], own), (&"as written in its file".into(), &"as written in its file".into()));
    for (scene, why) in [
        ("jam", "the equations for the reactions of the contacts become singular"),
        ("painleve", "no combination of cases of conditions and contacts is consistent with its own motion"),
        ("climbed_ladder", "an impact presses other contacts"),
    ] {
        let stops = run(&["choose", &format!("scenes/friction/{scene}.toml")]);
        let told = String::from_utf8_lossy(&stops.stdout).into_owned();
        assert!(stops.status.code() == Some(1) && told.contains(why), "{scene}: {told}");
    }
}

#[test]
fn a_family_has_a_verdict_and_a_map_has_the_columns_of_its_data() {
    let top = "scenes/closed_forms/lagrange_top.toml";
    let all = json(&run(&["stationary", top, "--omega0", "20", "--format", "json"]));
    let circle = &all["cases"][0]["motions"][2];
    assert_eq!(circle["shape"], "circle");
    let arcs = circle["stability"][0]["arcs"].as_array().expect("arcs");
    assert_eq!((arcs.len(), &arcs[0]["judged"]["verdict"]), (1, &"stable".into()));
    let scene = "scenes/closed_forms/upright_rotation.toml";
    let picture = temporary("map.svg");
    let path = picture.to_str().expect("a path is text");
    let ranges = ["--map", "load=-0.15..0.15", "--map", "carrier.centre.3=-0.3..0.3"];
    let asked = [&["stationary", scene, "--upright", "--out", path, "--format", "json"], &ranges[..]].concat();
    let map = json(&run(&asked));
    let columns = map["columns"].as_array().expect("columns");
    // the pull-out is at b0 = 1/8 N m
    let pulled_out = |column: &&serde_json::Value| column["pulled_out"] == true;
    let beyond = |column: &&serde_json::Value| column["value"].as_f64().is_some_and(|load| load.abs() > 0.125);
    assert!(columns.iter().filter(pulled_out).eq(columns.iter().filter(beyond)));
    assert!(std::fs::read_to_string(&picture).expect("the picture was written").contains("pull-out"));
    let _ = std::fs::remove_file(picture);
}

#[test]
fn a_map_says_at_each_node_why_nothing_moves_there() {
    let data = ["--map", "carrier.mass=-2..-1", "--map", "omega0=5..6"];
    let output = run(&[&["stationary", "scenes/spin_up.toml", "--every", "--format", "json"], &data[..]].concat());
    let map = json(&output);
    let nodes = map["nodes"].as_array().expect("a list");
    assert_eq!(nodes.len(), 28 * 21);
    let empty =
        |node: &Value| node["unusual"] == "no bodies have these data" && node["motions"] == Value::Array(vec![]);
    assert!(nodes.iter().all(empty), "{}", nodes[0]);
}
