//! Closed forms of motions with friction, compared with runs of the stored scenes with other data.

use super::{close, edited, events, last, runs};
use field::{Analytic, Circle, Scalar};
use integrators::Method;
use simulation::Trajectory;

const G: f64 = 9.81;

/// alpha'^2 as a function of alpha for a uniform ladder that slides with equal friction f = tan phi at wall and floor (upwards for negative f),
/// from (alpha_0, alpha_0'^2): (J + m l^2 cos 2phi) alpha'' = m g l sin(alpha - 2phi) + m l^2 sin 2phi alpha'^2.
pub fn ladder(friction: f64, gravity: f64, half_length: f64, [start, squared]: [f64; 2], alpha: f64) -> f64 {
    let twice = 2.0 * friction.atan();
    let whole = 1.0 / 3.0 + twice.cos();
    let (k, p) = (gravity / (half_length * whole), twice.sin() / whole);
    let particular = |a: f64| -2.0 * k / (1.0 + 4.0 * p * p) * (2.0 * p * (a - twice).sin() + (a - twice).cos());
    particular(alpha) + (squared - particular(start)) * (2.0 * p * (alpha - start)).exp()
}

/// x1'^2 as a function of theta for the steered rod with equal masses that slides without drive (backwards for f < 0), from
/// (theta_0, x1'_0^2): v' + 2 f v = l g (cos theta - f sin theta).
pub fn steered(friction: f64, gravity: f64, length: f64, [start, squared]: [f64; 2], theta: f64) -> f64 {
    let weight = length * gravity;
    let q = weight * (1.0 - 2.0 * friction * friction) / (1.0 + 4.0 * friction * friction);
    let particular = |a: f64| friction * (weight + 2.0 * q) * a.cos() + q * a.sin();
    particular(theta) + (squared - particular(start)) * (-2.0 * friction * (theta - start)).exp()
}

/// The time at which a climbed ladder begins to slide: both reactions are at their friction limits.
pub fn climbed<S: Scalar>(
    friction: S,
    [own, load]: [S; 2],
    half_length: S,
    speed: S,
    Circle { cos, sin }: Circle<S>,
) -> S {
    let wall = friction * (own + load) / (S::one() + friction.squared());
    let moment = S::int(2) * half_length * wall * (cos + friction * sin) - own * half_length * sin;
    moment / (load * sin) / speed
}

/// A run of a ladder of 1 kg between wall and floor with the half length 1 m.
fn leaning(friction: f64, [alpha, spin]: [f64; 2], span: f64) -> Trajectory {
    let friction = friction.to_string();
    let text = edited(
        "friction/pushed_ladder",
        &[
            ("m", "1 kg"),
            ("l", "1 m"),
            ("f_wall", &friction),
            ("f_floor", &friction),
            ("alpha", &format!("{alpha} rad")),
            ("\"alpha'\"", &format!("{spin} rad/s")),
            ("span", &format!("{span} s")),
        ],
    );
    runs(&text, Method::DormandPrince8, 1e-14)
}

/// The value of a column at an event of a run.
fn at(trajectory: &Trajectory, event: usize, name: &str) -> f64 {
    trajectory.passages[event].row[trajectory.column(name).unwrap_or_else(|| panic!("{name}"))]
}

fn then(trajectory: &Trajectory, event: usize) -> &str {
    trajectory.passages[event].then.as_deref().unwrap_or_default()
}

/// (m l^2 + J) alpha'^2 / 2 = m g l (cos alpha_0 - cos alpha)
#[test]
fn the_frictionless_ladder_leaves_the_wall_at_two_thirds_of_its_height() {
    for alpha in [0.1, 0.3, 0.7, 1.0] {
        let found = leaning(0.0, [alpha, 0.0], 1.2);
        assert!(then(&found, 1).contains("contact `wall` is apart"), "{:?}", found.passages);
        close(at(&found, 1, "alpha").cos(), alpha.cos() * 2.0 / 3.0, 1e-12);
        close(at(&found, 1, "alpha'").powi(2), 2.0 * G / (4.0 / 3.0) * alpha.cos() / 3.0, 1e-11);
    }
}

#[test]
fn the_rough_ladder_slides_as_its_quadrature_says() {
    for friction in [0.05, 0.2, 0.4] {
        let found = leaning(friction, [1.0, 0.0], 0.2);
        assert_eq!((found.stopped(), events(&found).len()), (None, 0));
        let exact = ladder(friction, G, 1.0, [1.0, 0.0], last(&found, "alpha"));
        close(last(&found, "alpha'").powi(2), exact, 1e-12 * (1.0 + exact));
    }
}

/// N_A = 0 while both ends slide: m x'' + f (m y'' + m g) = 0
#[test]
fn the_rough_ladder_leaves_the_wall_where_its_quadrature_says() {
    let found = leaning(0.2, [1.0, 0.0], 0.8);
    assert!(found.passages[1].what.contains("normal reaction of contact `wall`"), "{:?}", found.passages);
    let (alpha, squared) = (at(&found, 1, "alpha"), at(&found, 1, "alpha'").powi(2));
    close(squared, ladder(0.2, G, 1.0, [1.0, 0.0], alpha), 1e-11);
    let twice = 2.0 * 0.2_f64.atan();
    let turning = (G * (alpha - twice).sin() + twice.sin() * squared) / (1.0 / 3.0 + twice.cos());
    let across = alpha.cos() * turning - alpha.sin() * squared;
    let down = -alpha.sin() * turning - alpha.cos() * squared;
    close(across + 0.2 * (down + G), 0.0, 1e-11);
}

/// If the ladder is pushed upwards, friction has the opposite sign in the closed form.
#[test]
fn a_push_up_ends_at_rest_on_a_steep_ladder_and_is_reversed_on_a_flat_one() {
    let steep = leaning(0.3, [0.3, -1.0], 1.0);
    assert_eq!(steep.stopped(), None);
    assert_eq!((steep.passages.len(), then(&steep, 1)), (2, "contact `wall` sticks, contact `floor` sticks"));
    close(ladder(-0.3, G, 1.0, [0.3, 1.0], at(&steep, 1, "alpha")), 0.0, 1e-12);
    let flat = leaning(0.3, [0.7, -1.0], 0.5);
    assert_eq!(then(&flat, 1), "contact `wall` slides forwards, contact `floor` slides forwards");
    close(ladder(-0.3, G, 1.0, [0.7, 1.0], at(&flat, 1, "alpha")), 0.0, 1e-12);
}

#[test]
fn friction_takes_energy_and_a_ladder_without_it_keeps_its_own() {
    for friction in [0.0, 0.1, 0.3, 0.5] {
        let found = leaning(friction, [0.9, 0.5], 0.6);
        let [kinetic, potential] =
            ["kinetic_energy", "potential_energy"].map(|name| found.column(name).expect("a column"));
        let energies: Vec<f64> = found.rows.iter().map(|row| row[kinetic] + row[potential]).collect();
        for pair in energies.windows(2) {
            let gained = pair[1] - pair[0];
            assert!(gained < 1e-12 && (friction > 0.0 || gained > -1e-12), "f = {friction}: {gained:e}");
        }
    }
}

#[test]
fn the_steered_rod_of_equal_masses_has_a_closed_form() {
    for sigma in [1.0, -1.0] {
        let speed = format!("{} m/s", 2.0 * sigma);
        let text = edited("friction/steered_rod", &[("theta", "1 rad"), ("\"x'\"", &speed), ("span", "0.1 s")]);
        let found = runs(&text, Method::DormandPrince8, 1e-14);
        assert_eq!((found.stopped(), events(&found).len()), (None, 0));
        let exact = steered(sigma * 0.2, G, 1.5, [1.0, 4.0], last(&found, "theta"));
        close(last(&found, "x'").powi(2), exact, 1e-12 * (1.0 + exact));
    }
}

/// Slipping begins where both reactions are at their friction limits.
#[test]
fn a_ladder_that_is_climbed_slips_when_statics_says() {
    let text = edited("friction/climbed_ladder", &[("alpha", "0.7 rad")]);
    let found = runs(&text, Method::DormandPrince8, 1e-14);
    let slip = &found.passages[2];
    assert!(slip.what.starts_with("friction does not hold"), "{:?}", found.passages);
    let exact = climbed(0.4, [20.0 * G, 700.0], 2.0, 0.5, at(&found, 2, "alpha").circle());
    close(slip.time, exact, 1e-12 * exact);
}

/// Rotation about the fixed end: 4/3 theta'' = -g cos theta, so that theta'^2 = 3/2 g (sin theta_0 - sin theta), until T/N = f.
#[test]
fn a_rod_falls_from_stick_into_slip_when_friction_is_spent() {
    let values = [("f", "0.5"), ("theta", "1 rad"), ("\"x'\"", "0 m/s"), ("\"theta'\"", "0 rad/s"), ("span", "0.7 s")];
    let found = runs(&edited("friction/jam", &values), Method::DormandPrince8, 1e-14);
    assert_eq!(then(&found, 0), "contact `end` sticks");
    assert!(found.passages[1].what.starts_with("friction does not hold"), "{:?}", found.passages);
    assert!(then(&found, 1).contains("slides"));
    let (theta, spin) = (at(&found, 1, "theta"), at(&found, 1, "theta'"));
    let squared = 1.5 * G * (1.0_f64.sin() - theta.sin());
    close(spin.powi(2), squared, 1e-11);
    let turning = -0.75 * G * theta.cos();
    let tangential = -theta.sin() * turning - theta.cos() * squared;
    let normal = theta.cos() * turning - theta.sin() * squared + G;
    close(tangential.abs(), 0.5 * normal, 1e-10);
}
