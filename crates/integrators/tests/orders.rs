//! Every method converges as its theory says, on nonlinear problems.

mod problems;

use field::DoubleDouble;
use integrators::{Method, Span, Tolerance, integrate, integrate_in};
use problems::{Kepler, distance};

const ECCENTRIC: Kepler = Kepler { eccentricity: 0.3 };

/// The error at t = 5 of a run over Kepler's ellipse.
fn error(method: Method, tolerance: f64) -> f64 {
    let span = Span::new(0.0, 5.0, &ECCENTRIC.state::<f64>(0.0));
    let outcome = integrate(&ECCENTRIC, method, &Tolerance::both(tolerance), &span, &mut ());
    assert!(outcome.reached(), "{method} at {tolerance:e}: {:?}", outcome.failure());
    distance(&outcome.state, &ECCENTRIC.state::<f64>(5.0))
}

/// log2 of the ratio of the errors with n and 2n steps.
fn measured_order(method: impl Fn(u32) -> Method, steps: u32) -> f64 {
    (error(method(steps), 1e-6) / error(method(2 * steps), 1e-6)).log2()
}

#[test]
fn euler_converges_with_order_1() {
    let order = measured_order(|steps| Method::Euler { steps }, 20_000);
    assert!((order - 1.0).abs() < 0.1, "{order}");
}

#[test]
fn runge_kutta_4_converges_with_order_4() {
    let order = measured_order(|steps| Method::RungeKutta4 { steps }, 400);
    assert!((order - 4.0).abs() < 0.15, "{order}");
}

/// The error of an adaptive method is proportional to its tolerance: within this band for each decade of ten.
fn assert_follows_tolerance(method: Method, tolerances: [f64; 3], band: f64) {
    for tolerance in tolerances {
        let error = error(method, tolerance);
        let ratio = error / tolerance;
        println!("{method} {tolerance:e}: {error:.2e}");
        assert!(ratio < band && ratio > 1e-3 / band, "{method}: error {error:.2e} at tolerance {tolerance:e}");
    }
}

#[test]
fn dormand_prince_5_follows_its_tolerance() {
    assert_follows_tolerance(Method::DormandPrince5, [1e-4, 1e-7, 1e-10], 100.0);
}

#[test]
fn dormand_prince_8_follows_its_tolerance() {
    assert_follows_tolerance(Method::DormandPrince8, [1e-4, 1e-7, 1e-10], 100.0);
}

#[test]
fn gragg_bulirsch_stoer_follows_its_tolerance() {
    assert_follows_tolerance(Method::GraggBulirschStoer, [1e-4, 1e-7, 1e-10], 100.0);
}

#[test]
fn gragg_bulirsch_stoer_gives_26_digits_in_double_double() {
    let span = Span::new(0.0, 5.0, &ECCENTRIC.state::<DoubleDouble>(0.0));
    let outcome = integrate_in(&ECCENTRIC, Method::GraggBulirschStoer, &Tolerance::both(1e-29), &span, &mut ());
    assert!(outcome.reached());
    let error = distance(&outcome.state, &ECCENTRIC.state::<DoubleDouble>(5.0));
    println!("{error:.1e} {}", outcome.work);
    assert!(error < 1e-26, "{error:.1e}");
}
