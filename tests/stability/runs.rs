//! Runs compared with eigenvalues: growth at the rate of the largest real part, and no growth near stable motions.

use crate::running::{Law, eigenvalues, run, state};
use dalembert_derivations::machines::asynchronous::Asynchronous;
use dalembert_derivations::studies::scene::{Scene, Setup, Start};
use dalembert_derivations::studies::stationary::motions::Stationary;
use dalembert_derivations::studies::stationary::motor::MotorStates;
use dalembert_derivations::studies::stationary::stability::{Judged, Reason, StabilityVerdict};
use dalembert_derivations::systems::gyrostat::forms::SecondForm;
use integrators::{Jacobian, spectrum};
use motor::ConstantSpeed;
use motor::Machine;
use nalgebra::Vector3;
use reader::Family;
use simulation::Axes;
use std::path::Path;

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// The state after a small tilt.
fn disturbed(state: &[f64], size: f64) -> Vec<f64> {
    let mut disturbed = state.to_vec();
    disturbed[0] += 0.8 * size;
    disturbed[1] -= 0.5 * size;
    disturbed
}

/// The growth rate of a disturbance, from the ends of two runs of `steps` steps each.
fn growth<M: Machine<f64>>(law: &Law<M>, at: &[f64], step: f64, steps: usize) -> f64 {
    let first = run(law, disturbed(at, 1e-12), step, steps);
    let second = run(law, first.clone(), step, steps);
    (distance(&second, at) / distance(&first, at)).ln() / (step * steps as f64)
}

/// The eigenvalue with the largest real part.
fn fastest<M: Machine<f64>>(law: &Law<M>, at: &[f64]) -> (f64, f64) {
    let all = eigenvalues(law, at);
    all.into_iter().fold((f64::NEG_INFINITY, 0.0), |best, one| if one.0 > best.0 { (one.0, one.1.abs()) } else { best })
}

fn upright(axis: Vector3<f64>, speed: f64) -> Law<ConstantSpeed<f64>> {
    // A* = (4, 9, 6), A' = 1/2, Gamma = 1
    let form = SecondForm::new(Vector3::new(4.0, 9.0, 6.0), axis, 0.5, Vector3::z());
    Law::new(form, ConstantSpeed { speed })
}

#[test]
fn upright_with_the_rotor_across_it_falls_at_the_proved_rate() {
    let law = upright(Vector3::x(), 3.0);
    let at = state(&law, -Vector3::z(), 0.0, 3.0, 0.0);
    // z^2 = Gamma / A1
    let rate = growth(&law, &at, 0.01, 2000);
    assert!((rate - 0.5).abs() < 1e-4, "{rate}");
}

#[test]
fn upright_with_the_rotor_along_it_falls_when_slow_and_stays_when_fast() {
    let fast = upright(Vector3::z(), 10.2);
    let at = state(&fast, -Vector3::z(), 0.0, 10.2, 0.0);
    let after = run(&fast, disturbed(&at, 1e-6), 0.02, 20_000);
    assert!(distance(&after, &at) < 1e-4, "{:e}", distance(&after, &at));
    let slow = upright(Vector3::z(), 6.0);
    let at = state(&slow, -Vector3::z(), 0.0, 6.0, 0.0);
    let (rate, swing) = fastest(&slow, &at);
    // after a whole oscillation the disturbance has the same phase
    let step = std::f64::consts::TAU / swing / 4000.0;
    let measured = growth(&slow, &at, step, 4000);
    assert!((measured / rate - 1.0).abs() < 1e-3 && rate > 0.1, "{measured} beside {rate}");
}

/// A motion that is stabilised gyroscopically at constant rotor speed becomes unstable with a motor of the same steady
/// speed.
#[test]
fn what_gyroscopic_forces_hold_at_constant_speed_leaves_with_a_motor() {
    let scene = Scene::open(Path::new("scenes/constant_speed.toml")).unwrap();
    let Setup::Gyrostat(bodies) = &scene.system else { panic!("a gyrostat") };
    let all = Stationary::of(&scene).unwrap().at_speed(20.0).unwrap();
    let held = |found: &&dalembert_derivations::studies::stationary::motions::Found| {
        found.stability[0].verdict == StabilityVerdict::CannotTell(Reason::Gyroscopic { negative: 2 })
    };
    let found = all[0].found.iter().find(held).unwrap();
    let (form, axes) = bodies.second_form();
    let v = axes.transpose() * found.direction;
    let kept = Law::new(form, ConstantSpeed { speed: 150.0 });
    let at = state(&kept, v, 20.0, 150.0, 0.0);
    let after = run(&kept, disturbed(&at, 1e-6), 5e-4, 100_000);
    assert!(distance(&after, &at) < 1e-4, "{:e}", distance(&after, &at));
    let motor = Asynchronous { field_speed: 150.0, k: 6e-4, f: 0.0 };
    let law = Law::new(form, motor);
    let at = state(&law, v, 20.0, 150.0, 0.0);
    let (rate, swing) = fastest(&law, &at);
    assert!(rate > 0.1, "{rate}");
    // whole oscillations, with steps of about a millisecond
    let span = 20.0 * std::f64::consts::TAU / swing;
    let steps = (span / 1e-3) as usize;
    let measured = growth(&law, &at, span / steps as f64, steps);
    assert!((measured / rate - 1.0).abs() < 1e-2, "{measured} beside {rate}");
}

/// For each equilibrium of a scene with each position of its rotor: the verdict, and the number of eigenvalues of the
/// compiled law's Jacobian with positive real part.
fn beside_the_law(scene: &Scene) -> Vec<(Judged, usize)> {
    let stationary = Stationary::of(scene).unwrap();
    let places: Vec<(f64, &[f64])> = match &stationary.motor {
        MotorStates::InStep { angles, .. } => {
            angles.iter().map(|angle| (angle.radians(), &angle.currents[..])).collect()
        }
        MotorStates::Slipping { speeds, .. } => speeds.iter().map(|slip| (0.0, &slip.currents[..])).collect(),
        _ => panic!("it has currents"),
    };
    let mut judged = Vec::new();
    for found in stationary.at_speed(0.0).unwrap().iter().flat_map(|answer| &answer.found) {
        for (&(rotor_angle, currents), one) in places.iter().zip(&found.stability) {
            let start = Start {
                angular_velocity: Vector3::zeros(),
                vertical: found.direction,
                rotor_angle,
                rotor_speed: found.rotor_speed,
                currents: currents.to_vec(),
            };
            let problem = Scene { start, ..scene.clone() }.problem(Axes::Second);
            let n = problem.state.len();
            let mut matrix = vec![0.0; n * n];
            Jacobian::new(&*problem.law).matrix(0.0, &problem.state, &mut matrix);
            let roots = spectrum(n, &matrix).expect("the iteration ends");
            // the motor drives oscillations of the carrier at rates of a few 1e-9 1/s; the zero eigenvalues of the
            // integrals have rounding errors of 1e-13
            judged.push((one.clone(), roots.iter().filter(|root| root.re > 1e-10).count()));
        }
    }
    judged
}

/// A permanent-magnet motor on a stiff supply oscillates with growing amplitude (hunting) if the resistance of its
/// windings is too small; a brushed motor retains its speed. With a supply, which adds energy, only Routh's criterion
/// decides.
#[test]
fn a_motor_on_a_supply_is_judged_by_its_roots_and_not_by_an_energy_that_is_fed() {
    let of = |name: &str, resistance: &str| {
        let text = std::fs::read_to_string(format!("scenes/machines/{name}.toml")).unwrap();
        let given = |line: &str| line.starts_with("resistance").then(|| format!("resistance = \"{resistance}\""));
        let lines: Vec<String> = text.lines().map(|line| given(line).unwrap_or_else(|| line.to_owned())).collect();
        beside_the_law(&Scene::parse(name, &lines.join("\n")).unwrap())
    };
    for (name, resistance, holds) in
        [("permanent_magnet", "0.25 ohm", false), ("permanent_magnet", "0.6 ohm", true), ("brushed", "0.6 ohm", true)]
    {
        let all = of(name, resistance);
        for (judged, right) in &all {
            assert!(judged.energy.is_none() && !judged.conservative, "{name}: {judged:?}");
            assert_eq!(judged.roots.map(|roots| roots.right), Some(*right), "{name}: {judged:?}");
        }
        let held =
            |(judged, _): &(Judged, usize)| judged.verdict == StabilityVerdict::AsymptoticallyStableModuloIntegrals;
        assert_eq!(all.iter().any(held), holds, "{name}, {resistance}");
    }
}
