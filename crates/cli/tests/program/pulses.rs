//! Short forces: methods with error control do not step over a pulse in time, and report a pulse along the motion that they may miss.

use super::{json, run, temporary};
use serde_json::Value;
use std::f64::consts::PI;

/// All methods with error control that accept any law.
const METHODS: [&str; 12] = [
    "dormand_prince_8",
    "dormand_prince_5",
    "verner_9",
    "verner_6",
    "gragg_bulirsch_stoer",
    "taylor",
    "gauss:3",
    "radau_iia:3",
    "radau_5",
    "kvaerno_5",
    "rodas_4",
    "bader_deuflhard",
];

/// A mass of 1 kg with initial speed 1 m/s and a force along x.
fn mass(force: &str) -> String {
    format!(
        "title = \"A mass\"\n[parameters]\nm = \"1 kg\"\n[coordinates]\nx = \"m\"\n[bodies.a]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n\
         [[force]]\non = \"a\"\nis = \"({force})*N.x\"\n[start]\n\"x'\" = \"1 m/s\"\n[run]\nspan = \"10 s\"\n"
    )
}

/// The JSON that a command prints for a text.
fn told(name: &str, text: &str, words: &[&str]) -> Value {
    let file = temporary(&format!("{name}.toml"));
    std::fs::write(&file, text).expect("it can be written");
    let path = file.to_string_lossy().into_owned();
    let output = run(&[&[words[0], &path, "--format", "json"], &words[1..]].concat());
    std::fs::remove_file(&file).expect("it is there");
    json(&output)
}

/// The impulses are known: F w sqrt(pi) of a Gaussian, F w pi of 1/cosh, F (T - t0) of a step at t0.
#[test]
fn no_method_steps_over_a_pulse_of_the_time() {
    let root = PI.sqrt();
    for (name, force, speed) in [
        ("bell", "(10 N)*exp(-((t - (3.3 s))/(1 ms))^2)", 1.0 + 10.0 * 1e-3 * root),
        ("narrow", "(1e5 N)*exp(-((t - (7.123 s))/(1e-6 s))^2)", 1.0 + 0.1 * root),
        ("pair", "(1e3 N)*exp(-((t - (3.3 s))/(1 ms))^2) - (1e3 N)*exp(-((t - (3.4 s))/(1 ms))^2)", 1.0),
        ("front", "(0.1 N)*(1 + tanh((t - (7.5 s))/(0.1 ms)))", 1.5),
        ("train", "(1 N)*exp(-400*sin((1 rad/s)*t)^2)", 1.310_373_834),
        ("rare", "(1 N)*(sin((0.5 rad/s)*t)^64)^8", 1.442_897_152),
    ] {
        let text = mass(force);
        for method in METHODS {
            let found = told(name, &text, &["run", "--method", method]);
            let own = found["state"]["x'"].as_f64().expect("a speed");
            assert!((own - speed).abs() < 1e-4, "{name} {method}: {own}, {speed}: {found}");
        }
    }
}

/// A pulse late in the run must be seen by `choose`: its command reaches the promised accuracy.
#[test]
fn a_choice_keeps_its_promise_about_a_pulse() {
    let text = mass("(10 N)*exp(-((t - (3.3 s))/(20 ms))^2)");
    let receipt = told("chosen", &text, &["choose", "--tol", "1e-3"]);
    let words: Vec<&str> = receipt["command"].as_array().expect("words").iter().filter_map(Value::as_str).collect();
    let found = told("chosen", &text, &[&["run"], &words[2..]].concat());
    let speed = found["state"]["x'"].as_f64().expect("a speed");
    assert!((speed - 1.0 - 0.2 * PI.sqrt()).abs() < 2e-3, "{speed} by {words:?}");
}

#[test]
fn a_narrow_force_along_the_motion_is_followed_or_told() {
    let exact = {
        // the speed after the pulse: v^2 = 1 + 2 F w sqrt(pi)
        (1.0 + 2.0 * 10.0 * 0.02 * PI.sqrt()).sqrt()
    };
    let text = mass("(10 N)*exp(-((x - (3.3 m))/(20 mm))^2)");
    let mut told_of = 0;
    for method in METHODS {
        let found = told("along", &text, &["run", "--method", method]);
        let speed = found["state"]["x'"].as_f64().expect("a speed");
        let failures = found["failures"].as_array().expect("a list");
        let is_right = (speed - exact).abs() < 1e-4;
        assert!(is_right != failures.iter().any(|one| one["kind"] == "missed event"), "{method}: {found}");
        told_of += usize::from(!is_right);
        if let Some(failure) = failures.first() {
            assert!(
                failure["evidence"].as_str().is_some_and(|text| text.contains("changes along the motion")),
                "{found}"
            );
        }
    }
    assert!(told_of > 0);
}

/// 1/cosh written with exponentials is zero far from its peak, and has no derivatives there, since one exponential overflows. The
/// form proposed as a remedy gives the impulse F w pi.
#[test]
fn an_exponential_beyond_every_number_is_named_and_its_remedy_helps() {
    let by = |force: &str, method: &str| told("overflow", &mass(force), &["run", "--method", method]);
    let u = "((t - (3.3 s))/(1 ms))";
    for method in ["taylor", "rodas_4", "bader_deuflhard"] {
        let found = by(&format!("(20 N)/(exp({u}) + exp(-{u}))"), method);
        let failure = &found["failures"][0];
        assert_eq!(failure["kind"], "overflow in the law", "{method}: {found}");
        let evidence = failure["evidence"].as_str().expect("a text");
        assert!(evidence.contains("in line 11") && evidence.contains("3.3000e3"), "{evidence}");
        let found = by(&format!("(20 N)*exp(-abs({u}))/(1 + exp(-2*abs({u})))"), method);
        let speed = found["state"]["x'"].as_f64().expect("a speed");
        assert!((speed - 1.0 - 0.01 * PI).abs() < 1e-4, "{method}: {found}");
    }
}

/// The forces of springs and dampers are smooth along the motion: no missed pulse is reported.
#[test]
fn ordinary_motions_are_not_told_to_have_missed_something() {
    for force in ["-(40 N/m)*x - (0.1 N s/m)*x'", "-(1 N)*sin((3 1/m)*x)", "(2 N)*cos((50 rad/s)*t)", "-(1e6 N/m)*x"] {
        for method in METHODS {
            let found = told("ordinary", &mass(force), &["run", "--method", method]);
            let missed = |one: &Value| one["kind"] == "missed event";
            assert!(!found["failures"].as_array().expect("a list").iter().any(missed), "{force} {method}: {found}");
        }
    }
}

#[test]
fn members_of_an_ensemble_do_not_step_over_a_pulse() {
    let text = mass("(1 N)*(sin((0.5 rad/s)*t)^64)^8").replace(
        "[start]",
        "[ensemble]\nmembers = 3\n[ensemble.vary]\nparameters.m = { from = \"0.999999 kg\", to = \"1.000001 kg\" }\n[start]",
    );
    let [scene, table] = ["members.toml", "members.csv"].map(temporary);
    std::fs::write(&scene, text).expect("it can be written");
    let output = run(&["ensemble", &scene.to_string_lossy(), "--out", &table.to_string_lossy()]);
    assert!(output.status.success(), "{output:?}");
    let rows = std::fs::read_to_string(&table).expect("a table");
    let mut lines = rows.lines();
    let speed =
        lines.next().and_then(|head| head.split(',').position(|name| name.starts_with("x'"))).expect("a column");
    let speeds: Vec<f64> =
        lines.map(|line| line.split(',').nth(speed).and_then(|cell| cell.parse().ok()).expect("a speed")).collect();
    assert!(speeds.len() == 3 && speeds.iter().all(|speed| (speed - 1.442_897).abs() < 1e-4), "{rows}");
    for file in [scene, table] {
        std::fs::remove_file(file).expect("it is there");
    }
}
