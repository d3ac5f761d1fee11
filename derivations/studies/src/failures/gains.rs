//! Constraint stabilisation with gains outside the stability region of the explicit Euler method.

use super::bounds::first_positive;
use super::edge::edge;
use super::entry::data;
use super::trials::Tried;
use super::{Exact, Failing, Found, NotFound, Threshold, Within};
use crate::knowledge::crank_drive;
use crate::stabilisation::schemes::{Scheme, inside_unit_circle};
use field::Rational;
use integrators::Method;
use simulation::models::{Modelled, open};
use simulation::{Axes, Choice};
use std::path::Path;
use symbolic::Sym;

pub const FAILING: Failing = Failing {
    name: "gains",
    title: "explicit Euler with gains outside its stability region",
    scene: "drive/euler_overdamped.toml",
    why: r"A violation with $\ddot f=-b\dot f-kf$ is multiplied in a step of Euler by a matrix of $\beta=hb$, $\kappa=h^2k$, whose eigenvalues are inside the unit circle if and only if $0<\kappa<\beta<2+\kappa/2$. Stronger damping than that makes the violation grow, because the step is too long for the damping itself.",
    advice: "Take h b = 2, h^2 k = 1 for Euler, any positive gains for backward Euler or the midpoint rule, or no gains at all: coordinates that keep the constraint.",
    asked: "the rod's constraint within a tenth of its length squared",
    measure,
};

/// The number of steps in which growth of a violation is detected.
const STEPS: u32 = 3_000;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = open(path)?;
    let accepted = "known_as = \"crank_drive\" with a constant step of Euler";
    let method = scene.run().method;
    let euler = Scheme::of(method, scene.run().span).filter(|(scheme, _)| *scheme == Scheme::Euler);
    let (Some(crank_drive::NAME), Some((scheme, step))) = (scene.known_as(), euler) else {
        let found = format!("{} by {method}", scene.known_as().unwrap_or("a system that is not known"));
        return Err(NotFound::unsuitable(path, found, accepted));
    };
    let [stiffness] = data(&*scene, path, ["stiffness"], accepted)?;
    let (b, h) = (Sym::symbol("b"), Sym::constant(Rational::decimal(step)));
    let stiffness = Sym::constant(Rational::decimal(stiffness));
    let conditions = scheme.transition(h * b, h * h * stiffness).map(inside_unit_circle);
    let [above, _, below] = conditions.unwrap_or([Sym::UNDEFINED; 3]);
    let keeps = |damping: f64| kept(&*scene, damping, step);
    let one = |of: &'static str, formula: &'static str, condition, inwards: f64, parts| {
        let exact = Exact::root(first_positive(condition, b))?;
        let near = exact.value();
        let measured = edge(near * (1.0 + inwards), near * (1.0 - inwards), 1e-3, keeps);
        Some(Threshold {
            of: of.into(),
            formula: formula.into(),
            exact,
            unit: "1/s".into(),
            measured,
            within: Within::Share(parts),
        })
    };
    let thresholds = [
        one("largest stable damping of Euler", r"$2/h+hk/2$", below, -0.3, 50),
        one("least damping that Euler needs", r"$hk$", above, 0.5, 20),
    ];
    let problem = scene.problem(Axes::First);
    let tried = Tried { steps: method.steps().unwrap_or(1), outputs: 100, ..Tried::of(&problem, 1e-6) };
    let trials = tried.all(|_| true);
    let choice = scene.run().choice();
    let trajectory = problem.simulate(&choice, |_| ());
    let diagnosis = scene.told(&choice, &trajectory).diagnosis.unwrap_or_default();
    Ok(Found { thresholds: thresholds.into_iter().flatten().collect(), diagnosis, trials })
}

/// Whether a run of Euler's method satisfies the constraint with a damping gain, 1/s.
fn kept(scene: &dyn Modelled, damping: f64, step: f64) -> bool {
    let Ok(scene) = scene.with_values(&[("damping", damping)]) else { return false };
    let mut problem = scene.problem(Axes::First);
    problem.span = step * f64::from(STEPS);
    let euler = Choice { method: Method::Euler { steps: STEPS }, samples: 1, ..scene.run().choice() };
    let trajectory = problem.simulate(&euler, |_| ());
    trajectory.outcome.reached() && trajectory.left.is_none()
}
