//! Explicit Euler outside the region of its gains.

use super::bounds::first_positive;
use super::edge::edge;
use super::trials::Tried;
use super::{Exact, Failing, Found, NotFound, Threshold, Within};
use crate::mechanisms::drive::Drive;
use crate::mechanisms::{Balanced, Mechanism, MechanismScene};
use crate::stabilisation::schemes::{Scheme, inside_unit_circle};
use field::Rational;
use integrators::{Method, Observer, Span, Tolerance, integrate};
use reader::Family;
use simulation::{Axes, Smooth};
use std::convert::Infallible;
use std::path::Path;
use symbolic::Sym;

pub const FAILING: Failing = Failing {
    name: "gains",
    title: "explicit Euler outside the region of its gains",
    scene: "drive/euler_overdamped.toml",
    why: r"A violation that is led by $\ddot f=-b\dot f-kf$ is multiplied in a step of Euler by a matrix of $\beta=hb$, $\kappa=h^2k$, whose eigenvalues are inside the unit circle if and only if $0<\kappa<\beta<2+\kappa/2$. Stronger damping than that makes the violation grow, because the step is too long for the damping itself.",
    advice: "Take h b = 2, h^2 k = 1 for Euler, any positive gains for backward Euler or the midpoint rule, or no gains at all: coordinates that keep the constraint.",
    asked: "the rod's constraint within a tenth of its length squared",
    measure,
};

/// Steps in which a violation that grows is seen.
const STEPS: u32 = 3_000;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = MechanismScene::open(path)?;
    let accepted = "system = \"crank_drive\" with a constant step of Euler";
    let euler = Scheme::of(scene.run.method, scene.run.span).filter(|(scheme, _)| *scheme == Scheme::Euler);
    let (true, Some((scheme, step))) = (scene.name == Drive::NAME, euler) else {
        return Err(NotFound::unsuitable(path, format!("{} by {}", scene.name, scene.run.method), accepted));
    };
    let datum = |name: &str| scene.data.iter().find(|(quantity, _)| quantity.name == name).map_or(0.0, |it| it.1);
    let (b, h) = (Sym::symbol("b"), Sym::constant(Rational::decimal(step)));
    let stiffness = Sym::constant(Rational::decimal(datum("stiffness")));
    let conditions = scheme.transition(h * b, h * h * stiffness).map(inside_unit_circle);
    let [above, _, below] = conditions.unwrap_or([Sym::UNDEFINED; 3]);
    let keeps = |damping: f64| kept(&scene, damping, step);
    let one = |of, formula, condition, inwards: f64, parts| {
        let exact = Exact::root(first_positive(condition, b))?;
        let near = exact.value();
        let measured = edge(near * (1.0 + inwards), near * (1.0 - inwards), 1e-3, keeps);
        Some(Threshold { of, formula, exact, unit: "1/s", measured, within: Within::Share(parts) })
    };
    let thresholds = [
        one("greatest damping that Euler bears", r"$2/h+hk/2$", below, -0.3, 50),
        one("least damping that Euler needs", r"$hk$", above, 0.5, 20),
    ];
    let problem = scene.problem();
    let tried = Tried { steps: scene.run.method.steps().unwrap_or(1), outputs: 100, ..Tried::of(&problem, 1e-6) };
    let trials = tried.all(|_| true);
    let choice = scene.run.choice();
    let trajectory = Smooth::problem(&scene, Axes::First).simulate(&choice, |_| ());
    let diagnosis = scene.told(&choice, &trajectory).diagnosis.unwrap_or_default();
    Ok(Found { thresholds: thresholds.into_iter().flatten().collect(), diagnosis, trials })
}

/// Whether Euler keeps the constraint with a damping.
fn kept(scene: &MechanismScene, damping: f64, step: f64) -> bool {
    let datum = |name: &str| scene.data.iter().find(|(quantity, _)| quantity.name == name).map_or(0.0, |it| it.1);
    let Ok(drive) = Drive::read::<Infallible>(&mut |quantity| {
        Ok(if quantity.name == "damping" { damping } else { datum(&quantity.name) })
    });
    let mut state = drive.state(&scene.start);
    state.push(0.0);
    let span = Span::new(0.0, step * f64::from(STEPS), &state);
    let mut lost = Lost { drive: &drive, lost: false };
    let law = Balanced(drive);
    let outcome = integrate(&law, Method::Euler { steps: STEPS }, &Tolerance::both(1e-9), &span, &mut lost);
    outcome.reached() && !lost.lost
}

/// Whether the constraint was lost on the way.
struct Lost<'a> {
    drive: &'a Drive,
    lost: bool,
}

impl Observer<f64> for Lost<'_> {
    fn step(&mut self, _time: f64, y: &[f64]) {
        self.lost |= self.drive.outside(y, &y[..Drive::STATE.len()]).is_some();
    }

    fn enough(&self) -> bool {
        self.lost
    }
}
