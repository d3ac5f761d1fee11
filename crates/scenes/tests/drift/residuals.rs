//! Residuals of constraints and of their rates along runs.

use super::{METHODS, kept, parsed, scene};
use dalembert_scenes::ModelScene;
use integrators::{Index2Dae, Index2DaeSystem, Method, Observer, Span, Tolerance, integrate};
use simulation::{Axes, IvpScene};

/// Residuals at steps and outputs, in rounding errors of the largest component of the state.
struct Residuals<'a> {
    law: &'a dyn Index2DaeSystem,
    values: Vec<f64>,
    largest: f64,
}

impl<'a> Residuals<'a> {
    fn of(law: &'a dyn Index2DaeSystem) -> Self {
        let (_, count) = Index2Dae::<f64>::sizes(law);
        Residuals { law, values: vec![0.0; count], largest: 0.0 }
    }
}

impl Observer<f64> for Residuals<'_> {
    fn step(&mut self, time: f64, state: &[f64]) {
        self.law.constraints(time, state, &mut self.values);
        let size = state.iter().fold(1.0, |size: f64, part| size.max(part.abs()));
        let residual = self.values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        self.largest = self.largest.max(residual / size);
    }

    fn sample(&mut self, time: f64, state: &[f64]) {
        self.step(time, state);
    }
}

/// The largest relative residual of a run over `times` spans of a scene.
fn residual(scene: &ModelScene, method: Method, tolerance: f64, times: f64) -> f64 {
    let (problem, law) = (scene.problem(Axes::First), kept(scene));
    let span = Span::new(0.0, times * problem.span, &problem.state).with_even_outputs(50);
    let mut residuals = Residuals::of(&*law);
    let outcome = integrate(&*problem.law, method, &Tolerance::both(tolerance), &span, &mut residuals);
    assert!(outcome.reached(), "{}, {method}: {:?}", scene.title, outcome.end);
    residuals.largest
}

const ROUNDING: f64 = 1e-14;

#[test]
fn a_pendulum_in_cartesian_coordinates_stays_on_its_circle_by_every_method() {
    let scene = scene("foreign/cartesian_pendulum");
    let constant = [Method::RungeKutta4 { steps: 2_000 }, Method::ImplicitMidpoint { steps: 2_000 }];
    for method in METHODS.into_iter().chain(constant) {
        for tolerance in [1e-6, 1e-9] {
            let found = residual(&scene, method, tolerance, 1.0);
            assert!(found < ROUNDING, "{method}, {tolerance:e}: {found:e}");
        }
    }
}

#[test]
fn residuals_stay_at_rounding_over_ten_spans_whatever_the_tolerance() {
    let holonomic = "foreign/cartesian_pendulum";
    let rheonomic = ["foreign/flexible_slider_crank", "foreign/car_axis"];
    let with_closed_loops = ["foreign/andrews_mechanism", "models/slider_crank"];
    let nonholonomic = ["models/chaplygin_sleigh", "models/rolling_disc", "foreign/bicycle"];
    for name in [holonomic].into_iter().chain(rheonomic).chain(with_closed_loops).chain(nonholonomic) {
        let scene = scene(name);
        for method in [Method::Taylor, Method::DormandPrince8] {
            for tolerance in [1e-6, 1e-9] {
                // the bicycle falls over; growing angles have larger rounding errors
                let growing = ["foreign/flexible_slider_crank", "foreign/car_axis", "foreign/andrews_mechanism"];
                let is_short = name == "foreign/bicycle" || growing.contains(&name);
                let times = if is_short { 1.0 } else { 10.0 };
                let found = residual(&scene, method, tolerance, times);
                assert!(found < ROUNDING, "{name}, {method}, {tolerance:e}: {found:e}");
            }
        }
    }
}

/// A body on a free frame, fixed at a point of a carriage without inertia that a damper drags.
const FREE_AND_WITHOUT_INERTIA: &str = "title = \"t\"\ngravity = \"-(9.81 m/s^2)*N.z\"\n\
     [coordinates]\nx = \"m\"\ny = \"m\"\nz = \"m\"\ns = \"m\"\n[frames]\nF = \"N free\"\n\
     [points]\nA = \"O + s*N.x\"\nG = \"O + x*N.x + y*N.y + z*N.z\"\nP = \"G - (0.3 m)*F.x\"\n\
     [bodies.b]\nframe = \"F\"\ncentre = \"G\"\nmass = \"(2 kg)\"\n\
     inertia = { principal = [\"(0.02 kg m^2)\", \"(0.03 kg m^2)\", \"(0.04 kg m^2)\"] }\n\
     [energies]\npotential = \"(5 N/m)/2*s^2\"\ndissipation = \"(20 N s/m)/2*s'^2\"\n\
     [[constraint]]\nzero = \"P - A\"\n[start]\nx = \"0.3 m\"\ns = \"0 m\"\n\"F.wz\" = \"2 rad/s\"\n[run]\nspan = \"1 s\"\n";

#[test]
fn free_frames_and_coordinates_without_inertia_stay_on_constraints() {
    let scene = parsed(FREE_AND_WITHOUT_INERTIA);
    let residual_of = scene.problem(Axes::First).residual.expect("it has constraints");
    let problem = scene.problem(Axes::First);
    for method in [Method::Taylor, Method::DormandPrince8, Method::Radau5] {
        let span = Span::new(0.0, 10.0, &problem.state);
        let outcome = integrate(&*problem.law, method, &Tolerance::both(1e-7), &span, &mut ());
        assert!(outcome.reached(), "{method}: {:?}", outcome.end);
        let left = residual_of(outcome.time, &outcome.state);
        assert!(left < ROUNDING, "{method}: {left:e}");
    }
}

/// A stabilised constraint that is violated at the start decays by its own law and is not projected.
#[test]
fn programmed_constraints_keep_their_own_law() {
    let text = "title = \"t\"\n[coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n\
        [bodies]\nb = { centre = \"P\", mass = \"(1 kg)\" }\n[[constraint]]\nzero = \"x\"\nprogrammed = { gains = [\"(2 1/s)\", \"(1 1/s^2)\"] }\n\
        [[constraint]]\nzero = \"y - (0.5 m)\"\n[start]\nx = \"1 m\"\ny = \"guess 0.5 m\"\n\"x'\" = \"0 m/s\"\n[run]\nspan = \"1 s\"\n";
    let problem = parsed(text).problem(Axes::First);
    let span = Span::new(0.0, 1.0, &problem.state);
    let end = integrate(&*problem.law, Method::Taylor, &Tolerance::both(1e-12), &span, &mut ()).state;
    // x'' + 2 x' + x = 0
    assert!((end[0] - 2.0 * (-1.0_f64).exp()).abs() < 1e-11 && end[1] == 0.5, "{end:?}");
}
