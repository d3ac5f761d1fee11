//! Drift of the length of the vertical vector over long runs.

use super::bounds::swinging;
use super::edge::edge;
use super::trials::Tried;
use super::{Exact, Failing, Found, NotFound, Threshold, Within};
use crate::scene::Scene;
use crate::stabilisation::schemes::Scheme;
use field::Rational;
use integrators::{Method, Span, Tolerance, integrate};
use num_traits::Zero;
use reader::Family;
use simulation::{Axes, Problem};
use std::path::Path;

pub const FAILING: Failing = Failing {
    name: "vertical",
    title: "drift of the vertical's length over long times",
    scene: "failures/turning_frame.toml",
    why: r"In a body with constant angular velocity $\dot\nu=\nu\times\omega$ has the eigenvalues $\pm i|\omega|$. A step multiplies $|\nu|^2$ by the determinant of the method's map: $1+\kappa$ for Euler, $1-\kappa^3(8-\kappa)/576$ for Runge and Kutta with $\kappa=h^2\omega^2$, exactly 1 for the midpoint rule, Gauss' methods and rotations. A factor other than 1 changes the length in every step.",
    advice: "For long runs use a splitting method, which turns the vertical by exact rotations, or Gauss' methods; otherwise a tolerance that is small enough for the whole run.",
    asked: "the square of the length within 1/10000",
    measure,
};

/// The number of steps in which growth of the length is detected.
const STEPS: u32 = 400;
/// The number of steps of methods with a constant step size.
const CONSTANT: u32 = 4_000;
/// The largest allowed error of the squared length.
const KEPT: f64 = 1e-4;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = Scene::open(path)?;
    let w = scene.start.angular_velocity.map(Rational::decimal);
    let square = w.dot(&w);
    let across = w.dot(&scene.start.vertical.map(Rational::decimal));
    if square.is_zero() || !across.is_zero() {
        let accepted = "an angular velocity across the vertical";
        return Err(NotFound::unsuitable(path, "the vertical does not turn in its plane", accepted));
    }
    let problem = scene.problem(Axes::First);
    let step = Exact::root(swinging(Scheme::RungeKutta4, square)).map(|exact| {
        let near = exact.value();
        let measured = edge(0.8 * near, 1.2 * near, 1e-10, |h| after(&problem, h, STEPS).is_some_and(|it| it < 1.0));
        let of = "step of Runge-Kutta 4 beyond which the length grows; below, it shrinks";
        Threshold {
            of: of.into(),
            formula: r"$2\sqrt2/|\omega|$".into(),
            exact,
            unit: "s".into(),
            measured,
            within: Within::Share(1_000_000),
        }
    });
    let h = problem.span / f64::from(CONSTANT);
    let lost = Threshold {
        of: "part of the square of the length that Runge-Kutta 4 loses on the scene".into(),
        formula: r"$1-(1-\kappa^3(8-\kappa)/576)^n$".into(),
        exact: lost(square * Rational::decimal(h) * Rational::decimal(h)),
        unit: "".into(),
        measured: after(&problem, h, CONSTANT).map(|left| 1.0 - left),
        within: Within::Share(1_000_000),
    };
    let tried = Tried { steps: CONSTANT, outputs: 10, ..Tried::of(&problem, scene.run.tolerance) };
    let trials = tried.all(|record| record.states.iter().all(|y| (length(y) - 1.0).abs() < KEPT));
    let run = problem
        .simulate(&simulation::Choice { method: Method::RungeKutta4 { steps: CONSTANT }, ..scene.choice() }, |_| ());
    let deviation = run.outcome.deviations.iter().find(|it| it.name == "vertical_length");
    let diagnosis = deviation.map_or_else(String::new, |it| format!("{}, kept to {:.1e}", it.name, it.largest));
    Ok(Found { thresholds: step.into_iter().chain([lost]).collect(), diagnosis, trials })
}

/// The exact fraction of the squared length that the run loses, from the determinant of a step.
fn lost(kappa: Rational) -> Exact {
    let map = Scheme::RungeKutta4.transition(Rational::zero(), kappa);
    let factor = map.map_or(Rational::UNDEFINED, |[[a, b], [c, d]]| a * d - b * c);
    let value = -(f64::from(CONSTANT) * factor.to_f64().ln()).exp_m1();
    Exact::Formula(format!("1 - ({factor})^{CONSTANT}"), value)
}

/// v.v at the state (w, v, ...).
fn length(y: &[f64]) -> f64 {
    y.iter().skip(3).take(3).map(|v| v * v).sum()
}

/// v.v after a number of steps of size h of Runge-Kutta 4.
fn after(problem: &Problem, h: f64, steps: u32) -> Option<f64> {
    let span = Span::new(0.0, h * f64::from(steps), &problem.state);
    let method = Method::RungeKutta4 { steps };
    let outcome = integrate(&*problem.law, method, &Tolerance::both(1e-9), &span, &mut ());
    outcome.reached().then(|| length(&outcome.state))
}
