//! Poles of a law: a run must not continue behind one and report its numbers as a motion.

use super::parsed;
use integrators::Method;
use simulation::{Axes, Choice, Trajectory};
use std::time::Duration;

/// Adaptive methods.
const METHODS: [Method; 9] = [
    Method::DormandPrince5,
    Method::DormandPrince8,
    Method::Verner6,
    Method::Verner9,
    Method::GraggBulirschStoer,
    Method::Taylor,
    Method::Radau5,
    Method::Rodas4,
    Method::Kvaerno5,
];

fn run(text: &str, method: Method, tolerance: f64) -> Trajectory {
    let choice = Choice {
        method,
        tolerance,
        axes: Axes::First,
        samples: 50,
        allowed: Duration::from_secs(60),
        through_singular_positions: false,
    };
    let scene = parsed(text);
    simulation::IvpScene::metered(&scene, Axes::First).simulate(&choice, |_| ())
}

/// Whether a run claims to be a valid motion up to its end.
fn serves(trajectory: &Trajectory) -> bool {
    trajectory.stopped().is_none() && trajectory.lost().is_none()
}

/// A unit mass under a force.
fn pushed(force: &str, start: &str, span: &str) -> String {
    format!(
        "title = \"a mass\"\n[coordinates]\nx = \"m\"\n[bodies.b]\ncentre = \"O + x*N.x\"\nmass = \"(1 kg)\"\n[[force]]\non = \"b\"\n\
         is = \"{force}*N.x\"\n[start]\nx = \"{start}\"\n[run]\nspan = \"{span}\"\n"
    )
}

#[test]
fn no_method_passes_a_pole_of_a_force_in_time_or_place() {
    for method in METHODS {
        for tolerance in [1e-2, 1e-4, 1e-8] {
            for (force, start) in [("(1 N s)/(t - (1.05 s))", "0 m"), ("(1 N m)/((1 m) - x)", "0.5 m")] {
                let trajectory = run(&pushed(force, start, "3 s"), method, tolerance);
                let shown = trajectory.times.iter().zip(&trajectory.rows);
                let is_before = |(time, row): (&f64, &Vec<f64>)| *time < 1.05 && row[0] < 1.0;
                assert!(trajectory.stopped().is_some(), "{method} {tolerance} {force}");
                assert!(shown.into_iter().all(is_before), "{method} {tolerance} {force}");
            }
        }
    }
}

#[test]
fn a_divisor_that_vanishes_with_what_it_divides_stops_nothing() {
    for method in METHODS {
        let text = pushed("(-1 N)*sin(x/(1 m))/(x/(1 m))", "0.7 m", "20 s");
        let trajectory = run(&text, method, 1e-8);
        assert!(serves(&trajectory), "{method}: {:?}", trajectory.stopped());
    }
}

/// T = x'^2/(2 (1 - x^2)) has the motion x = sin t, which touches the position x = 1 of infinite T.
#[test]
fn a_place_without_inertia_that_is_touched_is_passed_truly_or_told() {
    let text = "title = \"an arc\"\n[coordinates]\nx = \"m\"\n[energies]\nkinetic = \"(1 kg)*x'^2/(2*(1 - (x/(1 m))^2))\"\n[start]\n\
                \"x'\" = \"1 m/s\"\n[run]\nspan = \"3 s\"\n";
    let mut passed = 0;
    for method in METHODS {
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
            let trajectory = run(text, method, tolerance);
            if serves(&trajectory) {
                let off = (trajectory.last[0] - 3.0_f64.sin()).abs();
                assert!(off < 0.02, "{method} {tolerance}: {off:e}");
                passed += 1;
            }
        }
    }
    assert!(passed > 0);
}

/// x'' = -100 (|x| - 1/2) sgn x: oscillations about 1/2 and -1/2 in turn; at the anchor the direction of the force jumps.
#[test]
fn a_spring_through_its_anchor_is_followed_or_told() {
    let text = "title = \"a spring\"\n[coordinates]\nx = \"m\"\n[points]\nP = \"O + x*N.x\"\n[bodies.a]\ncentre = \"P\"\nmass = \"(1 kg)\"\n\
                [[force]]\nbetween = [\"ground at O\", \"a\"]\nis = \"-(100 N/m)*(distance(O, P) - (0.5 m))\"\n[start]\nx = \"0.7 m\"\n\
                \"x'\" = \"-6 m/s\"\n[run]\nspan = \"2 s\"\n";
    // u = x - 1/2 is A cos(10 t + phase) on the right, from which the times at the anchor follow
    let (amplitude, phase) = (0.4_f64.hypot(1.2) / 2.0, (3.0_f64).atan());
    let swing = |u: f64| (u / amplitude).acos();
    let (first, whole) = ((swing(-0.5) - phase) / 10.0, 2.0 * swing(-0.5) / 10.0);
    let passed = ((2.0 - first) / whole).floor();
    let inside = (2.0 - first - passed * whole) * 10.0 - swing(-0.5);
    let side = if passed % 2.0 == 0.0 { -1.0 } else { 1.0 };
    let expected = side * (0.5 + amplitude * inside.cos());
    let mut followed = 0;
    for method in METHODS {
        let trajectory = run(text, method, 1e-11);
        if serves(&trajectory) {
            let off = (trajectory.last[0] - expected).abs();
            assert!(off < 1e-7, "{method}: {off:e}");
            followed += 1;
        }
    }
    assert!(followed >= 6, "{followed}");
}

/// A mass moves around the anchor of a spring, with a force along x that is proportional to its angle and jumps where the angle does.
#[test]
fn an_angle_that_passes_half_a_turn_is_followed_or_told() {
    let text = "title = \"around\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[bodies.b]\ncentre = \"O + x*N.x + y*N.y\"\nmass = \"(1 kg)\"\n\
                [[force]]\non = \"b\"\nis = \"-(1 N/m)*(x*N.x + y*N.y) - (0.2 N)*atan2(y, x)*N.x\"\n[start]\nx = \"1 m\"\n\
                \"y'\" = \"1 m/s\"\n[run]\nspan = \"4 s\"\n";
    let reference = run(text, Method::DormandPrince8, 1e-13);
    assert!(serves(&reference), "{:?}", reference.stopped());
    let mut told = 0;
    for method in METHODS.into_iter().chain([Method::Gauss { stages: 4 }]) {
        let trajectory = run(text, method, 1e-9);
        if serves(&trajectory) {
            let off = (trajectory.last[0] - reference.last[0]).abs();
            assert!(off < 1e-6, "{method}: {off:e}");
        } else {
            told += 1;
        }
    }
    assert!(told < 5, "{told}");
}

/// A unit mass with gravity and quadratic drag, thrown upwards at a speed.
fn thrown(speed: f64) -> String {
    format!(
        "title = \"thrown up\"\ngravity = \"-(10 m/s^2)*N.y\"\n[coordinates]\ny = \"m\"\n[bodies.b]\ncentre = \"O + y*N.y\"\n\
         mass = \"(1 kg)\"\n[[force]]\non = \"b\"\nis = \"-(0.1 kg/m)*norm(velocity(b))*velocity(b)\"\n[start]\n\"y'\" = \"{speed} m/s\"\n\
         [run]\nspan = \"5 s\"\n"
    )
}

/// |v| has a corner at the highest point.
#[test]
fn drag_changes_its_sense_at_the_top_by_every_method() {
    // v = -10 tanh(t - t0) on the way down, from the highest point at t0 = atan 2
    let expected = -10.0 * (5.0 - 2.0_f64.atan()).tanh();
    for method in METHODS {
        let trajectory = run(&thrown(20.0), method, 1e-11);
        let off = (trajectory.last[1] - expected).abs();
        assert!(serves(&trajectory) && off < 1e-8, "{method}: {off:e}, {:?}", trajectory.stopped());
    }
}

/// |v| has neither a derivative nor a series at rest.
#[test]
fn a_body_with_drag_falls_from_rest_by_every_method() {
    let expected = -10.0 * 5.0_f64.tanh();
    let collocation = [Method::Gauss { stages: 4 }, Method::RadauIIA { stages: 5 }];
    for method in METHODS.into_iter().chain(collocation) {
        for tolerance in [1e-3, 1e-11] {
            let trajectory = run(&thrown(0.0), method, tolerance);
            let off = (trajectory.last[1] - expected).abs();
            assert!(
                serves(&trajectory) && off < 30.0 * tolerance,
                "{method} {tolerance}: {off:e}, {:?}",
                trajectory.stopped()
            );
        }
    }
}

#[test]
fn an_energy_that_begins_at_zero_is_not_lost_where_the_motion_returns() {
    let text = pushed("(-1 N/m)*(x - (1 m))", "0 m", "600 s");
    for method in METHODS {
        let trajectory = run(&text, method, 1e-6);
        assert!(serves(&trajectory), "{method}: {:?}", trajectory.lost());
    }
}
