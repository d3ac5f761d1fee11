//! Singular positions of closed loops, beyond which several motions, or none, may exist: runs end there, with every method.

use dalembert_scenes::{ModelScene, parse_ensemble};
use integrators::Method;
use simulation::{Axes, Choice, IvpScene};
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::time::Duration;

/// A parallelogram of cranks: without forces all links turn at constant speed until they are collinear.
const PARALLELOGRAM: &str = r#"
title = "A parallelogram of cranks"
[parameters]
l = "0.3 m"
d = "0.4 m"
e = "0.4 m"
m = "1 kg"
[coordinates]
a = "rad"
b = "rad"
q = "rad"
[frames]
A = "N turned a about z"
B = "N turned b about z"
K = "N turned q about z"
[points]
P = "O + l*A.x"
[bodies.first]
frame = "A"
centre = "O + l/2*A.x"
mass = "m"
inertia = "m*l^2/12"
[bodies.second]
frame = "B"
centre = "O + e*N.x + l/2*B.x"
mass = "m"
inertia = "m*l^2/12"
[bodies.coupler]
frame = "K"
centre = "P + d/2*K.x"
mass = "2*m"
inertia = "2*m*d^2/12"
[[constraint]]
name = "loop"
zero = "P + d*K.x - (O + e*N.x + l*B.x)"
[start]
a = "60 deg"
b = "guess 60 deg"
q = "guess 0 deg"
"a'" = "6 rad/s"
[run]
span = "2 s"
tolerance = 1e-8
"#;

const METHODS: [Method; 6] = [
    Method::DormandPrince5,
    Method::DormandPrince8,
    Method::Verner9,
    Method::GraggBulirschStoer,
    Method::Taylor,
    Method::Radau5,
];

/// The time at which all links are collinear.
const TIME: f64 = (PI - PI / 3.0) / 6.0;

fn with(from: &str, to: &str) -> String {
    assert_eq!(PARALLELOGRAM.matches(from).count(), 1, "`{from}` must stand once");
    PARALLELOGRAM.replace(from, to)
}

/// The reason for the end of a run, its time, and its last state.
fn run(text: &str, method: Method, tolerance: f64) -> (Option<String>, f64, Vec<f64>) {
    let scene = ModelScene::parse("cranks.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let choice = Choice {
        method,
        tolerance,
        axes: Axes::First,
        samples: 10,
        allowed: Duration::from_secs(60),
        through_singular_positions: false,
    };
    let run = scene.problem(Axes::First).simulate(&choice, |_| ());
    (run.stopped(), run.outcome.time, run.outcome.state)
}

fn ends_at_the_line(text: &str, tolerance: f64, within: f64) {
    for method in METHODS {
        let (why, time, state) = run(text, method, tolerance);
        let why = why.unwrap_or_else(|| panic!("{method} passes: {time}"));
        assert!(why.contains("singular position: the constraints are linearly dependent here, and several motions may follow, or none"), "{method}: {why}");
        assert!(time < TIME && time > TIME - within, "{method}: {time}");
        assert!((state[0] - state[1]).abs() < 1e-3 && state[2].abs() < 1e-3, "{method}: {state:?}");
    }
}

#[test]
fn a_run_ends_where_the_rods_lie_along_one_line() {
    ends_at_the_line(PARALLELOGRAM, 1e-8, 2e-4);
}

#[test]
fn a_loose_tolerance_does_not_pass_a_singular_position() {
    ends_at_the_line(PARALLELOGRAM, 1e-3, 1e-2);
}

#[test]
fn a_crank_that_is_led_by_the_time_ends_there_too() {
    let led = with("[start]", "[[constraint]]\nzero = \"a - (60 deg) - (6 rad/s)*t\"\n[start]");
    ends_at_the_line(&led, 1e-8, 2e-4);
}

#[test]
fn a_law_with_events_ends_there_too() {
    let event = "[[event]]\nwhen = \"a - (100 deg)\"\nset = { \"a'\" = \"a'\" }\n[start]";
    ends_at_the_line(&with("[start]", event), 1e-8, 2e-4);
}

/// With a base that is longer by 0.1 mm, the cranks reverse just before the links are collinear.
#[test]
fn a_position_that_is_nearly_singular_is_passed() {
    let near = with("e = \"0.4 m\"", "e = \"0.4001 m\"");
    let ends = [Method::DormandPrince8, Method::Verner9, Method::Taylor].map(|method| {
        let (why, time, state) = run(&near, method, 1e-11);
        assert_eq!((why, time), (None, 2.0), "{method}");
        state
    });
    for end in &ends {
        let apart = end.iter().zip(&ends[0]).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-4, "{ends:?}");
    }
}

/// States that violate the constraints within a step are judged by their projections onto them.
#[test]
fn a_loose_tolerance_passes_a_position_that_is_nearly_singular() {
    for method in [Method::Taylor, Method::DormandPrince8] {
        let (why, time, _) = run(&with("e = \"0.4 m\"", "e = \"0.4001 m\""), method, 1e-3);
        assert_eq!((why, time), (None, 2.0), "{method}");
    }
}

#[test]
fn a_constraint_without_a_gradient_where_it_holds_is_refused() {
    let zero = "zero = \"P + d*K.x - (O + e*N.x + l*B.x)\"";
    for norm in ["norm(P + d*K.x - (O + e*N.x + l*B.x))", "distance(P + d*K.x, O + e*N.x + l*B.x)"] {
        let text = with(zero, &format!("zero = \"{norm}\""));
        let error = ModelScene::parse("cranks.toml", &text).expect_err("no gradient").to_string();
        assert!(error.contains("`loop` has no derivative where it holds") && error.contains("cranks.toml:"), "{error}");
        assert!(error.contains("the vector itself"), "{error}");
    }
}

#[test]
fn members_end_there_each_at_its_time() {
    let vary = "\n[ensemble]\nmembers = 20\n[ensemble.vary]\nstart.\"a'\" = { from = \"5 rad/s\", to = \"7 rad/s\" }\n";
    let scene =
        parse_ensemble("cranks.toml", &format!("{PARALLELOGRAM}{vary}")).unwrap_or_else(|error| panic!("{error}"));
    scene.run(1..=20, 2, |row| {
        let why = row.stopped.as_deref().unwrap_or_default();
        assert!(why.starts_with("left its law: singular position: the constraints are linearly dependent"), "{row:?}");
        let time = 6.0 / row.drawn[0] * TIME;
        let last = row.last.as_ref().expect("it started");
        assert!(last.time < time && last.time > time - 1e-3, "{row:?} beside {time}");
        ControlFlow::Continue(())
    });
}
