//! Pull-out: synchronous steady angles over the load.

use super::{loaded, pendulum, scene};
use dalembert_derivations::studies::stationary::motor::{MotorStates, NoMotor};
use dalembert_derivations::studies::synchronism::branches::Standing;
use dalembert_derivations::studies::synchronism::loaded::{Loaded, giving_way};
use std::f64::consts::{FRAC_PI_2, PI};

fn folds(all: &[Standing]) -> Vec<Standing> {
    all.iter().filter(|standing| standing.fold).cloned().collect()
}

#[test]
fn the_angles_merge_where_the_closed_form_says_and_the_exact_roots_too() {
    for (name, hold, friction) in [("bench", 0.15, 0.015), ("spin_up", 0.15, 0.015), ("stiff_damper", 0.15, 0.015)] {
        let (scene, motor) = (scene(name), loaded(&scene(name)));
        let found = folds(&motor.in_step());
        // M = -b0 sin g - f W
        let known = [(-FRAC_PI_2, hold - friction), (FRAC_PI_2, -hold - friction)];
        assert_eq!(found.len(), 2, "{name}: {found:?}");
        for (fold, (angle, load)) in found.iter().zip(known) {
            assert!((fold.load - load).abs() < 1e-12 * hold && (fold.angle - angle).abs() < 1e-12, "{name}: {fold:?}");
        }
        let Ok(MotorStates::InStep { bears: Some(bears), .. }) = MotorStates::of(&scene.machine) else {
            panic!("{name} follows its field")
        };
        let ends = [bears.greatest, bears.least];
        assert!(found.iter().zip(ends).all(|(fold, end)| (fold.load - end).abs() < 1e-12 * hold), "{ends:?}");
    }
}

#[test]
fn between_the_folds_the_angle_is_stable_and_beyond_it_is_not() {
    for motor in [loaded(&scene("bench")), loaded(&pendulum(0.3))] {
        let all = motor.in_step();
        assert!(all.len() > 20 && all[0].angle < -PI + 0.3 && all[all.len() - 1].angle > PI - 0.3);
        for one in all.iter().filter(|one| !one.fold) {
            assert_eq!(one.growth < 0.0, one.angle.abs() < FRAC_PI_2, "{one:?}");
        }
        // at a fold one eigenvalue is zero, up to rounding errors from the eigenvalues of the windings
        assert!(folds(&all).iter().all(|fold| fold.growth.abs() < 1e-10 * motor.facts.frequency));
    }
}

#[test]
fn exact_roots_under_a_load_lie_on_the_branch() {
    let scene = scene("bench");
    let motor = loaded(&scene);
    for load in [-0.1, 0.03, 0.1349] {
        let Ok(MotorStates::InStep { angles, .. }) = MotorStates::under(&scene.machine, load) else {
            panic!("in step")
        };
        let mut found: Vec<f64> = angles.iter().map(|angle| angle.radians()).collect();
        found.sort_by(f64::total_cmp);
        let held = -((load + 0.015) / 0.15_f64).asin();
        let other = if held < 0.0 { -PI - held } else { PI - held };
        let mut known = [held, other];
        known.sort_by(f64::total_cmp);
        assert!(found.len() == 2 && found.iter().zip(known).all(|(a, b)| (a - b).abs() < 1e-7), "{found:?} {known:?}");
    }
    assert!(
        matches!(MotorStates::under(&scene.machine, 0.136), Ok(MotorStates::InStep { angles, .. }) if angles.is_empty())
    );
    assert!(
        matches!(MotorStates::under(&scene.machine, 0.135), Ok(MotorStates::InStep { angles, .. }) if angles[0].slope == 0)
    );
    assert!(
        MotorStates::under(&scene.machine, f64::NAN).is_err_and(|reason| matches!(reason, NoMotor::NotAlgebraic(_)))
    );
    assert!(!motor.in_step().is_empty());
}

#[test]
fn a_motor_without_a_field_or_an_angle_is_refused_by_name() {
    let asynchronous = Loaded::of(&scene("asynchronous_drive")).err().expect("it has no angle").to_string();
    assert!(asynchronous.contains("kloss") && asynchronous.contains("accepted"), "{asynchronous}");
    let mut flat = scene("bench");
    flat.machine = flat.machine.with("b0", 0.0).expect("it has a field");
    let flat = Loaded::of(&flat).err().expect("nothing holds").to_string();
    assert!(flat.contains("b0 > 0 of a synchronous machine is accepted"), "{flat}");
}

#[test]
fn the_carrier_makes_the_rotor_lighter() {
    let scene = scene("spin_up");
    let dalembert_derivations::studies::scene::Setup::Gyrostat(bodies) = &scene.system else {
        panic!("it has a carrier")
    };
    let light = giving_way(bodies);
    assert!(light < bodies.rotor.axial && light > 0.9 * bodies.rotor.axial, "{light}");
}
