//! Drift off a constraint after index reduction, which enforces only the second derivative of the constraint.

use super::trials::{BUDGET, fate};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::AnyScene;
use crate::stabilisation::drifting::{Drift, Drifting};
use crate::stabilisation::law::{Stabilised, state};
use crate::stabilisation::schemes::Scheme;
use field::Rational;
use integrators::{Attempt, Index2Method, Method, Ode, Record, Span, Tolerance, integrate};
use mechanics::constrained::energies::{Kinematics, Reduced};
use num_traits::Zero;
use reader::Family;
use simulation::work_precision::{Configuration, Formulation, Standing, Treated};
use simulation::{Axes, CompiledLaw, IvpScene, Law};
use std::path::Path;
use std::sync::Arc;
use symbolic::Sym;
use systems::crank_slider::CrankSlider;

pub const FAILING: Failing = Failing {
    name: "constraint",
    title: "drift of a constraint that is enforced only in its second derivative",
    scene: "bodies/crank_slider.toml",
    why: r"Multipliers from $\ddot f=0$ leave $f=f_0+\dot f_0t$ free: the matrix of a step has the double eigenvalue 1 in one Jordan block, for every method and every step. Errors of a method in $\dot f$ add up, and $f$ drifts as $t$ and as $t^2$.",
    advice: "Use coordinates that satisfy the constraint where they exist; otherwise enforce both the constraint and its rate (Gear, Gupta, Leimkuhler) or project after each step, and stabilise by gains only inside the stability region of the method.",
    asked: "a violation below a millionth of a square metre for 100 s",
    measure,
};

/// The length of the long run divided by that of the scene.
const LONGER: f64 = 10.0;
/// The number of steps of the long run.
const LONG: u32 = 10_000;
/// The largest allowed violation, m^2.
const KEPT: f64 = 1e-6;
/// An initial velocity error, m/s, and the number of steps of the run in which its violation grows.
const OFF: f64 = 1e-3;
const STEPS: u32 = 1_000;
const STEP: f64 = 1e-4;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = AnyScene::open(path)?;
    let scene = scene.smooth();
    let mechanism = mechanism(scene).map_err(|missing| unsuitable(path, format!("it has no `{missing}`")))?;
    let problem = scene.problem(Axes::First);
    let start = &problem.state;
    let &[angle, _, speed, _] = &start[..] else {
        return Err(unsuitable(path, "it has other coordinates than the angle and the slider".to_owned()));
    };
    let map = Scheme::RungeKutta4.transition(Rational::zero(), Rational::zero());
    let passed_on = Threshold {
        of: "growth of a violation per unit of time over its initial rate, any method".into(),
        formula: r"$(f_n-f_0)/(nh\dot f_0)$".into(),
        exact: Exact::Number(map.map_or(Rational::UNDEFINED, |[[_, across], _]| across)),
        unit: "".into(),
        measured: added(&mechanism, start),
        within: Within::Share(1_000_000),
    };
    let span = LONGER * scene.run().span;
    let ways = [minimal(&mechanism, [angle, speed])].into_iter().chain(scene.ways());
    let trials: Vec<Trial> = ways.flat_map(|way| tried(&mechanism, &way, span)).collect();
    let diagnosis = drifts(&mechanism, start, span).map_or_else(String::new, |drift| drift.to_string());
    Ok(Found { thresholds: vec![passed_on], diagnosis, trials })
}

/// The mechanism from the data of a scene.
///
/// # Errors
/// The name of a missing datum.
fn mechanism(scene: &dyn IvpScene) -> Result<CrankSlider<f64>, &'static str> {
    let data = scene.parameters();
    let datum = |name: &'static str| {
        let found = data.iter().find(|datum| datum.name == name);
        found.and_then(|datum| datum.value.parse().ok()).ok_or(name)
    };
    let [inertia, mass, crank, rod, weight] = ["J", "m", "r", "l", "G"].map(datum);
    Ok(CrankSlider { inertia: inertia?, mass: mass?, crank: crank?, rod: rod?, weight: weight? })
}

fn unsuitable(path: &Path, found: String) -> NotFound {
    NotFound::unsuitable(path, found, "a system with the parameters J, m, r, l, G of scenes/bodies/crank_slider.toml")
}

/// The mechanism in a minimal coordinate, the angle of its crank.
#[derive(Clone)]
struct Minimal(CrankSlider<f64>);

impl Ode<Sym> for Minimal {
    fn dimension(&self) -> usize {
        2
    }

    fn rates(&self, t: Sym, y: &[Sym], dy: &mut [Sym]) {
        Stabilised::<_, 1, 0> { system: &Reduced(&self.0), damping: 0.0, stiffness: 0.0 }.rates(t, y, dy);
    }
}

fn minimal(mechanism: &CrankSlider<f64>, start: [f64; 2]) -> Configuration {
    let law: Arc<dyn Law> = Arc::new(CompiledLaw::new(Minimal(*mechanism)));
    Configuration {
        formulation: Formulation::Minimal,
        model: "",
        standing: Standing::Exact,
        law: Treated::Free(law),
        state: start.to_vec(),
        sizes: Vec::new(),
        columns: Vec::new(),
        row: Box::new(|_, state| state.to_vec()),
    }
}

/// The residuals f and f' at (q, q').
fn violation(mechanism: &CrankSlider<f64>, y: &[f64]) -> [f64; 2] {
    let found = Kinematics::of(mechanism, &state::<f64, 2>(0.0, y));
    [found.value[0], found.rate[0]]
}

/// The growth of a violation in a run, divided by its initial rate and the time; theoretically one.
fn added(mechanism: &CrankSlider<f64>, start: &[f64]) -> Option<f64> {
    let mut y = start.to_vec();
    *y.get_mut(3)? += OFF;
    let law = Stabilised { system: mechanism, damping: 0.0, stiffness: 0.0 };
    let span = Span::new(0.0, STEP * f64::from(STEPS), &y);
    let outcome = integrate(&law, Method::RungeKutta4 { steps: STEPS }, &Tolerance::both(1e-9), &span, &mut ());
    let ([from, rate], [to, _]) = (violation(mechanism, &y), violation(mechanism, &outcome.state));
    outcome.reached().then(|| (to - from) / (rate * outcome.time))
}

/// The drift that the monitor finds in a run of Runge-Kutta 4 after index reduction.
fn drifts(mechanism: &CrankSlider<f64>, start: &[f64], end: f64) -> Option<Drift> {
    let law = Stabilised { system: mechanism, damping: 0.0, stiffness: 0.0 };
    let span = Span::new(0.0, end, start);
    let mut drifting = Drifting::new(|y: &[f64]| violation(mechanism, y), (0.0, start), KEPT);
    integrate(&law, Method::RungeKutta4 { steps: LONG }, &Tolerance::both(1e-9), &span, &mut drifting);
    drifting.found
}

/// Trials of a formulation by all methods that accept it.
fn tried(mechanism: &CrankSlider<f64>, way: &Configuration, span: f64) -> Vec<Trial> {
    let constant = Method::RungeKutta4 { steps: LONG };
    let attempts = match &way.law {
        Treated::Free(law) => {
            [constant, Method::DormandPrince8].map(|method| Attempt::Integrated(&**law, method)).to_vec()
        }
        // formulations with contacts are not compared here
        Treated::Hybrid(_) => Vec::new(),
        Treated::Held(law) => vec![
            Attempt::Held(&**law, Index2Method::ProjectedGauss { stages: 3, steps: 2_500 }),
            Attempt::Held(&**law, Index2Method::HalfExplicitRungeKutta4 { steps: LONG }),
        ],
    };
    // minimal coordinates have no constraint to violate
    let violated = |y: &[f64]| if y.len() < 4 { [0.0; 2] } else { violation(mechanism, y) };
    let one = |attempt: Attempt<'_>| {
        let from = Span::new(0.0, span, &way.state).with_even_outputs(10).with_evaluations(BUDGET);
        let (mut record, mut drifting) = (Record::new(), Drifting::new(violated, (0.0, &way.state), KEPT));
        let outcome = attempt.run(&Tolerance::both(1e-6), &from, &mut (&mut record, &mut drifting));
        let fate = fate(&outcome, &record, drifting.found.map(|drift| drift.name()), |_| true);
        Trial { by: format!("{}, {}", way.formulation, attempt.means()), fate }
    };
    attempts.into_iter().map(one).collect()
}
