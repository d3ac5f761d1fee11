//! Simultaneous impacts of several contacts, by Moreau's law.

use super::{METHODS, last, runs};
use dalembert_scenes::ModelScene;
use integrators::Method;
use simulation::IvpScene;
use std::time::Duration;

const CRADLE: &str = r#"
title = "Three balls in a row"
[parameters]
m = "1 kg"
d = "0.1 m"
e = "1"
[coordinates]
x1 = "m"
x2 = "m"
x3 = "m"
[bodies.a]
centre = "O + x1*N.x"
mass = "m"
[bodies.b]
centre = "O + x2*N.x"
mass = "m"
[bodies.c]
centre = "O + x3*N.x"
mass = "m"
[[contact]]
name = "ab"
of = "b"
with = "a"
gap = "x2 - x1 - d"
normal = "N.x"
restitution = "e"
impact = "moreau"
[[contact]]
name = "bc"
of = "c"
with = "b"
gap = "x3 - x2 - d"
normal = "N.x"
restitution = "e"
impact = "moreau"
[start]
x1 = "0 m"
x2 = "0.5 m"
x3 = "0.6 m"
"x1'" = "1 m/s"
[run]
span = "1 s"
"#;

/// A box above a floor, with a contact at each lower corner.
const BOX: &str = r#"
title = "A box falls on a floor"
gravity = "-g*N.y"
[parameters]
m = "1 kg"
w = "0.4 m"
h = "0.2 m"
g = "9.81 m/s^2"
[coordinates]
x = "m"
y = "m"
a = "rad"
[frames]
A = "N turned a about z"
[points]
G = "O + x*N.x + y*N.y"
[bodies.box]
frame = "A"
centre = "G"
mass = "m"
inertia = "m*(w^2 + h^2)/12"
[[contact]]
name = "left"
of = "box at L"
through = "O"
normal = "N.y"
friction = "0.3"
restitution = "0.4"
impact = "moreau"
[[contact]]
name = "right"
of = "box at R"
through = "O"
normal = "N.y"
friction = "0.3"
restitution = "0.4"
impact = "moreau"
[start]
y = "0.8 m"
a = "0 rad"
"x'" = "1 m/s"
[run]
span = "3 s"
"#;

fn of_box(edits: &[(&str, &str)]) -> String {
    let corners = "G = \"O + x*N.x + y*N.y\"\nL = \"G - w/2*A.x - h/2*A.y\"\nR = \"G + w/2*A.x - h/2*A.y\"";
    let text = BOX.replace("G = \"O + x*N.x + y*N.y\"", corners);
    edits.iter().fold(text, |text, (from, to)| text.replace(from, to))
}

#[test]
fn balls_in_touch_leave_together() {
    for method in METHODS {
        let trajectory = runs(CRADLE, method, 1e-11);
        assert_eq!(trajectory.stopped(), None, "{method:?}");
        for (name, speed) in [("x1'", -1.0 / 3.0), ("x2'", 2.0 / 3.0), ("x3'", 2.0 / 3.0)] {
            assert!((last(&trajectory, name) - speed).abs() < 1e-12, "{method:?} {name}");
        }
    }
    // without restitution all balls move on together
    let trajectory = runs(&CRADLE.replace("e = \"1\"", "e = \"0\""), Method::DormandPrince8, 1e-11);
    for name in ["x1'", "x2'", "x3'"] {
        assert!((last(&trajectory, name) - 1.0 / 3.0).abs() < 1e-12);
    }
}

#[test]
fn the_reference_has_the_same_impact() {
    let scene = ModelScene::parse("cradle.toml", CRADLE).unwrap_or_else(|error| panic!("{error}"));
    let exact =
        scene.hybrid().expect("its law changes").exact(Duration::from_secs(60)).unwrap_or_else(|why| panic!("{why}"));
    let state = exact.reference.states.last().expect("there is an end");
    for (place, known) in [(0, 0.4 - 0.2), (1, 0.5 + 0.4), (2, 0.6 + 0.4), (3, -1.0 / 3.0), (4, 2.0 / 3.0)] {
        assert!((state[place].hi() - known).abs() < 1e-15, "{place} {:?}", state[place]);
    }
}

/// Both corners hit the floor simultaneously each time: the box stays horizontal, and friction stops it as a single contact would.
#[test]
fn a_box_that_falls_level_stays_level() {
    let trajectory = runs(&of_box(&[]), Method::DormandPrince8, 1e-10);
    assert_eq!(trajectory.stopped(), None);
    assert!(last(&trajectory, "a").abs() < 1e-9 && (last(&trajectory, "y") - 0.1).abs() < 1e-9);
    assert!(last(&trajectory, "x'").abs() < 1e-9);
    // v0 = sqrt(2 g 0.7 m); the limit 0.3 (1 + 0.4) v0 m of the first tangential impulse exceeds what stops the box: it sticks at once
    let v0 = (2.0 * 9.81 * 0.7_f64).sqrt();
    let first = v0 / 9.81;
    assert!((trajectory.passages[1].time - first).abs() < 1e-9);
    assert!((last(&trajectory, "x") - first).abs() < 1e-8, "{}", last(&trajectory, "x"));
}

#[test]
fn a_box_that_falls_aslant_comes_to_rest_on_its_face() {
    for tilt in ["0.3 rad", "-0.1 rad"] {
        let trajectory = runs(&of_box(&[("a = \"0 rad\"", &format!("a = \"{tilt}\""))]), Method::DormandPrince8, 1e-10);
        assert_eq!(trajectory.stopped(), None, "{tilt}");
        assert!(last(&trajectory, "a").abs() < 1e-6 && (last(&trajectory, "y") - 0.1).abs() < 1e-6, "{tilt}");
        assert!(last(&trajectory, "kinetic_energy") < 1e-15, "{tilt}");
        let energy = |row: &Vec<f64>| {
            row[trajectory.column("kinetic_energy").unwrap()] + row[trajectory.column("potential_energy").unwrap()]
        };
        let grows = trajectory.rows.windows(2).any(|pair| energy(&pair[1]) > energy(&pair[0]) + 1e-8);
        assert!(!grows, "{tilt}");
    }
}

/// Large friction: both corners stick, and rounding errors of the impact must not count as sliding.
#[test]
fn a_box_on_two_rough_corners_comes_to_rest() {
    for (friction, restitution) in [("0.35", "0"), ("1", "0"), ("3", "0.5"), ("30", "0.5")] {
        let edits = [
            ("friction = \"0.3\"", &*format!("friction = \"{friction}\"")),
            ("restitution = \"0.4\"", &*format!("restitution = \"{restitution}\"")),
            ("\"x'\" = \"1 m/s\"\n", ""),
        ];
        let trajectory = runs(&of_box(&edits), Method::DormandPrince8, 1e-10);
        assert_eq!(trajectory.stopped(), None, "{friction} {restitution}");
        assert!((last(&trajectory, "y") - 0.1).abs() < 1e-6, "{friction} {restitution}");
    }
}

#[test]
fn other_laws_name_moreaus() {
    let newton = of_box(&[("impact = \"moreau\"\n", "")]);
    let trajectory = runs(&newton, Method::DormandPrince8, 1e-10);
    let why = trajectory.stopped().unwrap_or_default();
    assert!(why.contains("`impact = \"moreau\"`"), "{why}");
}
