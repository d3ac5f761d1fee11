//! `dalembert numerical-stability`: the step sizes for which a method preserves the stability or instability of a steady motion.

mod drift;
mod model;
mod oscillations;

use crate::arguments::{Format, finite, whole};
use crate::exit::{Exit, print};
use crate::run::with_model;
use crate::stationary::steady_box::SteadyBox;
use clap::ValueEnum;
use integrators::{Method, Splitting};
use reader::{Family, read_text};
use serde_json::{Value, json};
use simulation::methods;
use simulation::models::holds_model;
use std::path::PathBuf;
use studies::numerical_stability::chart::{Chart, ChartedMotion, Row, said};
use studies::numerical_stability::motions::Stationed;
use studies::numerical_stability::splittings::SplitRuns;
use studies::numerical_stability::survey::steps;
use studies::numerical_stability::tested_steps::Tested;
use studies::scene::Scene;

/// Arguments of `numerical-stability`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The angular velocity of the motions about the vertical, rad/s; the default is 0
    #[arg(long, value_name = "W", value_parser = finite, allow_negative_numbers = true)]
    pub omega0: Option<f64>,
    #[command(flatten)]
    pub steady: SteadyBox,
    /// Replaces the motor by another model; its data are computed from the scene
    #[arg(long)]
    pub model: Option<String>,
    /// Prints the drift of conserved energies and momenta, by theory and by runs: along the motion from the start, or for oscillations about
    /// each steady motion
    #[arg(long, value_enum, value_name = "MOTION", num_args = 0..=1, require_equals = true, default_missing_value = "start")]
    pub drift: Option<Motion>,
    /// For --drift: the number of equal steps in a period; several numbers are separated by commas
    #[arg(long, value_name = "N,N", value_delimiter = ',', default_values_t = [20, 100], value_parser = whole::<u32>(1..=1_000_000), requires = "drift")]
    pub steps: Vec<u32>,
    /// For --drift: the number of periods of each run; the default is as many periods as two million steps make, at most a million
    #[arg(long, value_name = "N", value_parser = whole::<u32>(2..=1_000_000), requires = "drift")]
    pub periods: Option<u32>,
    /// For --drift: a method with constant steps, such as implicit_midpoint; may be repeated. The default is euler, runge_kutta_4,
    /// implicit_midpoint and backward_euler
    #[arg(long, value_name = "METHOD", value_parser = constant, requires = "drift")]
    pub method: Vec<Method>,
    /// Output format; JSON is one object: scene, model, omega0, motions
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// The motion along which the drift of conserved quantities is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Motion {
    /// The motion from the start of the file
    Start,
    /// Small oscillations about each steady motion
    Steady,
}

/// Parses the name of a method with constant steps.
fn constant(name: &str) -> Result<Method, String> {
    let known = || {
        let named = methods::list().filter_map(|(written, _)| written.strip_suffix(":STEPS").map(str::to_owned));
        format!("the name of a method with constant steps is accepted: {}", named.collect::<Vec<_>>().join(", "))
    };
    methods::method(&format!("{name}:1")).ok().filter(|method| method.steps().is_some()).ok_or_else(known)
}

/// The tests of all splitting methods at a motion.
type Courses = [Tested; Splitting::ALL.len()];

/// Prints the verdicts of all methods at all steady motions.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    match asked.drift {
        Some(Motion::Start) => return drift::show(asked),
        Some(Motion::Steady) => return oscillations::show(asked),
        None => {}
    }
    if read_text(&asked.scene).is_ok_and(|text| holds_model(&text)) {
        return model::show(asked);
    }
    asked.steady.refuse("--omega0 says which motions of this one")?;
    let scene = with_model(Scene::open(&asked.scene)?, asked.model.as_deref(), &asked.scene)?;
    if asked.omega0.is_some() && scene.on_bench() {
        return Err(Exit::refused(format!(
            "--omega0 does not apply to {}: a motor on a bench does not turn about the vertical; leave it out",
            asked.scene.display()
        )));
    }
    let omega0 = asked.omega0.unwrap_or_default();
    let chart =
        Chart::of(&scene, omega0).map_err(|reason| Exit::refused(format!("{}: {reason}", asked.scene.display())))?;
    // along a family of motions several multipliers are exactly one, and rounding would move them apart
    let of_motion = |motion: &Stationed| {
        let near = motion.member.is_none().then(|| SplitRuns::near(&scene, motion))?;
        Some(Splitting::ALL.map(|splitting| near.course(splitting, &steps())))
    };
    let tested: Vec<_> = chart.all.motions.iter().map(of_motion).collect();
    print(&match asked.format {
        Format::Text => text(&scene, omega0, &chart, &tested),
        Format::Json => format!("{:#}\n", object(&scene, omega0, &chart, &tested)),
    })?;
    let known = chart.rows.iter().all(|rows| !rows.is_empty() && rows.iter().all(|row| row.steps.is_some()));
    Ok(if known { Exit::Done } else { Exit::Stopped })
}

fn text(scene: &Scene, w: f64, chart: &Chart, tested: &[Option<Courses>]) -> String {
    let turning = match scene.on_bench() {
        true => String::new(),
        false => format!("angular velocity about the vertical: {w} rad/s\n"),
    };
    let mut text = format!("{}\n{turning}{}", scene.title, chart.text());
    for (place, (motion, tested)) in chart.all.motions.iter().zip(tested).enumerate() {
        text += &format!("\n{} {motion}\n", place + 1);
        if tested.is_none() {
            text += "  splittings are not tested on a member of a family\n";
        }
        for one in tested.iter().flatten() {
            text += &format!("  {:<20} {}\n", one.splitting.name(), one.told());
        }
    }
    text
}

fn object(scene: &Scene, w: f64, chart: &Chart, tested: &[Option<Courses>]) -> Value {
    let each = chart.all.motions.iter().zip(&chart.rows).zip(tested).map(|((motion, rows), tested)| {
        let spectrum = motion.spectrum.as_ref();
        json!({
            "motion": motion.to_string(),
            "does": spectrum.map(|spectrum| ChartedMotion::of(spectrum).to_string()),
            "eigenvalues": spectrum.map(|spectrum| chart.eigenvalues(spectrum)),
            "methods": rows.iter().map(method).collect::<Vec<_>>(),
            "splittings": tested.as_ref().map(|all| all.iter().map(splitting).collect::<Vec<_>>()),
        })
    });
    json!({ "scene": scene.title, "model": scene.machine.name(), "omega0": w, "motions": each.collect::<Vec<_>>() })
}

/// The verdicts of a method on the ranges of step sizes, in seconds, from zero on; the last range is unbounded.
fn method(row: &Row) -> Value {
    let stretches = row.steps.as_ref().map(|steps| {
        let each = steps.all().map(|(from, to, stretch)| {
            json!({ "from": from.map_or(0.0, |from| from.to_f64()), "to": to.map(|to| to.to_f64()),
                    "says": said(stretch), "growing": stretch.growing, "staying": stretch.staying })
        });
        each.collect::<Vec<_>>()
    });
    json!({ "method": row.method.to_string(), "stretches": stretches })
}

fn splitting(tested: &Tested) -> Value {
    let grows = tested.grows.iter().map(|(step, grows)| json!({ "step": step, "grows": grows }));
    let proved = tested.proved.as_ref().ok().map(|proved| {
        let each = proved.stretches.iter().map(|(from, to, grows)| json!({ "from": from, "to": to, "grows": grows }));
        each.collect::<Vec<_>>()
    });
    let alone = tested.proved.as_ref().ok().map(|proved| {
        let each = proved.alone.iter().map(|(step, grows)| json!({ "step": step, "grows": grows }));
        each.collect::<Vec<_>>()
    });
    json!({ "method": tested.splitting.name(), "tested": grows.collect::<Vec<_>>(), "edges": tested.edges, "proved": proved,
            "proved_alone": alone,
            "longest": tested.longest.is_finite().then_some(tested.longest) })
}
