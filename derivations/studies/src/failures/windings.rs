//! Stiffness of windings: step limits of explicit methods for decreasing inductances.

use super::bounds::fading;
use super::edge::edge;
use super::trials::{Tried, near};
use super::{Exact, Failing, Found, NotFound, Threshold, Within};
use crate::scene::Scene;
use crate::stabilisation::schemes::Scheme;
use field::Rational;
use integrators::{Method, Span, Tolerance, integrate};
use reader::Family;
use simulation::{Axes, Problem};
use std::path::Path;

pub const FAILING: Failing = Failing {
    name: "windings",
    title: "increasingly stiff windings",
    scene: "failures/stiff_windings.toml",
    why: r"$N-2$ combinations of the $N$ bars' currents are not driven by the field and decay as $\exp(-R_2t/L_2)$ exactly. A step multiplies them by the method's factor $\rho(hR_2/L_2)$, which leaves the unit circle at $2$ for Euler and at the root of $\beta^3-4\beta^2+12\beta-24$ for Runge and Kutta, however slow the motion is.",
    advice: "Use radau_iia or rodas_4, or the motor without currents that is the limit; the steps of an explicit method must stay below 2 L2/R2.",
    asked: "the motion within 1/1000",
    measure,
};

/// The number of steps in which growth of a disturbance is detected.
const STEPS: u32 = 6_000;
/// A larger current counts as growth, A.
const LOST: f64 = 1e6;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = Scene::open(path)?;
    let ("multi_current", Some(l2), Some(r2)) =
        (scene.machine.name(), scene.machine.datum("l2"), scene.machine.datum("r2"))
    else {
        let accepted = "a motor with bars, model = \"multi_current\",";
        return Err(NotFound::unsuitable(path, format!("{} has no bars", scene.machine.name()), accepted));
    };
    let lasting = Rational::decimal(l2) / Rational::decimal(r2);
    let one = |of: &'static str, formula: &'static str, scheme, stiffer: i64| {
        let stiffer = Rational::new(1, stiffer);
        let exact = Exact::times(lasting * stiffer, fading(scheme))?;
        let near = exact.value();
        let problem = with_inductance(&scene, l2 * stiffer.to_f64())?;
        let measured = edge(0.9 * near, 1.1 * near, 1e-4, |h| fades(&problem, scheme, h));
        Some(Threshold {
            of: of.into(),
            formula: formula.into(),
            exact,
            unit: "s".into(),
            measured,
            within: Within::Share(300),
        })
    };
    let thresholds = [
        one("longest step of Euler", r"$2L_2/R_2$", Scheme::Euler, 1),
        one("longest step of Runge-Kutta 4", r"$\beta_*L_2/R_2$", Scheme::RungeKutta4, 1),
        one("longest step of Euler, windings a thousand times stiffer", r"$2L_2/R_2$", Scheme::Euler, 1000),
    ];
    let problem = scene.problem(Axes::First);
    let tried = Tried { steps: 2_000, ..Tried::of(&problem, scene.run.tolerance) };
    let right = tried.right();
    let trials = tried.all(|record| near(record, &right, 1e-3));
    let (outcome, ..) = tried.run(Method::DormandPrince5);
    let diagnosis = outcome.failure().map_or_else(String::new, |failure| failure.to_string());
    Ok(Found { thresholds: thresholds.into_iter().flatten().collect(), diagnosis, trials })
}

/// The scene with another inductance of the bars.
fn with_inductance(scene: &Scene, l2: f64) -> Option<Problem> {
    let machine = scene.machine.with("l2", l2)?;
    Some(Scene { machine, ..scene.clone() }.problem(Axes::First))
}

/// Whether a current of 1 A in the last bar decays with the step size h, s.
fn fades(problem: &Problem, scheme: Scheme, h: f64) -> bool {
    let mut state = problem.state.clone();
    if let Some(last) = state.last_mut() {
        *last += 1.0;
    }
    let span = Span::new(0.0, h * f64::from(STEPS), &state);
    let outcome = integrate(&*problem.law, scheme.method(STEPS), &Tolerance::both(1e-9), &span, &mut ());
    outcome.reached() && outcome.state.last().is_some_and(|current| current.abs() < LOST)
}
