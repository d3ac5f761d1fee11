//! `dalembert numerical-stability --drift=steady`: the change of the energy of small oscillations about each steady motion, by stability functions
//! and by runs with the nonlinear law.

use super::Args;
use super::drift::{goes_on, methods, name, periods};
use crate::arguments::Format;
use crate::exit::{Exit, print};
use crate::stationary::steady_box::Found;
use ::scenes::linearisation::{Standing, VariedEquations};
use ::scenes::steady_motions::SteadyMotion;
use ::scenes::{Given, ModelScene, SceneWithIntegrals};
use integrators::Method;
use reader::read_text;
use serde_json::{Value, json};
use simulation::Run;
use simulation::integral_drift::{Measured, MotionWithIntegrals, Slope, Window, measured};
use simulation::models::holds_model;
use std::f64::consts::{LN_10, TAU};
use std::fmt::Write;
use studies::numerical_stability::methods::OneStep;
use studies::numerical_stability::oscillation::displaced;
use studies::stabilisation::schemes::Scheme;

/// The number of periods over which the theoretical change is reported.
const MILLION: f64 = 1e6;

/// The largest initial displacement, as a fraction of 1 SI unit and of the coordinate itself.
const SMALL: f64 = 1e-3;

/// The change of the energy of an oscillation, for a method with a number of steps per period.
struct Row {
    method: Method,
    /// The number of steps per period.
    steps: u32,
    /// The relative change of the energy in one period.
    theory: Option<f64>,
    measured: Result<Measured, String>,
}

/// A small oscillation about a steady motion.
struct Oscillation {
    /// The angular frequency in rad/s.
    frequency: f64,
    rows: Vec<Row>,
}

/// Prints the change of the energy of every oscillation.
pub(super) fn show(asked: &Args) -> Result<Exit, Exit> {
    let path = asked.scene.display();
    let text = read_text(&asked.scene)?;
    if !holds_model(&text) || asked.omega0.is_some() || asked.model.is_some() {
        return Err(Exit::refused(format!(
            "{path}: --drift=steady is about a system that is written in its file, without --omega0 and --model; --drift is about the motion from \
             the start of any scene"
        )));
    }
    let found = asked.steady.find(&asked.scene, asked.steady.system_in(&asked.scene)?)?;
    // these settings replace a missing table [run]
    let run = Run {
        span: 1.0,
        samples: 2,
        tolerance: 1e-9,
        method: Method::DormandPrince8,
        through_singular_positions: false,
        outputs: Vec::new(),
    };
    let scene = ModelScene::parse_with(&path.to_string(), &text, Given { run: Some(run), ..Given::default() });
    let kept = scene.map_err(|_| "the start of the file is not complete".to_owned()).and_then(|scene| {
        let kept = SceneWithIntegrals::of(&scene)
            .filter(|kept| kept.integrals.first().is_some_and(|first| first.name == "energy"));
        kept.ok_or("the energy is not known to be kept".to_owned())
    });
    let equations = VariedEquations::of(&found.model, &[]).map_err(|why| why.to_string());
    let of = |motion| {
        let equations = equations.as_ref().map_err(Clone::clone)?;
        oscillations(asked, equations, motion, kept.as_ref().map_err(Clone::clone)?)
    };
    let all: Vec<_> = found.motions.motions.iter().map(of).collect();
    print(&match asked.format {
        Format::Text => written(&found, &all),
        Format::Json => format!("{:#}\n", object(&found, &all)),
    })?;
    if goes_on().is_break() {
        return Ok(Exit::Stopped);
    }
    Ok(asked.steady.ended(&asked.scene, &found.motions))
}

/// All small oscillations about a steady motion, with the results of every method.
fn oscillations(
    asked: &Args,
    equations: &VariedEquations,
    motion: &SteadyMotion,
    kept: &SceneWithIntegrals,
) -> Result<Vec<Oscillation>, String> {
    let linear = equations.about(0.0, &motion.state).map_err(|why| why.to_string())?;
    if linear.standing == Standing::Moving {
        return Err(
            "the linear equations change along the motion, so that their eigenvalues are no frequencies".to_owned()
        );
    }
    let all = studies::numerical_stability::oscillation::frequencies(&linear.eigenvalues);
    let of = |frequency: f64| {
        let displacement = &linear.linear.variations * displaced(&linear.linear.a, frequency);
        let n = motion.state.len() / 2;
        let moved = (0..n).map(|k| displacement[k].abs() / (1.0 + motion.state[k].abs())).fold(0.0, f64::max);
        let factor = if moved > 0.0 { SMALL / moved } else { SMALL };
        let start: Vec<f64> = motion.state.iter().zip(&displacement).map(|(y, by)| y + factor * by).collect();
        let integrals = [kept.energy_about(&motion.state)];
        let moving = MotionWithIntegrals { law: &*kept.problem.law, start: &start, integrals: &integrals };
        let first = (integrals[0].value)(0.0, &start);
        let rows = methods(asked).into_iter().map(|(method, steps)| {
            let whole = method.refined(steps).unwrap_or(method);
            let window = Window::Period(TAU / frequency);
            let sizes = [5.0 * first.abs()];
            let run = measured(&moving, whole, (window, periods(asked, steps)), &sizes, &goes_on);
            let run = run
                .map_err(|why| why.to_string())
                .and_then(|all| all.into_iter().next().flatten().ok_or("less than two periods are run".to_owned()));
            Row { method, steps, theory: theory(method, steps), measured: run }
        });
        Oscillation { frequency, rows: rows.collect() }
    };
    Ok(all.into_iter().map(of).collect())
}

/// The relative change of the energy of an oscillation in one period, by the stability function of the method; `None` where it has none.
fn theory(method: Method, steps: u32) -> Option<f64> {
    let (scheme, _) = Scheme::of(method, 1.0)?;
    let function = OneStep::Classical(scheme).function()?;
    let change = function.energy_change(TAU / f64::from(steps));
    Some((f64::from(steps) * change.ln_1p()).exp_m1())
}

/// The energy after a million periods divided by the initial energy, as text; `change` is the relative change in one period.
fn after_a_million(change: f64) -> String {
    let power = MILLION * change.ln_1p();
    match power.abs() {
        0.0 => "1, as it was".to_owned(),
        size if size < 0.1 => format!("1 {} {:.4e}", if power < 0.0 { '-' } else { '+' }, power.exp_m1().abs()),
        size if size < 10.0 => format!("{:.6}", power.exp()),
        _ => format!("10^{:.4}", power / LN_10),
    }
}

fn written(found: &Found, all: &[Result<Vec<Oscillation>, String>]) -> String {
    let mut out = format!("{}\n", found.title);
    // writing to a String cannot fail
    for (place, (motion, oscillations)) in found.motions.motions.iter().zip(all).enumerate() {
        let _ = writeln!(out, "\n{}  {}", place + 1, found.values(&motion.enclosure));
        match oscillations {
            Err(why) => drop(writeln!(out, "   not known: {why}")),
            Ok(none) if none.is_empty() => out += "   nothing oscillates: no eigenvalue is imaginary\n",
            Ok(all) => all.iter().for_each(|one| out += &of_one(one)),
        }
    }
    out
}

fn of_one(Oscillation { frequency, rows }: &Oscillation) -> String {
    let period = TAU / frequency;
    let mut out = format!(
        "   oscillation with {frequency:.10} rad/s, period {period:.9} s: changes of its energy, as parts of it\n"
    );
    let _ = writeln!(
        out,
        "   {:<18} {:>7} {:>11}  {:<18} {:<24} run, a period",
        "method", "steps", "step, s", "exact, a period", "energy after 10^6"
    );
    for Row { method, steps, theory, measured } in rows {
        let step = period / f64::from(*steps);
        let exact = theory.map_or("not known".to_owned(), |change| format!("{change:.6e}"));
        let after = theory.map_or(String::new(), after_a_million);
        let run = match measured {
            Err(why) => format!("no run: {why}"),
            Ok(Measured { part: None, .. }) => "the run leaves the motion".to_owned(),
            Ok(Measured { part: Some(Slope { drift, windows }), .. }) => format!("{drift:.6e} (over {windows})"),
        };
        let _ = writeln!(out, "   {:<18} {steps:>7} {step:>11.4e}  {exact:<18} {after:<24} {run}", name(*method));
    }
    out
}

fn object(found: &Found, all: &[Result<Vec<Oscillation>, String>]) -> Value {
    let row = |row: &Row| {
        let run = row.measured.as_ref().ok();
        let run = run.map(
            |run| json!({ "change": run.part.map(|part| part.drift), "periods": run.part.map(|part| part.windows) }),
        );
        json!({ "method": name(row.method), "steps": row.steps, "exact": row.theory, "run": run })
    };
    let one = |one: &Oscillation| {
        let rows: Vec<Value> = one.rows.iter().map(row).collect();
        json!({ "frequency": one.frequency, "period": TAU / one.frequency, "methods": rows })
    };
    let motion = |(motion, oscillations): (&SteadyMotion, &Result<Vec<Oscillation>, String>)| {
        let values = found.motions.unknowns.iter().zip(&motion.enclosure);
        json!({
            "motion": values.map(|(unknown, at)| (unknown.name.clone(), json!(at))).collect::<serde_json::Map<_, _>>(),
            "oscillations": oscillations.as_ref().ok().map(|all| all.iter().map(one).collect::<Vec<_>>()),
            "unknown": oscillations.as_ref().err(),
        })
    };
    let motions: Vec<Value> = found.motions.motions.iter().zip(all).map(motion).collect();
    json!({ "scene": found.title, "complete": found.motions.is_complete(), "motions": motions })
}
