//! Basins of attraction of synchronism: the initial states from which it is reached.

use super::{pendulum, scene};
use dalembert_derivations::studies::scene::{Scene, Setup};
use dalembert_derivations::studies::synchronism::basin::{Share, Starts, shares};
use dalembert_derivations::studies::synchronism::loaded::giving_way;
use reader::Family;

const STARTS: Starts = Starts { angles: 6, slips: 5, slip: [-5.0, 0.0] };

fn told(all: &[Share]) -> Vec<(usize, usize, usize)> {
    all.iter().map(|share| (share.in_step, share.slipping, share.undecided())).collect()
}

#[test]
fn below_the_pull_in_all_starts_come_into_step_beyond_the_pull_out_none_between_them_some() {
    let scene = pendulum(0.2);
    // pull-in occurs at a total braking torque of 0.253, of which friction contributes 2
    let loads = [0.1, 0.24, 0.27, 0.4, 0.6, 1.02].map(|drag| drag - 2.0);
    let found = shares(&scene, &loads, STARTS, 150.0).expect("a motor");
    assert!(found[..2].iter().all(|share| share.in_step == share.starts), "{:?}", told(&found));
    assert!(found[2..5].iter().all(|share| share.in_step > 0 && share.slipping > 0), "{:?}", told(&found));
    assert!(found[5].slipping == found[5].starts, "{:?}", told(&found));
    assert!(found.iter().all(|share| share.undecided() == 0 && share.starts == 30));
    assert!(found.windows(2).all(|pair| pair[0].in_step >= pair[1].in_step));
}

#[test]
fn the_same_motor_with_all_its_bars_and_with_its_equivalent_windings_has_the_same_shares() {
    let mut scene = scene("bench");
    let starts = Starts { slip: [-150.0, 0.0], ..STARTS };
    let loads = [0.0, 0.04, 0.08, 0.12];
    let all = shares(&scene, &loads, starts, 3.0).expect("a motor");
    scene.machine = scene.given.model("equivalent_windings").expect("its data are complete");
    let lumped = shares(&scene, &loads, starts, 3.0).expect("a motor");
    assert_eq!(all, lumped);
    assert_eq!(lumped, shares(&scene, &loads, starts, 3.0).expect("a motor"));
}

/// A gyrostat with a vertical principal rotor axis through the centre of mass.
const UPRIGHT: &str = r#"
    title = "Upright"
    description = "The carrier turns about the vertical, and gives way to the motor."
    system = "gyrostat"
    gravity = "9.81 m/s^2"
    carrier = { mass = "1.5 kg", centre = "0 0 60 mm", inertia = "0.0096 0 0; 0 0.0096 0; 0 0 4.8e-4 kg m^2" }
    rotor = { mass = "0.3 kg", centre = "0 0 72 mm", axis = "0 0 1", axial = "2.4e-4 kg m^2", transverse = "1.5e-4 kg m^2" }
    machine = { model = "synchronous", field_speed = "150 rad/s", b0 = "0.15 N m", f = "1.5e-3 N m s" }
    start = { angular_velocity = "0 0 0 rad/s", vertical = "0 0 1", rotor_angle = "0 rad", rotor_speed = "0 rad/s" }
    run = { span = "1 s", samples = 1, tolerance = 1e-9, outputs = ["slip"] }
"#;

/// With a carrier of twice the rotor's moment of inertia the effective moment of inertia is two thirds of the rotor's.
#[test]
fn in_an_upright_gyrostat_the_same_starts_come_into_step_as_with_a_lighter_rotor_on_a_bench() {
    let upright = Scene::parse("upright.toml", UPRIGHT).unwrap_or_else(|error| panic!("{error}"));
    let Setup::Gyrostat(bodies) = &upright.system else { panic!("it has a carrier") };
    let axial = giving_way(bodies);
    assert!((axial - 1.6e-4).abs() < 1e-18, "{axial}");
    let bench = |axial| Scene { system: Setup::Bench { axial }, ..upright.clone() };
    let starts = Starts { slip: [-150.0, 0.0], ..STARTS };
    // total braking torques of 0.04 to 0.14, of which friction contributes 0.225
    let loads = [0.04, 0.06, 0.08, 0.1, 0.14].map(|drag| drag - 0.225);
    let counts = |scene: &Scene| told(&shares(scene, &loads, starts, 4.0).expect("a motor"));
    let (found, light, heavy) = (counts(&upright), counts(&bench(axial)), counts(&bench(2.4e-4)));
    assert_eq!(found, light);
    assert_ne!(found, heavy);
}

#[test]
fn in_a_gyrostat_that_hangs_askew_the_motor_comes_into_step_below_the_pull_in_and_not_beyond_the_pull_out() {
    let starts = Starts { angles: 4, slips: 3, slip: [-150.0, 0.0] };
    let found = shares(&scene("spin_up"), &[0.0, 0.02, 0.15], starts, 3.0).expect("a motor");
    assert_eq!(told(&found), [(12, 0, 0), (12, 0, 0), (0, 12, 0)]);
}
