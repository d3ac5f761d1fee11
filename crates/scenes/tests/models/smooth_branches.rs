//! Runs beyond singular positions of closed loops, on the smooth branch of the motion, compared with closed forms.

use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::{Axes, IvpScene, Trajectory};
use std::f64::consts::PI;

/// A slider-crank whose rod is as long as its crank. Without forces the rod may turn with the crank while the slider oscillates; or, from the position
/// with both at right angles to the guide, the slider may stay at rest.
const EQUAL_RODS: &str = r#"
title = "A slider-crank with a rod as long as its crank"
[parameters]
l = "0.3 m"
m = "1 kg"
[coordinates]
a = "rad"
b = "rad"
x = "m"
[energies]
kinetic = "m*l^2*(a'^2 + b'^2)/2 + m*x'^2/1000000"
[[constraint]]
zero = ["l*cos(a) + l*cos(b) - x", "l*sin(a) - l*sin(b)"]
[start]
a = "0.3 rad"
b = "guess 0.3 rad"
x = "guess 0.5 m"
"a'" = "10 rad/s"
[run]
span = "3 s"
tolerance = 1e-10
through_singular_positions = true
"#;

const FOUR_BARS: &str = include_str!("../../../../scenes/foreign/four_bars.toml");

/// The four-bar mechanism on its branch of parallelograms: one rod with the inertia of all.
const ONE_ROD: &str = r#"
title = "One rod for all"
[parameters]
L = "1 m"
m = "1 kg"
g = "9.81 m/s^2"
[coordinates]
a = "rad"
[energies]
kinetic = "m*L^2*a'^2*(3/6 + 2/2)"
potential = "m*g*L*cos(a)*(3/2 + 2)"
[start]
a = "0 rad"
"a'" = "1 rad/s"
[run]
span = "10 s"
tolerance = 1e-13
method = "taylor"
"#;

fn run(text: &str, method: Option<Method>) -> Trajectory {
    let scene = ModelScene::parse("mechanism.toml", text).unwrap_or_else(|error| panic!("{error}"));
    let mut choice = scene.run().choice();
    choice.method = method.unwrap_or(choice.method);
    scene.problem(Axes::First).simulate(&choice, |_| ())
}

const METHODS: [Method; 6] = [
    Method::DormandPrince8,
    Method::Verner9,
    Method::GraggBulirschStoer,
    Method::Taylor,
    Method::Rodas4,
    Method::RadauIIA { stages: 5 },
];

#[test]
fn a_mechanism_of_equal_four_bars_passes_its_lines_as_one_rod() {
    let rod = run(ONE_ROD, None);
    let [a, rate] = [rod.outcome.state[0], rod.outcome.state[1]];
    for method in METHODS {
        let run = run(FOUR_BARS, Some(method));
        assert_eq!(run.stopped(), None, "{method}");
        let passed: Vec<f64> = run.passages.iter().map(|passage| passage.time).collect();
        assert_eq!(passed.len(), 10, "{method}: {passed:?}");
        let state = &run.outcome.state;
        for crank in 0..3 {
            let [turned, speed] = [PI / 2.0 - state[crank], -state[5 + crank]];
            assert!((turned - a).abs() < 1e-6 && (speed - rate).abs() < 1e-5, "{method}: {turned} {a}, {speed} {rate}");
        }
        assert!(state[3].abs() < 1e-6 && state[4].abs() < 1e-6, "{method}: {state:?}");
    }
}

#[test]
fn times_and_samples_are_those_of_the_smooth_motion() {
    let rod = run(ONE_ROD, None);
    let loops = run(FOUR_BARS, Some(Method::Taylor));
    assert_eq!(loops.times, rod.times);
    for (row, one) in loops.rows.iter().zip(&rod.rows) {
        assert!((PI / 2.0 - row[0] - one[0]).abs() < 1e-7, "{row:?} {one:?}");
    }
    // all links are collinear where the angle of the single rod is an odd multiple of 90 degrees
    let first = loops.passages[0].time;
    let quarter = rod.times.iter().zip(&rod.rows).find(|(_, row)| row[0] > PI / 2.0).map(|(time, _)| *time);
    assert!(quarter.is_some_and(|time| first <= time && time - first < 0.06), "{first} {quarter:?}");
}

#[test]
fn a_rod_as_long_as_its_crank_turns_on_with_it() {
    for method in METHODS {
        let run = run(EQUAL_RODS, Some(method));
        assert_eq!(run.stopped(), None, "{method}");
        let [a, b, x] = [0, 1, 2].map(|place| run.outcome.state[place]);
        assert!((a - b).abs() < 1e-9 && (x - 0.6 * a.cos()).abs() < 1e-9, "{method}: {a} {b} {x}");
        assert!(run.passages.len() > 5, "{method}");
    }
}

#[test]
fn without_the_key_a_run_ends_there() {
    let text = EQUAL_RODS.replace("through_singular_positions = true", "");
    let run = run(&text, None);
    assert!(run.stopped().is_some_and(|why| why.contains("singular position")));
    assert!(run.passages.is_empty());
}

/// A slider pulled at constant speed stretches both rods, which then turn infinitely fast: no motion continues.
#[test]
fn a_motion_that_cannot_go_on_ends_there() {
    let drawn = "\"l*sin(a) - l*sin(b)\", \"x - (0.5 m) - (0.2 m/s)*t\"]";
    let text = EQUAL_RODS.replace("\"l*sin(a) - l*sin(b)\"]", drawn).replace("\"0.3 rad\"", "\"guess 0.3 rad\"");
    let text = text.replace("\"10 rad/s\"", "\"guess -1 rad/s\"");
    for method in METHODS {
        let run = run(&text, Some(method));
        assert!(run.stopped().is_some() && run.passages.is_empty(), "{method}: {:?}", run.passages);
        assert!(run.outcome.time < 0.5 && run.outcome.time > 0.4999, "{method}: {}", run.outcome.time);
    }
}

/// An event at the singular position determines the motion behind it.
#[test]
fn an_event_in_the_position_ends_the_run() {
    let event = "[[event]]\nwhen = \"a - (90 deg)\"\nset = { \"a'\" = \"a'/2\" }\n[start]";
    let run = run(&EQUAL_RODS.replace("[start]", event), None);
    assert!(run.stopped().is_some_and(|why| why.contains("singular position")), "{:?}", run.stopped());
}

/// The cranks turn at a constant rate, so that the final angles are known. Each method reaches the collinear position with other
/// steps.
const PARALLELOGRAM: &str = r#"
title = "A parallelogram of cranks"
[coordinates]
a = "rad"
b = "rad"
c = "rad"
[points]
P = "O + (1 m)*(cos(a)*N.x + sin(a)*N.y)"
Q = "P + (2 m)*(cos(b)*N.x + sin(b)*N.y)"
R = "O + (2 m)*N.x + (1 m)*(cos(c)*N.x + sin(c)*N.y)"
[bodies]
one = { turns = "a", inertia = "(0.35 kg m^2)" }
two = { turns = "c", inertia = "(0.35 kg m^2)" }
[bodies.coupler]
turns = "b"
centre = "P + (Q - P)/2"
mass = "1 kg"
inertia = "(0.1 kg m^2)"
[[constraint]]
name = "loop"
zero = "Q - R"
[outputs]
F = "reaction(loop) . N.x"
[start]
a = "60 deg"
c = "60 deg"
"a'" = "1 rad/s"
[run]
span = "10 s"
through_singular_positions = true
"#;

/// The parallelogram with another initial angle and another span.
fn parallelogram(angle: &str, span: &str) -> String {
    PARALLELOGRAM.replace("60 deg", angle).replace("10 s", span)
}

#[test]
fn every_method_passes_at_every_tolerance() {
    for method in METHODS {
        for tolerance in [1e-5, 1e-7, 1e-8, 1e-10] {
            let text =
                parallelogram("60 deg", "10 s").replace("through", &format!("tolerance = {tolerance:e}\nthrough"));
            let run = run(&text, Some(method));
            assert_eq!((run.stopped(), run.passages.len()), (None, 3), "{method} {tolerance}");
            let apart = (run.outcome.state[0] - (PI / 3.0 + 10.0)).abs();
            assert!(apart < 1e-4 + 100.0 * tolerance, "{method} {tolerance}: {apart}");
        }
    }
}

#[test]
fn a_start_near_a_position_passes_all_of_them() {
    for (angle, from, passed) in [("179.9 deg", 179.9, 4), ("179.99 deg", 179.99, 4), ("180.01 deg", 180.01, 3)] {
        for method in METHODS {
            let run = run(&parallelogram(angle, "10 s"), Some(method));
            assert_eq!((run.stopped(), run.passages.len()), (None, passed), "{angle} {method}");
            let apart = (run.outcome.state[0] - (f64::to_radians(from) + 10.0)).abs();
            assert!(apart < 2e-4, "{angle} {method}: {apart}");
        }
    }
}

#[test]
fn a_span_may_end_beside_a_position() {
    for (span, passed) in [("2.0943 s", 0), ("2.094395 s", 0), ("2.0944 s", 1), ("2.095 s", 1)] {
        let run = run(&parallelogram("60 deg", span), None);
        assert_eq!((run.stopped(), run.passages.len()), (None, passed), "{span}");
        let time: f64 = span.trim_end_matches(" s").parse().expect("a number");
        assert!((run.outcome.state[0] - PI / 3.0 - time).abs() < 1e-9 && run.outcome.time == time, "{span}");
    }
}

/// Each end of the coupler, which moves in a circle, carries half of its mass times its acceleration.
#[test]
fn reactions_beside_a_position_are_those_of_the_smooth_motion() {
    let mut text = parallelogram("60 deg", "2.094395 s");
    text = text.replace("through", "tolerance = 1e-10\nsamples = 40\nthrough");
    let run = run(&text, Some(Method::Taylor));
    let place = run.column("F").expect("the output");
    for (time, row) in run.times.iter().zip(&run.rows).chain([(&run.outcome.time, &run.last)]) {
        let force = -0.5 * (PI / 3.0 + time).cos();
        assert!((row[place] - force).abs() < 1e-5, "{time}: {} {force}", row[place]);
    }
}

#[test]
fn lengths_of_a_thousand_kilometres_close_a_loop() {
    let text = PARALLELOGRAM.replace("(1 m)", "(1000000 m)").replace("(2 m)", "(2000000 m)");
    let text = text.replace("0.35 kg m^2", "3.5e11 kg m^2").replace("0.1 kg m^2", "1e11 kg m^2");
    let run = run(&text, None);
    assert_eq!((run.stopped(), run.passages.len()), (None, 3));
    assert!((run.outcome.state[0] - (PI / 3.0 + 10.0)).abs() < 1e-5);
}
