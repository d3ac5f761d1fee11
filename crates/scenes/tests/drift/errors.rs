//! Errors and energies of runs with projection onto the constraints, compared with runs without projection.

use super::{path, plain, scene};
use integrators::{Method, Observer, Span, System, Tolerance, integrate};
use simulation::{Axes, IvpScene, Stored};

/// The largest error at the times of a reference, relative to each component or to one.
struct Errors<'a> {
    exact: std::slice::Iter<'a, Vec<f64>>,
    largest: f64,
}

impl Observer<f64> for Errors<'_> {
    fn sample(&mut self, _time: f64, state: &[f64]) {
        let Some(exact) = self.exact.next() else { return };
        let errors = state.iter().zip(exact).map(|(found, exact)| (found - exact).abs() / exact.abs().max(1.0));
        self.largest = errors.fold(self.largest, f64::max);
    }
}

const SCENES: [&str; 8] = [
    "foreign/cartesian_pendulum",
    "foreign/car_axis",
    "foreign/andrews_mechanism",
    "foreign/bicycle",
    "models/slider_crank",
    "models/rolling_disc",
    "models/chaplygin_sleigh",
    "bodies/crank_slider",
];

/// Compares means of logarithms over methods and tolerances, since single errors may be small by chance.
#[test]
fn errors_beside_references_do_not_grow() {
    let mut all = 0.0;
    for name in SCENES {
        let scene = scene(name);
        let (problem, plain) = (scene.problem(Axes::First), plain(&scene));
        let reference = Stored::beside(&path(name)).expect("it is kept").reference;
        let exact: Vec<Vec<f64>> =
            reference.states.iter().map(|state| state.iter().map(|part| part.hi()).collect()).collect();
        let mut span = Span::new(0.0, problem.span, &problem.state);
        span.outputs.clone_from(&reference.times);
        let error = |law: &dyn System, method: Method, tolerance: f64| {
            let mut errors = Errors { exact: exact.iter(), largest: 0.0 };
            let outcome = integrate(law, method, &Tolerance::both(tolerance), &span, &mut errors);
            assert!(outcome.reached(), "{name}, {method}: {:?}", outcome.end);
            errors.largest
        };
        let (mut sum, mut count) = (0.0, 0.0);
        for method in [Method::Taylor, Method::DormandPrince8, Method::Verner9, Method::RadauIIA { stages: 3 }] {
            for tolerance in [1e-6, 1e-7, 1e-8, 1e-9, 1e-10] {
                let [own, other] = [&*problem.law as &dyn System, &*plain].map(|law| error(law, method, tolerance));
                (sum, count) = (sum + (own / other).ln(), count + 1.0);
            }
        }
        let mean = sum / count;
        assert!(mean.exp() < 1.3, "{name}: errors are {} times as large", mean.exp());
        all += mean / SCENES.len() as f64;
    }
    assert!(all.exp() < 0.9, "{}", all.exp());
}

#[test]
fn the_energy_of_a_conservative_system_drifts_less() {
    for name in ["foreign/cartesian_pendulum", "foreign/five_links", "models/rolling_disc"] {
        let scene = scene(name);
        let (problem, plain) = (scene.problem(Axes::First), plain(&scene));
        let energy = &problem.invariants.first().expect("it is kept").value;
        let span = Span::new(0.0, problem.span, &problem.state).with_monitor("energy", energy);
        let moved = |law: &dyn System, method: Method, tolerance: f64| {
            let outcome = integrate(law, method, &Tolerance::both(tolerance), &span, &mut ());
            outcome.deviations[0].largest
        };
        let (mut sum, mut count) = (0.0, 0.0);
        for method in [Method::Taylor, Method::DormandPrince8, Method::RadauIIA { stages: 3 }] {
            for tolerance in [1e-6, 1e-7, 1e-8, 1e-9] {
                let [own, other] = [&*problem.law as &dyn System, &*plain].map(|law| moved(law, method, tolerance));
                assert!(tolerance != 1e-8 || own < 1.1 * other, "{name}, {method}: {own:e} beside {other:e}");
                (sum, count) = (sum + (own / other).ln(), count + 1.0);
            }
        }
        let mean: f64 = sum / count;
        assert!(mean.exp() < 1.0, "{name}: the energy drifts {} times as far", mean.exp());
    }
}
