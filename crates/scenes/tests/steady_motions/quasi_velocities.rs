//! Steady motions of systems that roll, slide along edges, or use quasi-velocities.

use super::{all, asked, held, model, values};
use dalembert_scenes::independent_start;
use dalembert_scenes::steady_motions::{SteadyMotion, SteadyMotions, SteadyStability};
use std::f64::consts::PI;

/// A hoop whose height is a coordinate. The vertical component of rolling follows from the contact and is removed; the others remain, so that the hoop
/// rolls upright and in circles as without this coordinate.
#[test]
fn rolling_beside_a_contact_is_taken_apart_along_the_ground() {
    let hoop = r#"
title = "Hoop"
gravity = "-(9.81 m/s^2)*N.z"
[parameters]
m = "2 kg"
R = "0.3 m"
[coordinates]
x = "m"
y = "m"
z = "m"
heading = "rad"
lean = "rad"
spin = "rad"
[frames]
B = "N turned heading about z"
K = "B turned -lean about x"
D = "K turned spin about y"
[points]
G = "O + x*N.x + y*N.y + z*N.z"
P = "G - R*K.z"
[bodies.hoop]
frame = "D"
centre = "G"
mass = "m"
inertia = { axes = "K", principal = ["m*R^2/2", "m*R^2", "m*R^2/2"] }
[[constraint]]
name = "rolling"
zero = "velocity(hoop at P)"
[[constraint]]
name = "touch"
zero = "(P - O) . N.z"
[start]
z = "0.3 m"
"#;
    let mut model = model(hoop);
    independent_start(&mut model).expect("the constraints agree");
    // (g/R) sin a = w cos a (2 s - 3/2 w sin a) for the lean a, and the rates w of the heading and s of the spin
    for (heading, spin) in [(0.0_f64, 3.0_f64), (1.0, 3.0)] {
        let ranges = asked(&[("heading'", heading, heading), ("spin'", spin, spin), ("z", 0.0, 1.0)], 20_000);
        let found = SteadyMotions::of(&model, &ranges, || true).unwrap_or_else(|why| panic!("{why:?}"));
        assert!(found.is_complete() && found.motions.len() == 1, "{found:?}");
        let (z, lean) = (found.motions[0].state[2], found.motions[0].state[4]);
        assert!((z - 0.3 * lean.cos()).abs() < 1e-9, "{z} {lean}");
        let left = 9.81 / 0.3 * lean.sin() - heading * (2.0 * spin - 1.5 * heading * lean.sin()) * lean.cos();
        assert!(left.abs() < 1e-9, "{left} {lean}");
    }
}

/// A disc that rolls straight ahead: lean'' = (4 g/(5 r) - 12/5 s^2) lean at the spin s; heading and spin are constant.
#[test]
fn a_disc_that_rolls_straight_falls_below_a_spin() {
    const DISC: &str = include_str!("../../../../scenes/models/rolling_disc.toml");
    for spin in [5.0, 2.0] {
        let found = all(DISC, &[("heading'", 0.0, 0.0), ("spin'", spin, spin), ("lean", -1.0, 1.0)]);
        assert_eq!((found.motions.len(), found.free_speeds.len()), (1, 2));
        let square: f64 = 0.8 * 9.81 / 0.343 - 2.4 * spin * spin;
        let at = discs(&found.motions[0]);
        assert!(
            at.len() == 2
                && at.iter().all(|[re, im]| {
                    let (own, other) = if square > 0.0 { (re, im) } else { (im, re) };
                    (own.abs() - square.abs().sqrt()).abs() < 1e-10 && other.abs() < 1e-10
                }),
            "{at:?}"
        );
    }
}

/// A disc that rolls in a circle: 3/2 W s cos(a) - 5/4 W^2 sin(a) cos(a) = g/r sin(a) for a lean a, the rate W of the heading and a spin s.
#[test]
fn a_disc_rolls_in_circles_at_every_lean_at_which_it_can() {
    const DISC: &str = include_str!("../../../../scenes/models/rolling_disc.toml");
    for (turn, spin) in [(0.5, 6.0), (6.0, -3.0), (9.0, 0.0), (0.0, 5.0)] {
        let found = all(DISC, &[("heading'", turn, turn), ("spin'", spin, spin)]);
        assert!(found.is_complete() && found.unknowns.len() == 1);
        let out_of_balance =
            |a: f64| 1.5 * turn * spin * a.cos() - 1.25 * turn * turn * a.sin() * a.cos() - 9.81 / 0.343 * a.sin();
        let steps = 10_000;
        let at = |step: usize| -3.0 + 2.0 * PI * step as f64 / steps as f64;
        let turns = |step: &usize| (out_of_balance(at(*step)) > 0.0) != (out_of_balance(at(*step + 1)) > 0.0);
        let count = (0..steps).filter(turns).count();
        assert_eq!(found.motions.len(), count, "{turn} {spin}");
        for motion in &found.motions {
            let lean = motion.state[3];
            assert!(out_of_balance(lean).abs() < 1e-10, "{lean}");
            // rolling in the direction of the heading, which is x
            assert!((motion.state[5] - 0.343 * spin).abs() < 1e-9, "{:?}", motion.state);
        }
    }
}

const SLEIGH: &str = include_str!("../../../../scenes/models/chaplygin_sleigh.toml");

fn discs(motion: &SteadyMotion) -> Vec<[f64; 2]> {
    let SteadyStability::Linear(found) = &motion.stability else { panic!("{:?}", motion.stability) };
    let enclosed = found.enclosed.as_ref().unwrap_or_else(|why| panic!("{why}"));
    enclosed.discs.iter().map(|disc| disc.centre).collect()
}

/// m v' = m a w^2, (J + m a^2) w' = -m a v w: the sleigh moves straight at every speed v; deviations decay as exp(-m a v t/(J + m a^2)).
#[test]
fn a_sleigh_runs_straight_at_every_speed_in_every_heading() {
    let named = SLEIGH.replace("[frames]", "[speeds]\nv = \"velocity(P) . B.x\"\nw = \"psi'\"\n[frames]");
    let named =
        named.replace("[start]\n\"x'\" = \"1 m/s\"\n\"psi'\" = \"1 rad/s\"", "[start]\nv = \"1 m/s\"\nw = \"1 rad/s\"");
    for (text, v) in [(named.as_str(), "v"), (SLEIGH, "velocity(G).B.x")] {
        for (speed, rate) in [(3.0, -0.3 / 0.11), (-2.0, 0.2 / 0.11)] {
            let found = all(text, &[(v, speed, speed), ("psi'", -2.0, 2.0)]);
            assert_eq!(found.cyclic, ["x", "y", "psi"]);
            assert_eq!(values(&found).iter().map(|one| one.0.clone()).collect::<Vec<_>>(), [[0.0]], "{found:?}");
            let [at] = &discs(&found.motions[0])[..] else { panic!("{found:?}") };
            assert!((at[0] - rate).abs() < 1e-12 && at[1] == 0.0, "{at:?}");
            assert!((found.motions[0].quasi_velocities[0].1 - speed).abs() < 1e-12);
        }
    }
}

/// A car whose steering is held by a spring: at the steering angle d the heading turns at the rate v tan(d)/l.
#[test]
fn a_car_runs_in_a_circle_at_every_speed() {
    const CAR: &str = r#"
title = "Car"
[parameters]
m = "2 kg"
J = "0.3 kg m^2"
I = "0.01 kg m^2"
l = "0.5 m"
k = "1 N m"
[coordinates]
x = "m"
y = "m"
psi = "rad"
d = "rad"
[frames]
B = "N turned psi about z"
F = "B turned d about z"
[points]
P = "O + x*N.x + y*N.y"
Q = "P + l*B.x"
[bodies]
car = { frame = "B", centre = "P", mass = "m", inertia = "J" }
fork = { frame = "F", inertia = "I" }
[[force]]
along = "d"
is = "-k*(d - 0.3)"
[[constraint]]
zero = "velocity(P) . B.y"
[[constraint]]
zero = "velocity(Q) . F.y"
[start]
"x'" = "1 m/s"
[run]
span = "1 s"
"#;
    for speed in [1.0, 4.0] {
        let found = all(CAR, &[("velocity(P).B.x", speed, speed), ("d", -1.0, 1.0)]);
        assert_eq!(found.cyclic, ["x", "y", "psi"]);
        let [motion] = &found.motions[..] else { panic!("{found:?}") };
        assert!((motion.state[3] - 0.3).abs() < 1e-12 && (motion.state[6] - speed * 0.3_f64.tan() / 0.5).abs() < 1e-12);
    }
}

/// Whipple's bicycle moves straight ahead at every speed.
#[test]
fn a_bicycle_runs_straight_at_every_speed() {
    const BICYCLE: &str = include_str!("../../../../scenes/foreign/bicycle.toml");
    let near = 1e-5;
    let found = all(
        BICYCLE,
        &[("rear'", -17.51, -17.5), ("lean", -near, near), ("pitch", -near, near), ("steer", -near, near)],
    );
    assert!(found.is_complete() && found.motions.is_empty(), "{:?}", found.regions);
    let [(straight, _)] = &found.families[..] else { panic!("{:?}", found.families) };
    assert_eq!(straight.dimension, 1);
    for speed in [-17.51, -17.503, -17.5] {
        assert!(held(straight, &straight_on(&found, speed)));
    }
}

fn straight_on(found: &SteadyMotions, speed: f64) -> Vec<f64> {
    found.unknowns.iter().map(|unknown| if unknown.name == "rear'" { speed } else { 0.0 }).collect()
}

/// A skate driven along its edge against drag: F = c v for every heading; the force is given along the quasi-velocity v.
#[test]
fn a_force_along_a_quasi_velocity_drives_the_steady_motion() {
    const FORCES: &str = "[[force]]\nalong = \"v\"\nis = \"(2 N) - (0.5 N s/m)*v\"\n[[force]]\nalong = \"w\"\nis = \"-(0.05 N m s)*w\"\n";
    let named = SLEIGH.replace("[frames]", "[speeds]\nv = \"velocity(P) . B.x\"\nw = \"psi'\"\n[frames]");
    let named = named.replace(
        "[start]\n\"x'\" = \"1 m/s\"\n\"psi'\" = \"1 rad/s\"",
        &format!("{FORCES}[start]\nv = \"1 m/s\"\nw = \"1 rad/s\""),
    );
    let found = all(&named, &[("v", -10.0, 10.0), ("psi'", -2.0, 2.0)]);
    let [motion] = &found.motions[..] else { panic!("{found:?}") };
    assert!((motion.quasi_velocities[0].1 - 4.0).abs() < 1e-9, "{motion:?}");
}
