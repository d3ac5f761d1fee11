//! The steady states of every motor, and every motion of the scenes compared with the compiled equations.

use dalembert_derivations::studies::scene::{Scene, Start};
use dalembert_derivations::studies::stationary::motions::Stationary;
use dalembert_derivations::studies::stationary::motor::{MotorStates, NoMotor, Slip};
use reader::Family;
use simulation::Axes;
use std::path::Path;

fn scene(name: &str) -> Scene {
    Scene::open(Path::new(&format!("scenes/{name}.toml"))).expect("the scene is sound")
}

fn with(text: &str, changes: &[(&str, &str)]) -> Scene {
    let text = std::fs::read_to_string(format!("scenes/{text}.toml")).expect("the scene is there");
    let text = changes.iter().fold(text, |text, (old, new)| {
        assert!(text.contains(old), "{old} is in the scene");
        text.replace(old, new)
    });
    Scene::parse("changed.toml", &text).expect("the scene is sound")
}

fn motor(scene: &Scene) -> MotorStates {
    MotorStates::of(&scene.machine).expect("the motor is algebraic")
}

#[test]
fn a_synchronous_motor_has_two_angles_one_of_which_holds() {
    let MotorStates::InStep { angles, bears, .. } = motor(&scene("spin_up")) else { panic!("it follows its field") };
    // sin g = -f W / b0 = -0.1
    let mut found: Vec<(f64, i32)> = angles.iter().map(|angle| (angle.radians(), angle.slope)).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let small = 0.1f64.asin();
    assert!(
        (found[0].0 + std::f64::consts::PI - small).abs() < 1e-15 && (found[1].0 + small).abs() < 1e-15,
        "{found:?}"
    );
    assert_eq!((found[0].1, found[1].1), (1, -1));
    let bears = bears.expect("the torque has bounds");
    assert!((bears.greatest - 0.135).abs() < 1e-15 && (bears.least + 0.165).abs() < 1e-15, "{bears:?}");
}

#[test]
fn both_angles_merge_at_pull_out_and_vanish_beyond() {
    // f W = b0 at f = 1e-3, to the last digit of the decimals
    let at = |f: &str| match motor(&with("spin_up", &[("f = \"1e-4 N m s\"", &format!("f = \"{f} N m s\""))])) {
        MotorStates::InStep { angles, .. } => angles.iter().map(|angle| angle.slope).collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    assert_eq!(at("0.9999999999e-3").len(), 2);
    assert_eq!(at("1e-3"), [0]);
    assert_eq!(at("1.0000000001e-3"), []);
    let none = with("spin_up", &[("f = \"1e-4 N m s\"", "f = \"2e-3 N m s\"")]);
    assert!(Stationary::of(&none).unwrap().at_speed(3.0).unwrap().is_empty());
}

#[test]
fn without_friction_the_angles_are_zero_and_half_a_turn() {
    let MotorStates::InStep { angles, .. } = motor(&with("spin_up", &[("f = \"1e-4 N m s\"", "f = \"0 N m s\"")]))
    else {
        panic!("it follows its field")
    };
    let found: Vec<(f64, i32)> = angles.iter().map(|angle| (angle.radians(), angle.slope)).collect();
    assert_eq!(found, [(0.0, -1), (std::f64::consts::PI, 1)]);
}

#[test]
fn kloss_motor_has_one_or_three_speeds() {
    let slopes = |scene: &Scene| match motor(scene) {
        MotorStates::Slipping { speeds, .. } => speeds.iter().map(|Slip { slope, .. }| *slope).collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    assert_eq!(slopes(&scene("asynchronous_drive")), [-1]);
    // a load for which there are steady speeds near synchronism and far from it
    assert_eq!(slopes(&with("asynchronous_drive", &[("f = \"4e-4 N m s\"", "f = \"1.9e-3 N m s\"")])), [-1, 1, -1]);
}

/// Three pole pairs give six angles, each with the currents of the phasor diagram; the compiled law is steady there.
#[test]
fn a_motor_on_a_supply_rests_with_the_currents_that_its_law_keeps() {
    let scene = scene("machines/permanent_magnet_bench");
    let MotorStates::InStep { angles, bears, .. } = motor(&scene) else { panic!("it follows its field") };
    assert_eq!(angles.iter().filter(|angle| angle.slope < 0).count(), 3);
    assert_eq!(angles.len(), 6);
    assert!(bears.is_some_and(|bears| bears.greatest > 0.05 && bears.least < -0.05), "{bears:?}");
    for angle in &angles {
        let start = Start {
            rotor_angle: angle.radians(),
            rotor_speed: 150.0,
            currents: angle.currents.clone(),
            ..scene.start.clone()
        };
        let problem = Scene { start, ..scene.clone() }.problem(Axes::First);
        let mut rates = vec![f64::NAN; problem.state.len()];
        problem.law.rates(0.0, &problem.state, &mut rates);
        // 14 V on 1.2 mH gives 1e4 A/s; each rate is zero up to rounding
        assert!(rates.iter().all(|rate| rate.abs() < 1e-9), "{rates:?} at {angle:?}");
    }
}

/// The steady state w = u k / (k^2 + f R), i = f w / k.
#[test]
fn a_brushed_motor_has_one_speed_and_one_current() {
    let MotorStates::Slipping { speeds, .. } = motor(&scene("machines/brushed")) else { panic!("it has no angle") };
    let [Slip { speed, slope: -1, currents }] = &speeds[..] else { panic!("{speeds:?}") };
    let (u, k, r, f) = (24.0, 0.045, 0.6, 1e-4);
    let expected = u * k / (k * k + f * r);
    assert!((speed.to_f64() / expected - 1.0).abs() < 1e-15, "{}", speed.to_f64());
    assert!((currents[0] / (f * expected / k) - 1.0).abs() < 1e-15, "{currents:?}");
    let ideal = [
        ("resistance = \"0.6 ohm\"", "resistance = \"0 ohm\""),
        ("system = ", "allow = [\"zero resistance\"]\nsystem = "),
    ];
    let ideal = with("machines/brushed", &ideal);
    assert_eq!(MotorStates::of(&ideal.machine).map(|_| ()), Err(NoMotor::NoRest));
}

/// The torque of crossed windings depends on the slip only: at synchronism nothing balances friction, and without
/// friction every angle is steady.
#[test]
fn crossed_windings_are_never_held_in_step() {
    let found = motor(&scene("machines/crossed_windings_bench"));
    assert!(matches!(&found, MotorStates::InStep { angles, .. } if angles.is_empty()), "{found:?}");
    let free = with("machines/crossed_windings_bench", &[("f = \"4e-4 N m s\"", "f = \"0 N m s\"")]);
    assert_eq!(MotorStates::of(&free.machine).map(|_| ()), Err(NoMotor::AnyAngle));
}

#[test]
fn every_motion_of_every_scene_is_one_of_the_equations_that_run() {
    let files = [
        "spin_up",
        "free_rotor",
        "asynchronous_drive",
        "constant_speed",
        "hanging_rest",
        "permanent_rotation",
        "stiff_damper",
        "pull_out",
        "machines/brushed",
        "machines/permanent_magnet",
    ];
    for name in files {
        let scene = scene(name);
        let stationary = Stationary::of(&scene).expect("a gyrostat");
        for w in [0.0, 3.0, -20.0, 100.0] {
            for answer in stationary.at_speed(w).expect("finite") {
                assert!(answer.certificate.is_complete(), "{name} {w} {:?}", answer.certificate);
                for found in &answer.found {
                    // rounding errors of accelerations of this magnitude
                    let size = w * w + w.abs() * found.rotor_speed.abs() + 1e3;
                    assert!(found.residual <= 1e-11 * size, "{name}, w = {w}: {:e}", found.residual);
                }
            }
        }
        for answer in stationary.at_momentum(stationary.momentum_at_start()).expect("finite") {
            for found in &answer.found {
                let size = found.speed.powi(2) + found.speed.abs() * found.rotor_speed.abs() + 1e3;
                assert!(found.residual <= 1e-10 * size, "{name}: {:e} at {found:?}", found.residual);
            }
        }
    }
}
