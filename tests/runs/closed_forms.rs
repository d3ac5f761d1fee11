//! The claimed error of a reference bounds its true error, for all solutions that are known in closed form.

use dalembert_derivations::studies::closed_forms::{ClosedForm, Lattice, Quadrature};
use dalembert_derivations::studies::scene::Scene;
use field::{Analytic, DoubleDouble, Over, Scalar};
use reader::Family;
use simulation::{Axes, IvpScene};
use std::path::Path;
use std::time::Duration;

type Exact = DoubleDouble;

fn scene(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/closed_forms").join(name).with_extension("toml");
    Scene::open(&path).unwrap_or_else(|error| panic!("{error}"))
}

fn close(a: Exact, b: Exact, digits: f64) {
    let off = (a - b).hi().abs() / (1.0 + b.hi().abs());
    assert!(off < 10f64.powf(-digits), "{a:?} and {b:?} are {off:.1e} apart");
}

#[test]
fn the_true_error_of_a_reference_is_below_the_one_it_claims() {
    for name in ["volterra", "lagrange_top", "unloaded_motor"] {
        let scene = scene(name);
        let known: ClosedForm<Exact> = scene.closed_form().unwrap_or_else(|| panic!("{name} has no closed form"));
        let reference = scene.problem(Axes::First).reference(Duration::from_secs(600));
        let reference = reference.unwrap_or_else(|failure| panic!("{name}: {failure}"));
        assert!(reference.digits > 25.0, "{name}: {}", reference.digits);
        let claimed = 10f64.powf(-reference.digits);
        for (time, state) in reference.times.iter().zip(&reference.states) {
            let off = (known.shown(state) - known.at(Exact::lift(*time))).hi().abs();
            assert!(off < claimed, "{name} at {time}: {off:.1e}, {claimed:.1e} claimed");
        }
    }
}

#[test]
fn a_permanent_rotation_without_rounding_stays_to_the_last_bit() {
    let scene = scene("upright_rotation");
    let problem = scene.problem(Axes::First);
    let reference = problem.reference(Duration::from_secs(600)).unwrap_or_else(|failure| panic!("{failure}"));
    for state in &reference.states {
        let start: Vec<Exact> = problem.state.iter().map(|y| Exact::lift(*y)).collect();
        assert_eq!(*state, start);
    }
}

#[test]
fn a_run_tells_how_far_it_is_off_a_closed_form() {
    for name in ["volterra", "lagrange_top", "unloaded_motor"] {
        let scene = scene(name);
        let told = |tolerance| {
            let choice = simulation::Choice { tolerance, samples: 4, ..scene.choice() };
            let (_, off) = scene.told(&choice, &scene.simulate(&choice, |_| ())).closed_form.expect("it is known");
            off
        };
        let (coarse, fine) = (told(1e-4), told(1e-12));
        assert!(fine < 1e-10 && coarse > 1e3 * fine && coarse < 1e-2, "{name}: {coarse:.1e}, {fine:.1e}");
    }
}

#[test]
fn the_square_of_weierstrass_slope_is_his_cubic() {
    for [g2, g3] in [[(7, 3), (2, 5)], [(7, 3), (-2, 5)], [(-1, 2), (3, 1)], [(0, 1), (1, 1)], [(12, 1), (0, 1)]] {
        let [g2, g3] = [g2, g3].map(|(n, d)| Exact::ratio(n, d));
        let lattice = Lattice::new(g2, g3);
        for n in 1..40 {
            let found = lattice.at(Exact::ratio(n, 7)).expect("no period");
            let p = found.value;
            let cubic = Exact::int(4) * p * p * p - g2 * p - g3;
            let size = 1.0 + found.slope.hi() * found.slope.hi();
            let off = ((found.slope * found.slope - cubic).hi() / size).abs();
            assert!(off < 1e-28, "{g2:?} {g3:?} {n}: {off:.1e}");
            let later = lattice.at(Exact::ratio(n, 7) + lattice.period).expect("no period");
            assert!(((later.value - p).hi() / (1.0 + p.hi().abs())).abs() < 1e-26, "{n}");
        }
    }
}

#[test]
fn circular_and_hyperbolic_motions_are_cases() {
    let f = |coefficients: [i64; 5]| coefficients.map(Exact::int);
    let (circle, cosh) = (
        Quadrature::new(f([1, 0, -1, 0, 0]), Exact::int(0), Exact::int(1)),
        Quadrature::new(f([-1, 0, 1, 0, 0]), Exact::int(1), Exact::int(0)),
    );
    for n in 1..60 {
        let t = Exact::ratio(n, 10);
        close(circle.at(t), t.circle().sin, 29.0);
        let e = num_traits::Float::exp(t);
        close(cosh.at(t), (e + Exact::int(1) / e).half(), 27.0);
    }
}

#[test]
fn motions_from_two_points_of_one_curve_are_one() {
    // u'^2 = (1 - u^2)(1 - u^2/4)
    let f = [(1, 1), (0, 1), (-5, 4), (0, 1), (1, 4)].map(|(n, d)| Exact::ratio(n, d));
    let slope = |u: Exact| Analytic::sqrt((Exact::int(1) - u * u) * (Exact::int(1) - u * u * Exact::ratio(1, 4)));
    let first = Quadrature::new(f, Exact::int(0), Exact::int(1));
    let u = first.at(Exact::ratio(3, 10));
    let second = Quadrature::new(f, u, slope(u));
    close(second.at(Exact::ratio(4, 10)), first.at(Exact::ratio(7, 10)), 29.0);
}

/// The solution of u'' = f'(u)/2 by many small steps of the classical Runge-Kutta method.
fn stepped(f: [f64; 5], [mut u, mut v]: [f64; 2], time: f64) -> f64 {
    let (steps, slope) = (4000, |u: f64| (1..5).rev().fold(0.0, |sum, k| sum * u + k as f64 * f[k]) / 2.0);
    let h = time / f64::from(steps);
    for _ in 0..steps {
        let (k1, l1) = (v, slope(u));
        let (k2, l2) = (v + 0.5 * h * l1, slope(u + 0.5 * h * k1));
        let (k3, l3) = (v + 0.5 * h * l2, slope(u + 0.5 * h * k2));
        let (k4, l4) = (v + h * l3, slope(u + h * k3));
        (u, v) = (u + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4), v + h / 6.0 * (l1 + 2.0 * (l2 + l3) + l4));
    }
    u
}

#[test]
fn a_quartic_without_symmetry_has_the_solution_that_small_steps_find() {
    let f = [2.0, 0.7, -1.3, 0.4, -0.6];
    for (u, sign) in [(0.2, 1.0), (0.5, -1.0), (-0.4, 1.0)] {
        let speed = sign * f64::sqrt(f.iter().rev().fold(0.0, |sum, c| sum * u + c));
        let solution = Quadrature::new(f, u, speed);
        for time in [0.1, 0.7, 1.9] {
            let off = solution.at(time) - stepped(f, [u, speed], time);
            assert!(off.abs() < 1e-10, "{u} {sign} {time}: {off:e}");
        }
    }
}

#[test]
fn half_a_period_leads_from_one_turning_point_to_the_other() {
    // (1 - u^2)(2 + u^2) and (1 - u^2)(4 - u^2): two real roots, and four
    for f in [[2.0, 0.0, -1.0, 0.0, -1.0], [4.0, 0.0, -5.0, 0.0, 1.0]] {
        let solution = Quadrature::new(f, 1.0, 0.0);
        assert!((solution.at(0.5 * solution.period()) + 1.0).abs() < 1e-12, "{f:?}");
    }
}
