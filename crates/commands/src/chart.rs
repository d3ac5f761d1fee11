//! `dalembert chart`: the accuracy and the speed of all methods on one scene, in all formulations and with all models.

use crate::arguments::Format;
use crate::exit::{Exit, print};
use crate::output::{Form, Maker, Output, Provenance, Writes};
use crate::reference::following;
use crate::report;
use crate::run::{one_form, refuse, with_model};
use crate::speed::{advice::advice, family, model, pictures, tables};
use crate::{clock, csv};
use charts::{Table, WorkPrecision};
use clap::ValueEnum;
use integrators::{Failure, Point};
use reader::Family;
use serde_json::{Value, json};
use simulation::models::Modelled;
use simulation::references::Unknown;
use simulation::work_precision::Hybrid;
use simulation::work_precision::judged_across_events;
use simulation::work_precision::{Configuration, Formulation};
use simulation::{Atlas, Axes, IvpScene, Stored, Trajectory, Trials, judged, references};
use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use studies::AnyScene;
use studies::model_reduction::Hierarchy;
use studies::scene::Setup;

/// Arguments of `chart`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The file of the chart: error against evaluations as .svg; as .html also error against time; as .csv every run as a table
    #[arg(long, value_name = "FILE.svg|FILE.html|FILE.csv")]
    pub out: Option<PathBuf>,
    /// Replaces the file of --out even if `chart` did not write it
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Output format: text for readers, or JSON with one object for each run
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    /// The unit of the horizontal axis; the default is evaluations
    #[arg(long, value_enum, requires = "out")]
    pub x: Option<Axis>,
    /// Replaces the motor by another model; its data are computed from the scene
    #[arg(long)]
    pub model: Option<String>,
    /// For gyrostats: the equations in the principal axes of A (first) or of A* (second)
    #[arg(long)]
    pub form: Option<Axes>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Axis {
    /// An integer, the same on every computer
    Evaluations,
    /// Time as a ratio to the fastest run
    Time,
}

/// Runs every method, prints the tables, and draws the requested chart. The reference may take a third of the time, the
/// runs another third, and the measurement of times a part of the rest.
pub fn chart(asked: &Args) -> Result<Exit, Exit> {
    let scene = match AnyScene::open(&asked.scene)? {
        AnyScene::Driven(scene) => {
            AnyScene::Driven(Box::new(with_model(*scene, asked.model.as_deref(), &asked.scene)?))
        }
        other => other,
    };
    let smooth = scene.smooth();
    match &scene {
        AnyScene::Model(_) => {
            refuse("a system without a motor", asked.model.is_some(), asked.form.is_some(), &asked.scene)?;
        }
        AnyScene::Driven(scene) => one_form(scene, asked.form.is_some(), &asked.scene)?,
    }
    let output = output(asked)?;
    let kept = Stored::beside(&asked.scene);
    match measured(&scene, asked.form, kept.as_ref(), clock::left) {
        Ok(atlas) => told(smooth.title(), &atlas, asked, output, |work| report::of_scene(smooth, &atlas, work)),
        Err(why) => {
            print(&format!("{}\n\n{why}", smooth.title()))?;
            Ok(Exit::Stopped)
        }
    }
}

/// The errors of all methods on a scene against its reference; `left` returns the remaining time.
///
/// # Errors
/// The reason for which there is no reference, as one or more lines.
fn measured(
    scene: &AnyScene,
    form: Option<Axes>,
    kept: Option<&Stored>,
    left: impl Fn() -> Duration,
) -> Result<Atlas, String> {
    let smooth = scene.smooth();
    let allowed = left() / 3;
    let trials = Trials { allowed, ..Trials::default() }.with(smooth.run().method);
    if let Some(hybrid) = smooth.hybrid() {
        return across_events(hybrid, &trials, kept, left);
    }
    let problem = smooth.problem(form.unwrap_or_default());
    let mut ways = smooth.ways();
    // reduced models run directly after the scene's own model, since other formulations may use up the time
    let models = smaller(scene, &ways);
    ways.splice(1..1, models);
    ways.retain(|way| form.is_none_or(|form| written_in(way, form)));
    // methods are compared up to the end of the motion: the law may end before the span does
    let run = problem.simulate(&following(smooth.run().choice()), |_| ());
    if run.left.is_some() || run.ends_before(problem.span) {
        let ends = || format!("the run ends at t = {} s, before its span", run.outcome.time);
        return Err(no_reference(smooth, &run, &run.stopped().unwrap_or_else(ends)));
    }
    match judged(&|reference| smooth.observed(reference), &problem, ways, &trials, kept, allowed) {
        Ok(mut atlas) => {
            atlas.take_times(&trials, left() / 2);
            Ok(atlas)
        }
        Err(failure) => Err(no_reference(smooth, &run, &with_share(&failure))),
    }
}

/// The errors of all methods on a scene with events; each method locates the events itself.
fn across_events(
    scene: &dyn Hybrid,
    trials: &Trials,
    kept: Option<&Stored>,
    left: impl Fn() -> Duration,
) -> Result<Atlas, String> {
    match judged_across_events(scene, trials, kept, trials.allowed) {
        Ok(mut atlas) => {
            atlas.take_times(trials, left() / 2);
            Ok(atlas)
        }
        Err(Unknown::Failed(failure)) => Err(format!("no reference: {}\n", with_share(&failure))),
        Err(other) => Err(format!("no reference: {other}\n")),
    }
}

/// The results of all methods: as text, as a JSON object, and as two SVG pictures (error over evaluations, error over time).
#[derive(Debug)]
pub struct Charted {
    pub text: String,
    pub object: Value,
    pub pictures: [String; 2],
}

/// The errors and costs of all methods on a system that is defined in its file; `left` returns the remaining time.
///
/// # Errors
/// The reason for which there is no reference.
pub fn charted(scene: &Arc<dyn Modelled>, left: impl Fn() -> Duration) -> Result<Charted, String> {
    let title = scene.title().to_owned();
    let atlas = measured(&AnyScene::Model(Arc::clone(scene)), None, None, left)?;
    let pictures = pictures::work_precision(&atlas).map(|mut picture| {
        picture.title.clone_from(&title);
        picture.svg()
    });
    Ok(Charted { text: text(&title, &atlas), object: object(&title, &atlas), pictures })
}

/// Prints the results, and writes the requested picture, page or table.
fn told(
    title: &str,
    atlas: &Atlas,
    asked: &Args,
    output: Option<Output>,
    page: impl FnOnce(Vec<WorkPrecision>) -> String,
) -> Result<Exit, Exit> {
    print(&match asked.format {
        Format::Text => text(title, atlas),
        Format::Json => format!("{:#}\n", object(title, atlas)),
    })?;
    if let Some(output) = output {
        let drawn = drawn(title, atlas, asked, output.form(), page);
        output.write_text(&drawn)?.tell(asked.format)?;
    }
    Ok(Exit::Done)
}

/// The reason for which there is no reference; where its time was over, the message explains which fraction of the time limit it had.
fn with_share(failure: &Failure) -> String {
    match failure {
        Failure::OutOfTime { .. } => {
            format!("{failure}; a third of the time is for the reference, and more time is given by --seconds")
        }
        _ => failure.to_string(),
    }
}

fn no_reference(scene: &dyn IvpScene, run: &Trajectory, reason: &str) -> String {
    let told = scene.told(&following(scene.run().choice()), run);
    let mut diagnosis = told.diagnosis.map_or_else(String::new, |diagnosis| format!("{diagnosis}\n"));
    for failure in &told.failures {
        diagnosis += &format!("failure: {failure}\nremedy: {}\n", failure.remedy);
    }
    format!("no reference: {reason}\n{diagnosis}")
}

/// The reduced models of the scene that are not models of the motor with a name of their own, such as quasi-steady currents.
fn smaller(scene: &AnyScene, known: &[Configuration]) -> Vec<Configuration> {
    let (ladder, formulation) = match scene {
        AnyScene::Driven(scene) if matches!(scene.system, Setup::Bench { .. }) => {
            (Hierarchy::of_scene(scene, Axes::First), Formulation::Bench)
        }
        AnyScene::Driven(scene) => (Hierarchy::of_scene(scene, Axes::First), Formulation::First),
        AnyScene::Model(scene) => {
            let own = known.first().map_or(Formulation::Minimal, |way| way.formulation);
            (Hierarchy::of_model(&**scene), own)
        }
    };
    let mut ways = Arc::new(ladder).ways(formulation);
    ways.retain(|way| known.iter().all(|known| known.model != way.model));
    ways
}

fn written_in(way: &Configuration, form: Axes) -> bool {
    match way.formulation {
        Formulation::First => form == Axes::First,
        Formulation::Second => form == Axes::Second,
        other => other == Formulation::Bench,
    }
}

/// The headings of the table of runs.
const COLUMNS: [&str; 8] =
    ["formulation", "model", "method", "tolerance [1]", "evaluations", "time [s]", "error [1]", "failure"];

/// The destination of the chart, checked before the runs.
fn output(asked: &Args) -> Result<Option<Output>, Exit> {
    let kept = references::place(&asked.scene);
    let writes = Writes { command: "chart", force: asked.force, reads: vec![&asked.scene, &kept] };
    let output =
        writes.optional(asked.out.as_deref(), &[Form::Picture, Form::Page, Form::Table(csv::line(&COLUMNS))])?;
    match &output {
        Some(output) if asked.x.is_some() && *output.form() != Form::Picture => Err(Exit::refused(format!(
            "--x does not apply to a {}: it says what the work of one picture is counted in, and is accepted with a name that \
             ends in .svg",
            output.form().said()
        ))),
        _ => Ok(output),
    }
}

/// The content of the file: a page, a table of all runs, or one picture.
fn drawn(
    title: &str,
    atlas: &Atlas,
    asked: &Args,
    form: &Form,
    page: impl FnOnce(Vec<WorkPrecision>) -> String,
) -> String {
    let [counted, timed] = pictures::work_precision(atlas);
    let provenance = Provenance::of(Maker("chart"), &asked.scene);
    match form {
        Form::Page => page(vec![counted, timed]),
        Form::Table(_) => provenance.comment("#") + &runs(atlas),
        Form::Picture
        | Form::Reference
        | Form::Certificates
        | Form::Unit
        | Form::Program(_)
        | Form::Archive
        | Form::Rows(_) => {
            let mut chart = match asked.x {
                None | Some(Axis::Evaluations) => counted,
                Some(Axis::Time) => timed,
            };
            chart.title = title.to_owned();
            provenance.markup() + &chart.svg()
        }
    }
}

/// The table of all runs as CSV, with one row for each run.
fn runs(atlas: &Atlas) -> String {
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:e}"));
    let row = |(way, point): (&Configuration, &Point)| {
        csv::line(&[
            way.formulation.to_string(),
            way.model.to_owned(),
            point.means.to_string(),
            number(point.tolerance),
            point.evaluations.to_string(),
            number(point.time.map(|time| time.seconds)),
            number(point.error.as_ref().ok().copied()),
            point.error.as_ref().err().map_or("", Failure::name).to_owned(),
        ])
    };
    let rows = std::iter::once(csv::line(&COLUMNS)).chain(atlas.points().map(row));
    rows.map(|row| row + "\n").collect()
}

/// The JSON object with the reference and all runs.
fn object(title: &str, atlas: &Atlas) -> Value {
    let run = |(way, point): (&Configuration, &Point)| {
        json!({
            "formulation": way.formulation.to_string(), "model": way.model, "method": point.means.to_string(),
            "tolerance": point.tolerance, "evaluations": point.evaluations, "seconds": point.time.map(|time| time.seconds),
            "error": point.error.as_ref().ok(), "failure": point.error.as_ref().err().map(Failure::name),
        })
    };
    let reference = &atlas.reference;
    let said = [1e-3, 1e-6, 1e-9].map(|error| json!({ "error": error, "says": advice(atlas, error) }));
    json!({
        "title": title,
        "reference": { "methods": reference.methods.map(|method| method.to_string()), "digits": reference.digits },
        "advice": said,
        "runs": atlas.points().map(run).collect::<Vec<_>>(),
    })
}

/// The Pareto fronts, the models, and one line for each run of the scene's first formulation with its own model.
fn text(title: &str, atlas: &Atlas) -> String {
    let reference = &atlas.reference;
    let mut text = format!(
        "{title}\n\nreference: {} and {} agree to {:.1} digits\n{}\n",
        reference.methods[0],
        reference.methods[1],
        reference.digits,
        [1e-3, 1e-6, 1e-9].map(|error| advice(atlas, error)).join("\n")
    );
    let models = tables::models(atlas);
    for table in tables::fronts(atlas).iter().chain((!models.rows.is_empty()).then_some(&models)) {
        text += &set(table);
    }
    let Some(own) = atlas.explored.first() else { return text };
    let mut points: Vec<_> = own.points.iter().collect();
    // the sort is stable, so that the tolerances or numbers of steps of one method keep their order
    points.sort_by_key(|point| family(point.means));
    let row = |point: &&Point| {
        let error = point.error.as_ref();
        vec![
            point.means.to_string(),
            point.tolerance.map_or_else(String::new, |tolerance| format!("{tolerance:.0e}")),
            point.evaluations.to_string(),
            point.time.map_or_else(String::new, |time| format!("{:.3}", time.seconds * 1e3)),
            error.map_or_else(|failure| failure.name().to_owned(), |error| format!("{error:.1e}")),
        ]
    };
    let with = if own.way.model.is_empty() { String::new() } else { format!(", {}", model(&own.way)) };
    text + &set(&Table {
        caption: format!("Every run {}{with}", own.way.formulation.said()),
        head: ["method", "tolerance", "evaluations", "time, ms", "error"].map(str::to_owned).to_vec(),
        rows: points.iter().map(row).collect(),
    })
}

/// A table of texts with aligned columns.
fn set(table: &Table) -> String {
    let widths: Vec<usize> = (0..table.head.len())
        .map(|column| {
            let cells = table.rows.iter().chain([&table.head]).filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        })
        .collect();
    let mut text = format!("\n{}\n", table.caption);
    for row in std::iter::once(&table.head).chain(&table.rows) {
        let line = row.iter().zip(&widths).fold(String::new(), |mut line, (cell, width)| {
            // writing to a string cannot fail
            let _ = write!(line, "{cell:<width$}  ");
            line
        });
        text += line.trim_end();
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::with_share;
    use integrators::Failure;

    #[test]
    fn a_reference_without_time_is_told_its_share() {
        let told = with_share(&Failure::OutOfTime { at: 3.0 });
        assert!(
            told.ends_with("; a third of the time is for the reference, and more time is given by --seconds"),
            "{told}"
        );
        assert_eq!(with_share(&Failure::Singular { at: 3.0 }), Failure::Singular { at: 3.0 }.to_string());
    }
}
