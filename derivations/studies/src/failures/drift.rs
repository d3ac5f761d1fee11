//! Drift of a constraint that is kept only differentiated twice.

use super::trials::{BUDGET, fate};
use super::{Exact, Failing, Found, NotFound, Threshold, Trial, Within};
use crate::mechanisms::{Mechanism, MechanismScene};
use crate::stabilisation::drifting::{Drift, Drifting};
use crate::stabilisation::law::{Stabilised, state};
use crate::stabilisation::schemes::Scheme;
use field::Rational;
use integrators::{Attempt, Holding, Method, Record, Span, Tolerance, integrate};
use mechanics::constrained::energies::{Kinematics, Reduced};
use num_traits::Zero;
use reader::Family;
use simulation::Smooth;
use simulation::work_precision::{Treated, Way};
use std::convert::Infallible;
use std::path::Path;
use systems::crank_slider::CrankSlider;

pub const FAILING: Failing = Failing {
    name: "constraint",
    title: "drift of a constraint that is kept only differentiated twice",
    scene: "bodies/crank_slider.toml",
    why: r"Multipliers from $\ddot f=0$ leave $f=f_0+\dot f_0t$ free: the matrix of a step has the double eigenvalue 1 in one Jordan block, for every method and every step. What a method errs in $\dot f$ is summed up, and $f$ drifts as $t$ and as $t^2$.",
    advice: "Take coordinates that keep the constraint where there are some; otherwise hold the constraint and its rate both (Gear, Gupta, Leimkuhler) or project after each step, and stabilise by gains only inside the region of the method.",
    asked: "a violation below a millionth of a square metre for 100 s",
    measure,
};

/// Longer than the scene by this factor.
const LONGER: f64 = 10.0;
/// Steps over that.
const LONG: u32 = 10_000;
/// What may be left of a violation, m^2.
const KEPT: f64 = 1e-6;
/// A violation's first rate, m/s, and the run that follows it.
const OFF: f64 = 1e-3;
const STEPS: u32 = 1_000;
const STEP: f64 = 1e-4;

fn measure(path: &Path) -> Result<Found, NotFound> {
    let scene = MechanismScene::open(path)?;
    if scene.name != <CrankSlider<f64> as Mechanism>::NAME {
        return Err(NotFound::unsuitable(path, format!("this is a {}", scene.name), "system = \"crank_slider\""));
    }
    let datum = |name: &str| scene.data.iter().find(|(quantity, _)| quantity.name == name).map_or(0.0, |it| it.1);
    let Ok(mechanism) = <CrankSlider<f64> as Mechanism>::read::<Infallible>(&mut |quantity| Ok(datum(&quantity.name)));
    let map = Scheme::RungeKutta4.transition(Rational::zero(), Rational::zero());
    let passed_on = Threshold {
        of: "share of a violation's rate that each step adds to the violation, any method",
        formula: r"$(f_n-f_0)/(nh\dot f_0)$",
        exact: Exact::Number(map.map_or(Rational::UNDEFINED, |[[_, across], _]| across)),
        unit: "",
        measured: added(&mechanism, &scene.start),
        within: Within::Share(1_000_000),
    };
    let span = LONGER * scene.run.span;
    let trials: Vec<Trial> = scene.ways().iter().flat_map(|way| tried(&mechanism, way, span)).collect();
    let diagnosis = drifts(&mechanism, &scene.start, span).map_or_else(String::new, |drift| drift.to_string());
    Ok(Found { thresholds: vec![passed_on], diagnosis, trials })
}

/// f and f' at (q, q').
fn violation(mechanism: &CrankSlider<f64>, y: &[f64]) -> [f64; 2] {
    let found = Kinematics::of(mechanism, &state::<f64, 2>(0.0, y));
    [found.value[0], found.rate[0]]
}

/// What a run adds to a violation, in units of its rate and the time.
fn added(mechanism: &CrankSlider<f64>, start: &[f64]) -> Option<f64> {
    let (q, dq) = Reduced(mechanism).motion(0.0, [*start.first()?], [*start.get(1)?]);
    let y = [q[0], q[1], dq[0], dq[1] + OFF];
    let law = Stabilised { system: mechanism, damping: 0.0, stiffness: 0.0 };
    let span = Span::new(0.0, STEP * f64::from(STEPS), &y);
    let outcome = integrate(&law, Method::RungeKutta4 { steps: STEPS }, &Tolerance::both(1e-9), &span, &mut ());
    let ([from, rate], [to, _]) = (violation(mechanism, &y), violation(mechanism, &outcome.state));
    outcome.reached().then(|| (to - from) / (rate * outcome.time))
}

/// What is said of a run after index reduction, by Runge-Kutta 4.
fn drifts(mechanism: &CrankSlider<f64>, start: &[f64], end: f64) -> Option<Drift> {
    let (q, dq) = Reduced(mechanism).motion(0.0, [*start.first()?], [*start.get(1)?]);
    let law = Stabilised { system: mechanism, damping: 0.0, stiffness: 0.0 };
    let y = [q, dq].concat();
    let span = Span::new(0.0, end, &y);
    let mut drifting = Drifting::new(|y: &[f64]| violation(mechanism, y), (0.0, &y), KEPT);
    integrate(&law, Method::RungeKutta4 { steps: LONG }, &Tolerance::both(1e-9), &span, &mut drifting);
    drifting.found
}

/// A formulation by methods of its own.
fn tried(mechanism: &CrankSlider<f64>, way: &Way, span: f64) -> Vec<Trial> {
    let constant = Method::RungeKutta4 { steps: LONG };
    let attempts = match &way.law {
        Treated::Free(law) => {
            [constant, Method::DormandPrince8].map(|method| Attempt::Integrated(&**law, method)).to_vec()
        }
        Treated::Projected(law, held) => vec![Attempt::Projected(&**law, &**held, constant)],
        // what has contacts is no mechanism held to constraints alone
        Treated::Across(_) => Vec::new(),
        Treated::Held(law) => vec![
            Attempt::Held(&**law, Holding::ProjectedGauss { stages: 3, steps: 2_500 }),
            Attempt::Held(&**law, Holding::HalfExplicitRungeKutta4 { steps: LONG }),
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
