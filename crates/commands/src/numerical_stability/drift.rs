//! `dalembert numerical-stability --drift`: the drift of conserved quantities along the motion from the start, by theory and by runs.

use super::Args;
use crate::arguments::Format;
use crate::clock;
use crate::exit::{Exit, print};
use crate::progress::Progress;
use ::scenes::{ModelScene, SceneWithIntegrals};
use integrators::Method;
use reader::{Family, read_text};
use serde_json::{Value, json};
use simulation::Axes;
use simulation::integral_drift::{
    Drift, Expected, Integral, Measured, MotionWithIntegrals, Returns, Slope, Window, expected, measured, return_time,
};
use simulation::models::holds_model;
use std::fmt::Write;
use std::ops::ControlFlow;
use studies::scene::Scene;

/// The number of periods over which the theoretical drift is reported.
const MILLION: f64 = 1e6;

/// The default number of steps of a run.
const AFFORDABLE: u32 = 2_000_000;

/// The relative change of an integral beyond which its drift is no longer proportional to time.
const A_TENTH: f64 = 0.1;

/// The default methods.
pub(super) const CLASSICAL: [Method; 4] = [
    Method::Euler { steps: 1 },
    Method::RungeKutta4 { steps: 1 },
    Method::ImplicitMidpoint { steps: 1 },
    Method::BackwardEuler { steps: 1 },
];

/// The drifts for a method with a number of steps per period.
struct Row {
    method: Method,
    /// The number of steps per period.
    steps: u32,
    expected: Result<Vec<Expected>, String>,
    measured: Result<Vec<Option<Measured>>, String>,
}

/// The drifts of all methods.
struct Found {
    title: String,
    window: Window,
    integrals: Vec<Integral>,
    /// The magnitude of each conserved quantity, in its unit; zero where it has none.
    sizes: Vec<f64>,
    rows: Vec<Row>,
    /// Whether the work of loads is integrated as an additional state.
    is_metered: bool,
}

pub(super) fn goes_on() -> ControlFlow<()> {
    if clock::has_time() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
}

/// All combinations of the requested methods and numbers of steps per period.
pub(super) fn methods(asked: &Args) -> Vec<(Method, u32)> {
    let methods = if asked.method.is_empty() { &CLASSICAL[..] } else { &asked.method[..] };
    let each = |method: &Method| asked.steps.iter().map(|steps| (*method, *steps)).collect::<Vec<_>>();
    methods.iter().flat_map(each).collect()
}

/// The number of periods of a run with a given number of steps per period.
pub(super) fn periods(asked: &Args, steps: u32) -> u32 {
    asked.periods.unwrap_or((AFFORDABLE / steps).clamp(2, MILLION as u32))
}

/// The name of a method without its number of steps.
pub(super) fn name(method: Method) -> String {
    let all = method.to_string();
    all.split(',').next().unwrap_or_default().to_owned()
}

/// Prints the drift of every conserved quantity with every method.
pub(super) fn show(asked: &Args) -> Result<Exit, Exit> {
    let refused = |why: &str| Exit::refused(format!("{}: --drift: {why}", asked.scene.display()));
    let text = read_text(&asked.scene)?;
    asked.steady.refuse("--drift=steady says which motions it is about")?;
    if asked.omega0.is_some() || asked.model.is_some() {
        return Err(refused("it is about the motion from the start; leave --omega0 and --model out"));
    }
    let (title, kept) = match holds_model(&text) {
        true => {
            let scene = ModelScene::parse(&asked.scene.display().to_string(), &text)?;
            let kept = SceneWithIntegrals::of(&scene).ok_or_else(|| {
                refused("the law of this scene changes at conditions, contacts or events: no theory of one law holds")
            })?;
            (scene.title.clone(), kept)
        }
        false => {
            let scene = Scene::open(&asked.scene)?;
            (scene.title.clone(), SceneWithIntegrals::plain(scene.problem(Axes::default())))
        }
    };
    if kept.integrals.is_empty() {
        return Err(refused("no energy and no momentum is known to be kept along this motion"));
    }
    let _progress = Progress::new("drift");
    let motion =
        MotionWithIntegrals { law: &*kept.problem.law, start: &kept.problem.state, integrals: &kept.integrals };
    let failed = |why: integrators::Failure| refused(&format!("the motion cannot be followed: {why}"));
    let gap = |component: usize, end: f64, start: f64| kept.gap(component, end, start);
    let window = match return_time(&motion, kept.problem.span, &gap).map_err(failed)? {
        Returns::After(period) => Window::Period(period),
        Returns::Not => Window::Span(kept.problem.span),
        Returns::Rests => {
            return Err(refused("the start rests; --drift=steady is about small oscillations about steady motions"));
        }
    };
    let sizes = motion.sizes(window).map_err(failed)?;
    let is_metered = kept.problem.metered > 0;
    let mut found = Found { title, window, sizes, rows: Vec::new(), integrals: Vec::new(), is_metered };
    for (method, steps) in methods(asked) {
        if goes_on().is_break() {
            break;
        }
        let whole = method.refined(steps).unwrap_or(method);
        let told = |why: integrators::Failure| why.to_string();
        let by_theory = expected(&motion, whole, window, &found.sizes, &goes_on);
        let by_theory = by_theory.map_err(told).and_then(|all| all.ok_or("no time is left".to_owned()));
        let count = match window {
            Window::Period(_) => periods(asked, steps),
            Window::Span(_) => 2,
        };
        let by_run = measured(&motion, whole, (window, count), &found.sizes, &goes_on).map_err(told);
        found.rows.push(Row { method, steps, expected: by_theory, measured: by_run });
    }
    let all = methods(asked).len() == found.rows.len() && goes_on().is_continue();
    found.integrals = kept.integrals;
    print(&match asked.format {
        Format::Text => found.text(),
        Format::Json => format!("{:#}\n", found.object()),
    })?;
    Ok(if all { Exit::Done } else { Exit::Stopped })
}

impl Found {
    /// The change of a conserved quantity relative to its magnitude; the change itself where the magnitude is zero.
    fn part(&self, place: usize, change: f64) -> f64 {
        if self.sizes[place] > 0.0 { change / self.sizes[place] } else { change }
    }

    fn text(&self) -> String {
        let mut out = format!("{}\n", self.title);
        // writing to a String cannot fail
        let _ = match self.window {
            Window::Period(period) => writeln!(out, "the motion from the start returns after {period:.9} s"),
            Window::Span(span) => writeln!(
                out,
                "the motion does not return to its start within the span of {span} s: changes are given over the span, without a drift per period"
            ),
        };
        if self.is_metered {
            out += "loads without a potential energy do work: the energy alone is not kept, the energy less this work is\n";
        }
        for (place, integral) in self.integrals.iter().enumerate() {
            let size = self.sizes[place];
            let unit = if integral.unit.is_empty() { "in SI units" } else { &integral.unit };
            let _ = match size > 0.0 {
                true => writeln!(out, "\n{}: changes as parts of {size:.6e} {unit}, its largest size", integral.name),
                false => writeln!(out, "\n{}: changes {unit}; it is zero", integral.name),
            };
            let heads = match self.window {
                Window::Period(_) => ["theory, a period", "after 10^6 periods", "run, a period"],
                Window::Span(_) => ["theory, the span", "", "run, the span"],
            };
            let [first, million, last] = heads;
            let _ =
                writeln!(out, "  {:<18} {:>7} {:>11}  {first:<34} {million:<32} {last}", "method", "steps", "step, s");
            for row in &self.rows {
                let step = self.window.length() / f64::from(row.steps);
                let [theory, million] = self.theory(place, row);
                let name = name(row.method);
                let run = self.run(place, row);
                let _ = writeln!(out, "  {name:<18} {:>7} {step:>11.4e}  {theory:<34} {million:<32} {run}", row.steps);
            }
        }
        out
    }

    /// The theoretical drift over one window, and over a million of them.
    fn theory(&self, place: usize, row: &Row) -> [String; 2] {
        let expected = match &row.expected {
            Ok(all) => all[place],
            Err(why) => return [format!("not known: {why}"), String::new()],
        };
        let swing = self.part(place, expected.swing);
        let is_period = matches!(self.window, Window::Period(_));
        match expected.drift {
            Drift::None => [format!("no drift, swings by {swing:.3e}"), "no drift".to_owned()],
            Drift::Rounding(size) if swing <= self.part(place, size) => ["kept".to_owned(), "rounding".to_owned()],
            Drift::Rounding(_) => [format!("below rounding, oscillates by {swing:.1e}"), "rounding".to_owned()],
            Drift::Of(drift) => {
                let part = self.part(place, drift);
                let after = match part.abs() * MILLION {
                    _ if !is_period => String::new(),
                    _ if part.abs() > A_TENTH => "another motion at once".to_owned(),
                    all if all > A_TENTH => format!("a tenth after {:.0} periods", A_TENTH / part.abs()),
                    _ => format!("{:.4e}", part * MILLION),
                };
                [format!("{part:.4e}"), after]
            }
        }
    }

    fn run(&self, place: usize, row: &Row) -> String {
        match row.measured.as_ref().map(|all| all[place]) {
            Err(why) => format!("no run: {why}"),
            Ok(None) => "not available: less than two periods".to_owned(),
            Ok(Some(Measured { change: None, .. })) => "leaves the motion at once".to_owned(),
            Ok(Some(Measured { change: Some(Slope { drift, windows }), .. })) => {
                format!("{:.4e} (over {windows})", self.part(place, drift))
            }
        }
    }

    fn object(&self) -> Value {
        let number = |value: f64| value.is_finite().then_some(value);
        let of = |place: usize, row: &Row| {
            let theory = row.expected.as_ref().ok().map(|all| {
                let (drift, rounding) = match all[place].drift {
                    Drift::Of(drift) => (number(drift), None),
                    Drift::None => (Some(0.0), None),
                    Drift::Rounding(below) => (None, number(below)),
                };
                json!({ "drift": drift, "below": rounding, "swing": number(all[place].swing) })
            });
            let run = row.measured.as_ref().ok().and_then(|all| all[place]);
            let run = run.map(|Measured { change, swing, .. }| {
                let (drift, windows) = change.map(|Slope { drift, windows }| (drift, windows)).unzip();
                json!({ "drift": drift, "windows": windows, "swing": number(swing) })
            });
            let step = self.window.length() / f64::from(row.steps);
            json!({ "method": name(row.method), "steps": row.steps, "step": step, "theory": theory, "run": run })
        };
        let integral = |(place, integral): (usize, &Integral)| {
            let rows: Vec<Value> = self.rows.iter().map(|row| of(place, row)).collect();
            json!({ "integral": integral.name, "unit": integral.unit, "size": self.sizes[place], "methods": rows })
        };
        let (name, length) = match self.window {
            Window::Period(period) => ("period", period),
            Window::Span(span) => ("span", span),
        };
        let integrals: Vec<Value> = self.integrals.iter().enumerate().map(integral).collect();
        json!({ "scene": self.title, name: length, "integrals": integrals })
    }
}
