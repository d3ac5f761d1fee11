//! `dalembert choose`: the smallest model that meets a tolerance in the outputs that matter, with its receipt.

use crate::arguments::{Format, tolerance};
use crate::ending::{Ending, print, save};
use crate::run::{refuse, with_model};
use charts::{Method, Point, Work, WorkPrecision};
use clap::Args;
use derivations::friction::course::WORKS;
use derivations::ladder::rough::RoughLadder;
use derivations::ladder::{Estimate, Forms, Ladder, Line, Loss, Models, Receipt, Verdict, Wish, choose};
use derivations::scene::{AnyScene, Axes, Family, Smooth, Stored, System, methods};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;
use std::time::Duration;

/// What is to be met, and in what.
#[derive(Args, Debug)]
pub struct Asked {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Largest error allowed, relative to the size of each output
    #[arg(long = "tol", value_name = "T", value_parser = tolerance, allow_negative_numbers = true, default_value = "1e-6")]
    pub tolerance: f64,
    /// What matters, by the names of a run's columns; without it the outputs of the scene
    #[arg(long, value_name = "A,B", value_delimiter = ',')]
    pub outputs: Vec<String>,
    /// The model that is taken for exact: another machine, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// Draws error against the cost of every model
    #[arg(long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
    /// How to print the receipt
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// Time allowed for taking times, and again for where to switch between models
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=3600))]
    pub seconds: u32,
}

/// Chooses, prints the receipt, draws what is asked for.
pub fn show(asked: &Asked) -> Result<Ending, Ending> {
    let scene = match AnyScene::open(&asked.scene)? {
        AnyScene::Driven(scene) => {
            AnyScene::Driven(Box::new(with_model(*scene, asked.model.as_deref(), &asked.scene)?))
        }
        other => other,
    };
    let (models, given): (Box<dyn Models>, Vec<String>) = match &scene {
        AnyScene::Driven(scene) => {
            let axes = if matches!(scene.system, System::Bench { .. }) { &AXES[..1] } else { &AXES[..] };
            let ladders = axes.iter().map(|axes| Ladder::of_scene(scene, *axes)).collect();
            (Box::new(Forms { ladders, kept: Stored::beside(&asked.scene) }), scene.run.outputs.clone())
        }
        AnyScene::Mechanism(scene) => {
            refuse("a mechanism", asked.model.is_some(), false, &asked.scene)?;
            let kept = Stored::beside(&asked.scene);
            (Box::new(Forms { ladders: vec![scene.ladder()], kept }), Smooth::run(&**scene).outputs.clone())
        }
        AnyScene::Rough(scene) => {
            refuse("a system with rough contacts", asked.model.is_some(), false, &asked.scene)?;
            (Box::new(RoughLadder::of(scene)), Vec::new())
        }
    };
    let title = scene.title();
    let outputs = outputs(asked, given, models.columns())?;
    let wish = Wish { tolerance: asked.tolerance, outputs, allowed: Duration::from_secs(asked.seconds.into()) };
    let receipt = match choose(&*models, &wish) {
        Ok(receipt) => receipt,
        Err(why) => {
            print(&format!("{title}\n\nnothing can be chosen: the scene's own model stops: {why}\n"))?;
            return Ok(Ending::Stopped);
        }
    };
    print(&match asked.format {
        Format::Text => text(title, &receipt),
        Format::Json => format!("{:#}\n", object(title, &receipt)),
    })?;
    if let Some(path) = &asked.out {
        save(path, &picture(title, &*models, &wish, receipt.clone()).svg())?;
    }
    Ok(if receipt.taken.is_some() { Ending::Done } else { Ending::Stopped })
}

const AXES: [Axes; 2] = [Axes::First, Axes::Second];

/// Those that are asked for, or those of the scene, or all states that its own model shows.
fn outputs(asked: &Asked, given: Vec<String>, known: &[String]) -> Result<Vec<String>, Ending> {
    // the work that a mechanism's run meters is none of its ladder's
    if let Some(wrong) = asked.outputs.iter().find(|name| !known.contains(name) || *name == "work") {
        let known: Vec<&str> = known.iter().map(String::as_str).filter(|name| *name != "work").collect();
        return Err(Ending::refused(format!(
            "{}: unknown output `{wrong}`; known: {}",
            asked.scene.display(),
            known.join(", ")
        )));
    }
    let state = |name: &&String| *name != "work" && !WORKS.contains(&name.as_str());
    let all = || known.iter().filter(state).cloned().collect();
    Ok([asked.outputs.clone(), given].into_iter().find(|names| !names.is_empty()).unwrap_or_else(all))
}

fn text(title: &str, receipt: &Receipt) -> String {
    let mut out = format!("{title}\n\nto {:.0e} in {}\n\n", receipt.tolerance, receipt.watched.names.join(", "));
    let head = ["model", "states", "its error", "2nd order", "small", "evaluations", "time", "promised", "measured"];
    let widths = [37, 8, 11, 11, 11, 13, 8, 11, 10];
    let row = |cells: [String; 9]| {
        let cells = cells.iter().zip(widths).map(|(cell, width)| format!("{cell:<width$}"));
        format!("{}\n", cells.collect::<String>().trim_end())
    };
    out += &row(head.map(str::to_owned));
    let unit = receipt.lines.first().and_then(|line| line.choice.as_ref()?.seconds);
    for (at, line) in receipt.lines.iter().enumerate() {
        let choice = line.choice.as_ref();
        let mark = if receipt.taken == Some(at) { " <-" } else { "" };
        let model = line.model.as_ref().ok();
        let exact = !matches!(line.loss, Loss::Small { .. });
        out += &row([
            format!("{}{mark}", line.name.replace('_', " ")),
            line.states.to_string(),
            if exact { "none".to_owned() } else { error(model) },
            if exact { String::new() } else { told(model.map(|model| model.second)) },
            told(model.and_then(|model| model.small)),
            choice.map_or_else(|| said(line), |choice| choice.evaluations.to_string()),
            choice.and_then(|choice| Some(format!("{:.2}", choice.seconds? / unit?))).unwrap_or_default(),
            choice.map_or_else(String::new, |choice| format!("{:.1e}", choice.promised)),
            choice.and_then(|choice| choice.measured).map_or_else(String::new, |error| format!("{error:.1e}")),
        ]);
    }
    // writing to a String cannot fail
    let _ = writeln!(out, "\nwhat each drops, and why it may");
    for line in receipt.lines.iter().skip(1) {
        let why = match line.loss {
            Loss::Own => String::new(),
            Loss::Nothing { claim: Some(claim) } => format!("exact, proved for these data; for all: {claim}"),
            Loss::Nothing { claim: None } => "exact: the laws do not differ, which is decided".to_owned(),
            Loss::Held { .. } if line.model.is_err() => "exact while it lasts".to_owned(),
            Loss::Held { margin, at } => {
                format!(
                    "exact while it lasts: at {at:.6} s by {margin:.2e} of what it is measured by; tested, not enclosed"
                )
            }
            Loss::Small { parameter } => format!("small: {parameter}"),
        };
        let not = line.model.as_ref().err().map_or_else(String::new, |why| format!("; {why}"));
        let _ = writeln!(out, "  {}: {} ({why}){not}", line.name.replace('_', " "), line.dropped);
    }
    if let Some((line, choice)) =
        receipt.taken.and_then(|at| Some((&receipt.lines[at], receipt.lines[at].choice.as_ref()?)))
    {
        let _ = writeln!(
            out,
            "\ntaken: {} by {} in the axes of the {} form at {:.1e}",
            line.name.replace('_', " "),
            choice.plan.method,
            choice.plan.axes,
            choice.plan.tolerance
        );
    } else {
        let _ = writeln!(out, "\nno model meets the tolerance");
    }
    if let Some(saved) = receipt.saved() {
        let _ = writeln!(out, "saved: the scene's own model by its best method takes {saved:.2} times as long");
    }
    let _ = writeln!(
        out,
        "{}\npromised errors are estimates of first and second order with the distance from a finer run, and no bounds{}",
        decided(receipt),
        if receipt.lines.iter().any(|line| line.model.as_ref().is_ok_and(|model| model.given_up)) {
            "; errors beyond ten times what is allowed (>) were not followed further"
        } else {
            ""
        }
    );
    out
}

/// What deciding cost, and whether that comes back.
fn decided(receipt: &Receipt) -> String {
    let worth = receipt
        .worth()
        .map_or_else(String::new, |runs| format!(", as long as {runs:.0} runs of the scene's own model"));
    let pays = match receipt.pays_from() {
        Some(1) => "it has paid with the first run".to_owned(),
        Some(run) => format!("it has paid from run {run} on"),
        None if receipt.worth().is_some() => "nothing is saved".to_owned(),
        None => "times were not taken, so that what is saved is not known".to_owned(),
    };
    format!("deciding took {} evaluations{worth}: {pays}", receipt.deciding)
}

/// What is lost, or more than how much.
fn error(model: Option<&Estimate>) -> String {
    model.map_or_else(
        || "-".to_owned(),
        |model| format!("{}{:.1e}", if model.given_up { "> " } else { "" }, model.first),
    )
}

fn told(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.1e}"))
}

/// Why a line has no run.
fn said(line: &Line) -> String {
    match line.verdict {
        Verdict::Suffices => "too inexact",
        Verdict::TooFar => "too far",
        Verdict::NotBelieved => "no estimate",
        Verdict::NotCarried => "not carried",
        Verdict::NotRun => "not run",
        Verdict::NotHeld => "left",
    }
    .to_owned()
}

fn object(title: &str, receipt: &Receipt) -> Value {
    let line = |line: &Line| {
        let model = line.model.as_ref().ok();
        let loss = match line.loss {
            Loss::Own => json!("own"),
            Loss::Nothing { claim } => json!({ "exact": true, "claim": claim }),
            Loss::Held { margin, at } => json!({ "exact": "while it lasts", "margin": margin, "at": at }),
            Loss::Small { parameter } => {
                json!({ "exact": false, "parameter": parameter, "value": model.and_then(|model| model.small) })
            }
        };
        json!({
            "model": line.name,
            "dropped": line.dropped,
            "loss": loss,
            "states": line.states,
            "estimate": model.map(|model| json!({
                "first": model.first,
                "second": model.second,
                "given_up": model.given_up,
                "outputs": receipt.watched.names.iter().cloned().zip(model.each.iter().map(|each| json!(each))).collect::<serde_json::Map<_, _>>(),
            })),
            "why_not": line.model.as_ref().err(),
            "verdict": line.choice.as_ref().map_or_else(|| said(line), |_| "suffices".to_owned()),
            "run": line.choice.as_ref().map(|choice| json!({
                "method": methods::written(choice.plan.method),
                "form": choice.plan.axes.to_string(),
                "tolerance": choice.plan.tolerance,
                "evaluations": choice.evaluations,
                "seconds": choice.seconds,
                "promised": choice.promised,
                "measured": choice.measured,
            })),
        })
    };
    json!({
        "title": title,
        "tolerance": receipt.tolerance,
        "outputs": receipt.watched.names,
        "taken": receipt.taken.map(|at| &receipt.lines[at].name),
        "saved": receipt.saved(),
        "deciding": { "evaluations": receipt.deciding, "own_runs": receipt.worth(), "pays_from_run": receipt.pays_from() },
        "models": receipt.lines.iter().map(line).collect::<Vec<_>>(),
    })
}

/// Error against evaluations of every model, each by the cheapest method for a tolerance: by the reference where one is kept,
/// else as promised.
fn picture(title: &str, models: &dyn Models, wish: &Wish, first: Receipt) -> WorkPrecision {
    let mut receipts = vec![first];
    for tolerance in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8] {
        let allowed = Duration::ZERO;
        receipts.extend(choose(models, &Wish { tolerance, allowed, outputs: wish.outputs.clone() }).ok());
    }
    let mut series: Vec<Method> = Vec::new();
    for receipt in &receipts {
        for line in &receipt.lines {
            let Some(choice) = &line.choice else { continue };
            let point = Point { work: choice.evaluations as f64, error: choice.measured.unwrap_or(choice.promised) };
            let name = line.name.replace('_', " ");
            match series.iter_mut().find(|known| known.name == name) {
                Some(known) => known.points.push(point),
                None => series.push(Method {
                    name: name.clone(),
                    family: name,
                    kinds: [format!("{} states", line.states), String::new()],
                    quiet: false,
                    points: vec![point],
                    failures: Vec::new(),
                }),
            }
        }
    }
    for one in &mut series {
        one.points.sort_by(|a, b| a.work.total_cmp(&b.work));
    }
    let all: Vec<Point> = series.iter().flat_map(|one| one.points.iter().copied()).collect();
    let places: Vec<(f64, f64)> = all.iter().map(|point| (point.work, point.error)).collect();
    WorkPrecision {
        title: format!("{title}: error against the cost of models"),
        x: Work::Evaluations,
        error: "error in the outputs".to_owned(),
        front: integrators::front(&places).into_iter().map(|at| all[at]).collect(),
        series,
        note: String::new(),
    }
}
