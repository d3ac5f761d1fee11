//! Drift of energies and momenta with constant steps, compared with closed forms and computed in two ways.

use dalembert_scenes::{ModelScene, SceneWithIntegrals};
use integrators::Method;
use simulation::integral_drift::{
    Drift, Expected, Measured, MotionWithIntegrals, Returns, Window, expected, measured, return_time,
};
use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

const OSCILLATOR: &str = r#"
title = "An oscillator"
[parameters]
m = "2 kg"
k = "8 N/m"
[coordinates]
x = "m"
[bodies.ball]
centre = "O + x*N.x"
mass = "m"
[[force]]
on = "ball"
is = "-k*x*N.x"
[start]
x = "0.3 m"
[run]
span = "10 s"
"#;

const PENDULUM: &str = r#"
title = "A pendulum"
gravity = "-g*N.y"
[parameters]
m = "2 kg"
g = "9.81 m/s^2"
l = "0.5 m"
[coordinates]
a = "rad"
[frames]
A = "N turned a about z"
[bodies.ball]
centre = "O - l*A.y"
mass = "m"
[start]
a = "60 deg"
[run]
span = "10 s"
"#;

const SPHERICAL: &str = r#"
title = "A spherical pendulum"
gravity = "-g*N.z"
[parameters]
m = "2 kg"
g = "9.81 m/s^2"
l = "0.5 m"
[coordinates]
h = "rad"
a = "rad"
[frames]
H = "N turned h about z"
A = "H turned a about y"
[bodies.ball]
centre = "O - l*A.z"
mass = "m"
[start]
a = "60 deg"
"h'" = "4 rad/s"
[run]
span = "10 s"
"#;

/// A periodic motion with its period and the sizes of its integrals.
struct Periodic {
    kept: SceneWithIntegrals,
    window: Window,
    sizes: Vec<f64>,
}

impl Periodic {
    fn of(text: &str) -> Self {
        let scene = ModelScene::parse("scene.toml", text).unwrap_or_else(|error| panic!("{error}"));
        let kept = SceneWithIntegrals::of(&scene).expect("one law");
        let motion = motion(&kept);
        let gap = |component: usize, end: f64, start: f64| kept.gap(component, end, start);
        let Ok(Returns::After(period)) = return_time(&motion, 10.0, &gap) else { panic!("it returns") };
        let window = Window::Period(period);
        let sizes = motion.sizes(window).expect("it runs");
        Periodic { kept, window, sizes }
    }

    fn names(&self) -> Vec<&str> {
        self.kept.integrals.iter().map(|integral| integral.name.as_str()).collect()
    }

    fn expected(&self, method: Method) -> Vec<Expected> {
        let found = expected(&motion(&self.kept), method, self.window, &self.sizes, &|| ControlFlow::Continue(()));
        found.expect("it runs").expect("nobody ends it")
    }

    fn drift(&self, method: Method, place: usize) -> f64 {
        match self.expected(method)[place].drift {
            Drift::Of(drift) => drift / self.sizes[place],
            other => panic!("{other:?}"),
        }
    }

    fn measured(&self, method: Method, periods: u32, place: usize) -> Measured {
        let goes_on = || ControlFlow::Continue(());
        let found = measured(&motion(&self.kept), method, (self.window, periods), &self.sizes, &goes_on);
        found.expect("it runs")[place].expect("it has periods")
    }
}

fn motion(kept: &SceneWithIntegrals) -> MotionWithIntegrals<'_> {
    MotionWithIntegrals { law: &*kept.problem.law, start: &kept.problem.state, integrals: &kept.integrals }
}

#[test]
fn an_oscillator_loses_the_energy_of_the_stability_function() {
    let oscillator = Periodic::of(OSCILLATOR);
    assert_eq!(oscillator.names(), ["energy"]);
    assert!((oscillator.window.length() - PI).abs() < 1e-9);
    // kinetic energy, and potential energy relative to the start; each is as large as k x^2/2
    let energy = 0.36;
    assert!((oscillator.sizes[0] - 2.0 * energy).abs() < 1e-2, "{:?}", oscillator.sizes);
    let z = TAU / 40.0;
    let each = -z.powi(6) / 72.0 + z.powi(8) / 576.0;
    let method = Method::RungeKutta4 { steps: 40 };
    let change = oscillator.drift(method, 0) * oscillator.sizes[0];
    assert!((change / (40.0 * each * energy) - 1.0).abs() < 1e-6, "{change}");
}

#[test]
fn runs_of_many_periods_drift_as_single_steps_say() {
    for (text, place) in [(OSCILLATOR, 0), (PENDULUM, 0), (SPHERICAL, 0), (SPHERICAL, 1)] {
        let scene = Periodic::of(text);
        let method = Method::RungeKutta4 { steps: 100 };
        let drift = scene.drift(method, place);
        let change = scene.measured(method, 200, place).change.expect("it stays");
        assert_eq!(change.windows, 199);
        let run = change.drift / scene.sizes[place];
        assert!((run / drift - 1.0).abs() < 1e-2, "{text}: {drift:e} by steps, {run:e} by the run");
    }
}

#[test]
fn a_symmetric_method_lets_the_energy_swing_and_not_drift() {
    let pendulum = Periodic::of(PENDULUM);
    let method = Method::ImplicitMidpoint { steps: 50 };
    let found = pendulum.expected(method)[0];
    assert_eq!(found.drift, Drift::None);
    let run = pendulum.measured(method, 500, 0);
    let change = run.change.expect("it stays").drift;
    assert!(change.abs() < 1e-6 * found.swing, "{change:e}");
    assert!((run.swing / found.swing - 1.0).abs() < 0.05, "{} beside {}", run.swing, found.swing);
}

/// Euler's step changes H by h^2/2 f^T H'' f to leading order. Over a period the integral of V'' q'^2 equals that of M q''^2, so that the drift
/// follows from the integral of the squared acceleration.
#[test]
fn eulers_drift_is_that_of_its_elementary_differential() {
    let pendulum = Periodic::of(PENDULUM);
    let (inertia, g, l) = (2.0 * 0.25, 9.81, 0.5);
    // Simpson's rule over a quarter period in the variable s with sin(a/2) = sin(a0/2) sin s: dt = ds / sqrt(g/l (1 - k^2 sin^2 s))
    let k = (PI / 6.0).sin();
    let points = 2000;
    let of = |s: f64| {
        let half = k * s.sin();
        let acceleration = -(g / l) * 2.0 * half * (1.0 - half * half).sqrt();
        let time = 1.0 / ((g / l) * (1.0 - half * half)).sqrt();
        [time, inertia * acceleration * acceleration * time]
    };
    let [mut period, mut integral] = [0.0; 2];
    for i in 0..=points {
        let weight = if i == 0 || i == points { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
        let [time, square] = of(PI / 2.0 * f64::from(i) / f64::from(points));
        period += weight * time;
        integral += weight * square;
    }
    let step = 4.0 * PI / 2.0 / f64::from(points) / 3.0;
    let (period, integral) = (step * period, step * integral);
    assert!((pendulum.window.length() / period - 1.0).abs() < 1e-9, "{:?}, {period}", pendulum.window);
    let steps = 20_000;
    let leading = period / f64::from(steps) * integral;
    let drift = pendulum.drift(Method::Euler { steps }, 0) * pendulum.sizes[0];
    assert!((drift / leading - 1.0).abs() < 1e-3, "{drift}, {leading}");
}

#[test]
fn momenta_of_cyclic_coordinates_are_integrals_too() {
    let scene = Periodic::of(SPHERICAL);
    assert_eq!(scene.names(), ["energy", "momentum of h"]);
    // m l^2 sin^2 a h'
    assert!((scene.sizes[1] - 2.0 * 0.25 * 0.75 * 4.0).abs() < 1e-6, "{:?}", scene.sizes);
}
