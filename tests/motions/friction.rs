//! Motion with friction across events, beside closed forms.

use dalembert_derivations::studies::friction::log::describe;
use dalembert_derivations::studies::friction::run::Plan;
use dalembert_derivations::studies::friction::smoothed::Smoothed;
use dalembert_derivations::studies::friction::stretch::Watched;
use dalembert_derivations::studies::friction::{Cause, Ending, Run, closed, run};
use dalembert_derivations::systems::climbed_ladder::ClimbedLadder;
use dalembert_derivations::systems::ladder::Ladder;
use dalembert_derivations::systems::slender_rod::SlenderRod;
use dalembert_derivations::systems::steered_rod::SteeredRod;
use field::Analytic;
use mechanics::constrained::State;
use mechanics::constrained::contacts::Sides;
use mechanics::regimes::{Condition, Direction, Face, Mode, Unfit};

const G: f64 = 9.81;

fn ladder(friction: f64) -> Ladder<f64> {
    Ladder { mass: 1.0, inertia: 1.0 / 3.0, half_length: 1.0, gravity: G, friction: [friction; 2] }
}

/// On wall and floor.
fn leaning(half: f64, alpha: f64, spin: f64) -> State<f64, 4> {
    let (s, c) = alpha.sin_cos();
    let velocity = [half * spin * c, -half * spin * s, -spin * s, spin * c];
    State { time: 0.0, place: [half * s, half * c, c, s], velocity }
}

fn angle(place: &[f64]) -> f64 {
    place[3].atan2(place[2])
}

fn spin(place: &[f64], velocity: &[f64]) -> f64 {
    place[2] * velocity[3] - place[3] * velocity[2]
}

fn close(found: f64, exact: f64, what: &str) {
    assert!(
        (found - exact).abs() <= 1e-12 * (1.0 + exact.abs()),
        "{what}: {found} but {exact}, off {:.1e}",
        found - exact
    );
}

fn run_ladder(friction: f64, alpha: f64, spin: f64, end: f64) -> Run<4, 2> {
    run::<_, 4, 1, 2>(&ladder(friction), &leaning(1.0, alpha, spin), &Plan::until(end), &mut ())
}

#[test]
fn a_smoothed_contact_has_no_friction_and_the_others_keep_theirs() {
    let start = leaning(1.0, 0.7, 0.0);
    let floor_alone = Ladder { friction: [0.0, 0.3], ..ladder(0.3) };
    let smoothed = Smoothed { system: ladder(0.3), smooth: [true, false] };
    let [of_data, of_smoothed] = [
        run::<_, 4, 1, 2>(&floor_alone, &start, &Plan::until(0.5), &mut ()),
        run::<_, 4, 1, 2>(&smoothed, &start, &Plan::until(0.5), &mut ()),
    ];
    assert_eq!(of_data.state, of_smoothed.state);
    assert_ne!(of_data.state, run_ladder(0.3, 0.7, 0.0, 0.5).state);
    assert_ne!(of_data.state, run_ladder(0.0, 0.7, 0.0, 0.5).state);
}

#[test]
fn the_frictionless_ladder_leaves_the_wall_at_two_thirds_of_its_height() {
    let smoothed = Smoothed { system: ladder(0.3), smooth: [true; 2] };
    for (alpha, found) in [0.1, 0.3, 0.7, 1.0].into_iter().flat_map(|alpha| {
        let smoothed = run::<_, 4, 1, 2>(&smoothed, &leaning(1.0, alpha, 0.0), &Plan::until(5.0), &mut ());
        [(alpha, run_ladder(0.0, alpha, 0.0, 5.0)), (alpha, smoothed)]
    }) {
        let entry = &found.entries[1];
        assert_eq!(entry.regime[0], Mode::Apart);
        close(entry.place[2], alpha.cos() * 2.0 / 3.0, "height at which it detaches");
        // (m l^2 + J) alpha'^2 / 2 = m g l (cos alpha_0 - cos alpha)
        let spin_squared = 2.0 * G / (4.0 / 3.0) * alpha.cos() / 3.0;
        close(spin(&entry.place, &entry.velocity).powi(2), spin_squared, "its rotation there");
    }
}

/// The square of the rotation, from rest at an angle.
fn quadrature(friction: f64, start: f64, alpha: f64) -> f64 {
    closed::ladder(friction, G, 1.0, [start, 0.0], alpha)
}

#[test]
fn the_rough_ladder_slides_as_its_quadrature_says() {
    for friction in [0.05, 0.2, 0.4] {
        let found = run_ladder(friction, 1.0, 0.0, 0.2);
        assert_eq!(found.ending, Ending::Reached);
        assert_eq!(found.entries.len(), 1);
        let exact = quadrature(friction, 1.0, angle(&found.state.place));
        close(spin(&found.state.place, &found.state.velocity).powi(2), exact, "rotation squared");
    }
}

#[test]
fn the_rough_ladder_leaves_the_wall_where_its_quadrature_says() {
    let found = run_ladder(0.2, 1.0, 0.0, 2.0);
    let entry = &found.entries[1];
    assert!(matches!(entry.cause, Cause::Signal { watched: Watched::Condition(0, Condition::Presses), .. }));
    let (alpha, squared) = (angle(&entry.place), spin(&entry.place, &entry.velocity).powi(2));
    close(squared, quadrature(0.2, 1.0, alpha), "rotation squared");
    // N_A = 0 with both slips: m x'' + f (m y'' + m g) = 0
    let twice = 2.0 * 0.2_f64.atan();
    let turning = (G * (alpha - twice).sin() + twice.sin() * squared) / (1.0 / 3.0 + twice.cos());
    let across = alpha.cos() * turning - alpha.sin() * squared;
    let down = -alpha.sin() * turning - alpha.cos() * squared;
    assert!((across + 0.2 * (down + G)).abs() < 1e-11, "{:.1e}", across + 0.2 * (down + G));
}

#[test]
fn a_push_up_ends_at_rest_on_a_steep_ladder_and_is_reversed_on_a_flat_one() {
    let steep = run_ladder(0.3, 0.3, -1.0, 1.0);
    let stick = [Mode::Stick(Face::Front); 2];
    assert_eq!((steep.entries.len(), steep.entries[1].regime, &steep.ending), (2, stick, &Ending::Reached));
    assert_eq!(steep.state.velocity, [0.0; 4]);
    let flat = run_ladder(0.3, 0.7, -1.0, 0.5);
    let down = [Mode::Slip(Direction::Backwards, Face::Front), Mode::Slip(Direction::Forwards, Face::Front)];
    assert_eq!((flat.entries.len(), flat.entries[1].regime), (2, down));
}

#[test]
fn work_and_energy_balance_to_rounding() {
    for friction in [0.0, 0.1, 0.3, 0.5] {
        let found = run_ladder(friction, 0.9, 0.5, 1.0);
        assert!(found.imbalance.abs() < 1e-13 * 100.0, "f = {friction}: {:.1e}", found.imbalance);
        assert!(found.friction_work <= 0.0);
        assert!(found.settled < 1e-13, "f = {friction}: {:.1e}", found.settled);
    }
}

#[test]
fn the_steered_rod_of_equal_masses_has_a_closed_form() {
    let (f, l) = (0.2, 1.5);
    let rod = SteeredRod { guided: 2.0, free: 2.0, length: l, gravity: G, drive: 0.0, friction: f, sides: Sides::Two };
    for sigma in [1.0, -1.0] {
        let (theta, speed): (f64, f64) = (1.0, 2.0 * sigma);
        let (s, c) = theta.sin_cos();
        let turning = 2.0 * speed * s / l;
        let velocity = [speed, 0.0, speed - l * s * turning, l * c * turning];
        let start = State { time: 0.0, place: [0.0, 0.0, l * c, l * s], velocity };
        let found = run::<_, 4, 2, 1>(&rod, &start, &Plan::until(0.1), &mut ());
        assert_eq!((found.entries.len(), &found.ending), (1, &Ending::Reached));
        let [x1, y1, x2, y2] = found.state.place;
        let now = (y2 - y1).atan2(x2 - x1);
        let exact = closed::steered(sigma * f, G, l, [theta, speed * speed], now);
        close(found.state.velocity[0].powi(2), exact, "velocity squared");
    }
}

#[test]
fn a_ladder_that_is_climbed_slides_sticks_slips_and_detaches() {
    let friction = 0.4;
    let ladder = Ladder { mass: 20.0, inertia: 80.0 / 3.0, half_length: 2.0, gravity: G, friction: [friction; 2] };
    let climbed = ClimbedLadder { ladder, weight: 700.0, speed: 0.5 };
    let found = run::<_, 4, 1, 3>(&climbed, &leaning(2.0, 0.7, 0.5), &Plan::until(8.0), &mut ());
    let names = ["wall", "floor", "top"];
    let log: Vec<String> = found.entries.iter().map(|entry| describe(&names, &entry.regime)).collect();
    assert_eq!(
        log,
        [
            "wall slips backwards, floor slips forwards, top apart",
            "wall sticks, floor sticks, top apart",
            "wall slips backwards, floor slips forwards, top apart",
            "wall apart, floor slips forwards, top apart",
        ]
    );
    assert!(matches!(found.ending, Ending::TouchDown { contact: 2, .. }), "{}", found.ending.describe(&names));
    let entry = &found.entries[2];
    let exact = closed::climbed(friction, [20.0 * G, 700.0], 2.0, 0.5, angle(&entry.place).circle());
    close(entry.time, exact, "the time at which it slips");
}

fn rod(friction: f64, theta: f64, slide: f64, spin: f64, end: f64) -> Run<4, 1> {
    let rod = SlenderRod { mass: 1.0, inertia: 1.0 / 3.0, half_length: 1.0, gravity: G, friction };
    let (s, c) = theta.sin_cos();
    let velocity = [slide - spin * s, spin * c, -spin * s, spin * c];
    run::<_, 4, 1, 1>(&rod, &State { time: 0.0, place: [c, s, c, s], velocity }, &Plan::until(end), &mut ())
}

#[test]
fn a_rod_that_jams_stops_with_its_diagnosis() {
    // towards the critical angle with growing reactions: (1 + 3 cos^2) = 6 sin cos at f = 2
    let found = rod(2.0, 0.6, -3.0, 3.0, 1.0);
    let reason = found.ending;
    assert!(matches!(reason, Ending::Critical | Ending::NoMotion), "{reason:?}");
    let theta = angle(&found.state.place);
    assert!((1.0 + 3.0 * theta.cos().powi(2) - 6.0 * theta.sin() * theta.cos()).abs() < 1e-9);
    // where it starts beyond, there is no motion, or there are two
    assert_eq!(rod(2.0, 1.2, -3.0, 0.0, 1.0).ending, Ending::NoMotion);
    assert!(matches!(rod(2.0, 1.2, -3.0, 9.0, 1.0).ending, Ending::Several(..)));
}

#[test]
fn a_rod_falls_from_stick_into_slip_when_friction_is_spent() {
    let found = rod(0.5, 1.0, 0.0, 0.0, 0.7);
    assert_eq!(found.entries[0].regime, [Mode::Stick(Face::Front)]);
    let entry = &found.entries[1];
    assert!(matches!(entry.cause, Cause::Signal { watched: Watched::Condition(0, _), .. }));
    assert!(matches!(entry.regime, [Mode::Slip(..)]));
    // about the fixed end: 4/3 theta'' = -g cos theta, so theta'^2 = 3/2 g (sin theta_0 - sin theta)
    let theta = angle(&entry.place);
    close(spin(&entry.place, &entry.velocity).powi(2), 1.5 * G * (1.0_f64.sin() - theta.sin()), "rotation squared");
    // T / N of the pendulum reaches f
    let turning = -0.75 * G * theta.cos();
    let squared = 1.5 * G * (1.0_f64.sin() - theta.sin());
    let tangential = -theta.sin() * turning - theta.cos() * squared;
    let normal = theta.cos() * turning - theta.sin() * squared + G;
    assert!((tangential.abs() - 0.5 * normal).abs() < 1e-11 * G);
}

#[test]
fn a_state_through_the_floor_is_refused() {
    let rod = SlenderRod { mass: 1.0, inertia: 1.0 / 3.0, half_length: 1.0, gravity: G, friction: 0.5 };
    let below = State { time: 0.0, place: [0.0, 0.5, 0.0, 1.0], velocity: [0.0; 4] };
    let found = run::<_, 4, 1, 1>(&rod, &below, &Plan::until(1.0), &mut ());
    assert_eq!(found.ending, Ending::Unfit(Unfit::Penetrates { contact: 0 }));
}
