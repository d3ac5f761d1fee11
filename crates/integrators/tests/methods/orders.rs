//! Every method converges with its theoretical order, on nonlinear problems.

use crate::problems::{Drive, Kaps, Kepler, Pendula, ProtheroRobinson, distance};
use dalembert_integrators::{Method, Span, Tolerance, Work, Working, integrate, integrate_in};
use field::DoubleDouble;

const ECCENTRIC: Kepler = Kepler { eccentricity: 0.3 };

/// The error at t = 5 of a run over Kepler's ellipse, and its work.
fn kepler(method: Method, tolerance: f64) -> (f64, Work) {
    let span = Span::new(0.0, 5.0, &ECCENTRIC.state::<f64>(0.0));
    let outcome = integrate(&ECCENTRIC, method, &Tolerance::both(tolerance), &span, &mut ());
    assert!(outcome.reached(), "{method} at {tolerance:e}: {:?}", outcome.failure());
    (distance(&outcome.state, &ECCENTRIC.state::<f64>(5.0)), outcome.work)
}

/// The error and the work of a run in any scalar type, for the methods of this crate.
fn kepler_in<S: Working>(method: Method, tolerance: f64) -> (f64, Work) {
    let span = Span::new(0.0, 5.0, &ECCENTRIC.state::<S>(0.0));
    let outcome = integrate_in(&ECCENTRIC, method, &Tolerance::both(tolerance), &span, &mut ());
    assert!(outcome.reached(), "{method} at {tolerance:e}: {:?}", outcome.failure());
    (distance(&outcome.state, &ECCENTRIC.state::<S>(5.0)), outcome.work)
}

/// The exponent p of error ~ steps^-p between two runs.
fn slope((coarse, few): (f64, Work), (fine, many): (f64, Work)) -> f64 {
    (coarse / fine).ln() / (many.steps as f64 / few.steps as f64).ln()
}

fn assert_order(method: Method, measured: f64, band: f64) {
    let theory = method.traits().order.map_or(f64::NAN, f64::from);
    assert!((measured - theory).abs() < band, "{method}: measured {measured:.2}, theory {theory}");
}

#[test]
fn methods_with_a_constant_step_have_their_order() {
    let euler = |steps| kepler(Method::Euler { steps }, 1e-6);
    assert_order(Method::Euler { steps: 0 }, slope(euler(20_000), euler(40_000)), 0.1);
    let kutta = |steps| kepler(Method::RungeKutta4 { steps }, 1e-6);
    assert_order(Method::RungeKutta4 { steps: 0 }, slope(kutta(400), kutta(800)), 0.15);
    let backward = |steps| kepler(Method::BackwardEuler { steps }, 1e-6);
    assert_order(Method::BackwardEuler { steps: 0 }, slope(backward(20_000), backward(40_000)), 0.1);
    let midpoint = |steps| kepler(Method::ImplicitMidpoint { steps }, 1e-6);
    assert_order(Method::ImplicitMidpoint { steps: 0 }, slope(midpoint(1_000), midpoint(2_000)), 0.1);
}

#[test]
fn runge_kutta_pairs_have_their_order() {
    for (method, coarse, fine) in [
        (Method::DormandPrince5, 1e-8, 1e-12),
        (Method::DormandPrince8, 1e-8, 1e-12),
        (Method::Verner6, 1e-6, 1e-10),
        (Method::Verner9, 1e-8, 1e-12),
        (Method::Radau5, 1e-8, 1e-12),
        (Method::Kvaerno5, 1e-8, 1e-12),
        (Method::Rodas4, 1e-7, 1e-10),
    ] {
        let measured = slope(kepler(method, coarse), kepler(method, fine));
        // the number of steps is an integer: with 13 steps one more or less changes the measured order considerably
        assert_order(method, measured, 1.3);
    }
}

#[test]
fn collocation_has_order_2s_or_one_less() {
    for (method, coarse, fine) in [
        (Method::Gauss { stages: 1 }, 1e-6, 1e-8),
        (Method::Gauss { stages: 2 }, 1e-10, 1e-13),
        (Method::Gauss { stages: 3 }, 1e-14, 1e-18),
        (Method::Gauss { stages: 5 }, 1e-20, 1e-26),
        (Method::RadauIIA { stages: 2 }, 1e-9, 1e-12),
        (Method::RadauIIA { stages: 3 }, 1e-12, 1e-16),
        (Method::RadauIIA { stages: 5 }, 1e-20, 1e-26),
    ] {
        let run = |tolerance| kepler_in::<DoubleDouble>(method, tolerance);
        assert_order(method, slope(run(coarse), run(fine)), 0.35);
    }
}

/// All methods with error control except Taylor's, which needs a series.
const ADAPTIVE: [Method; 12] = [
    Method::Rodas4,
    Method::BaderDeuflhard,
    Method::DormandPrince5,
    Method::DormandPrince8,
    Method::Verner6,
    Method::Verner9,
    Method::Radau5,
    Method::Kvaerno5,
    Method::GraggBulirschStoer,
    Method::Gauss { stages: 3 },
    Method::Gauss { stages: 6 },
    Method::RadauIIA { stages: 4 },
];

#[test]
fn the_error_of_an_adaptive_method_is_proportional_to_its_tolerance() {
    for method in ADAPTIVE {
        for tolerance in [1e-4, 1e-7, 1e-10] {
            let ratio = kepler(method, tolerance).0 / tolerance;
            assert!(ratio > 0.01 && ratio < 300.0, "{method} at {tolerance:e}: error {ratio:.5} tolerances");
        }
    }
}

/// Kepler's ellipse is symmetric: backwards from the pericentre every method takes the same steps.
#[test]
fn a_run_backwards_costs_what_its_mirror_image_costs() {
    for method in ADAPTIVE {
        let run = |end: f64| {
            let span = Span::new(0.0, end, &ECCENTRIC.state::<f64>(0.0));
            integrate(&ECCENTRIC, method, &Tolerance::both(1e-8), &span, &mut ()).work
        };
        assert_eq!(run(5.0), run(-5.0), "{method}");
    }
}

/// A law that depends on time only: if a node in its tableau is wrong, a method has order 1.
#[test]
fn a_law_that_depends_on_time_is_followed_as_well() {
    for method in ADAPTIVE {
        for tolerance in [1e-5, 1e-9] {
            let span = Span::new(0.0, 5.0, &[0.5]);
            let outcome = integrate(&Drive, method, &Tolerance::both(tolerance), &span, &mut ());
            let error = (outcome.state[0] - Drive::state(5.0)).abs();
            assert!(outcome.reached() && error < 100.0 * tolerance, "{method} at {tolerance:e}: {error:.1e}");
        }
    }
}

/// States have 2 to 160 components; the methods store short ones in arrays on the stack.
#[test]
fn a_state_of_any_length_is_followed_as_a_short_one_is() {
    for method in ADAPTIVE {
        let end = |pendula: usize| {
            let start = [vec![0.7; pendula], vec![0.0; pendula]].concat();
            let span = Span::new(0.0, 3.0, &start);
            let outcome = integrate(&Pendula(pendula), method, &Tolerance::both(1e-7), &span, &mut ());
            assert!(outcome.reached(), "{method}: {:?}", outcome.failure());
            outcome.state
        };
        let alone = end(1);
        for pendula in [2, 3, 4, 5, 17, 40, 80] {
            let all = end(pendula);
            for (angle, speed) in all[..pendula].iter().zip(&all[pendula..]) {
                assert!((angle - alone[0]).abs() + (speed - alone[1]).abs() < 1e-5, "{method}, {pendula} pendula");
            }
        }
    }
}

#[test]
fn implicit_methods_follow_a_stiff_problem_with_few_steps() {
    let exact: Vec<f64> = Kaps::state(5.0).iter().map(|y| y.hi()).collect();
    for method in ADAPTIVE.into_iter().filter(|method| method.traits().implicit) {
        let span = Span::new(0.0, 5.0, &[1.0, 1.0]).with_evaluations(20_000);
        let outcome = integrate(&Kaps { lambda: 1e5 }, method, &Tolerance::both(1e-7), &span, &mut ());
        let error = distance(&outcome.state, &exact);
        assert!(outcome.reached() && outcome.work.steps < 1000, "{method}: {:?} {}", outcome.failure(), outcome.work);
        // the solution has decreased to e^-5, and the tolerance is absolute
        assert!(error < 5e-4, "{method}: {error:.1e}");
    }
}

/// Where only the stage order counts, the smooth solution is still computed in few steps.
#[test]
fn implicit_methods_follow_prothero_and_robinson_at_any_stiffness() {
    for method in ADAPTIVE.into_iter().filter(|method| method.traits().implicit) {
        for rate in [1e2, 1e4, 1e6, 1e9] {
            let span = Span::new(0.0, 5.0, &[1.0]).with_evaluations(100_000);
            let outcome = integrate(&ProtheroRobinson { rate }, method, &Tolerance::both(1e-8), &span, &mut ());
            let error = (outcome.state[0] - 5.0_f64.cos()).abs();
            assert!(outcome.reached(), "{method} at {rate:e}: {:?} {}", outcome.failure(), outcome.work);
            assert!(error < 1e-6, "{method} at {rate:e}: {error:.1e} with {}", outcome.work);
        }
    }
}

/// Without df/dt the first substep excites the fast decay: this took 2,735 steps at a rate of 1e4 with the second
/// tolerance.
#[test]
fn extrapolation_takes_few_steps_where_a_stiff_law_is_driven_by_time() {
    for (rate, tolerance) in [1e2, 1e4, 1e6, 1e9].into_iter().flat_map(|rate| [(rate, 1e-8), (rate, 1e-12)]) {
        let span = Span::new(0.0, 5.0, &[1.0]);
        let tolerances = Tolerance::both(tolerance);
        let outcome = integrate(&ProtheroRobinson { rate }, Method::BaderDeuflhard, &tolerances, &span, &mut ());
        assert!(outcome.reached() && outcome.work.steps < 100, "at {rate:e}, {tolerance:e}: {}", outcome.work);
    }
}

#[test]
fn own_methods_give_26_digits_in_double_double() {
    for method in [Method::GraggBulirschStoer, Method::Gauss { stages: 12 }, Method::RadauIIA { stages: 12 }] {
        let (error, work) = kepler_in::<DoubleDouble>(method, 1e-29);
        assert!(error < 1e-26, "{method}: {error:.1e} with {work}");
    }
}

/// Twelve digits of a solution that adapts to its forcing instantaneously: errors that extrapolation did not remove
/// would cost hundreds of steps.
#[test]
fn bader_deuflhard_extrapolates_what_is_stiff_to_twelve_digits() {
    let law = Kaps { lambda: 1e5 };
    let start: Vec<f64> = Kaps::state(0.0).iter().map(|y| y.hi()).collect();
    let span = Span::new(0.0, 2.0, &start);
    let outcome = integrate(&law, Method::BaderDeuflhard, &Tolerance::both(1e-13), &span, &mut ());
    let exact: Vec<f64> = Kaps::state(2.0).iter().map(|y| y.hi()).collect();
    let error = distance(&outcome.state, &exact);
    assert!(outcome.reached() && error < 1e-12, "{error:e}");
    assert!(outcome.work.rates < 900, "{:?}", outcome.work);
}
