//! `dalembert regulate`: the linear-quadratic regulator of a system, its run on the nonlinear model, and the cost of the run compared with the
//! prediction by Riccati's equation.

mod told;

use crate::arguments::Format;
use crate::exit::{Exit, placed, print};
use crate::output::{Provenance, Writes};
use crate::progress::Progress;
use crate::{clock, csv};
use ::scenes::regulator::{ClosedRun, Regulated, loop_choice, regulated};
use ::scenes::{ModelScene, unit_of};
use reader::{Issue, read_text};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::time::Duration;
use told::Told;

/// Arguments of `regulate`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// A file with `[coordinates]` and `[regulator]`
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Writes the regulated motion as a table, each column with its unit: time, states, inputs, cost
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Replaces the file of --out even if `regulate` did not write it
    #[arg(long)]
    pub force: bool,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Computes the regulator, runs the closed loop and prints both.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    let path: &Path = &asked.scene;
    let text = read_text(path)?;
    let scene = ModelScene::parse(&path.display().to_string(), &text)?;
    let columns: Vec<String> =
        (columns(&scene).iter().map(|(name, unit)| csv::headed(name, unit))).chain(["cost".to_owned()]).collect();
    let writes = Writes { command: "regulate", force: asked.force, reads: vec![path] };
    let provenance = Provenance::of(writes.maker(), path).of_run(&loop_choice(&scene));
    let table = csv::Table::at(&writes, asked.out.as_deref(), &columns, provenance)?;
    let work = Progress::new("the regulator");
    let found = regulated(&scene, clock::left()).map_err(|issue| placed(path, issue))?;
    drop(work);
    let Regulated { run, .. } = &found;
    let rows: Vec<Vec<f64>> = (run.states.iter().zip(&run.inputs).zip(&run.costs))
        .map(|((state, inputs), cost)| [&state[..], inputs, &[*cost]].concat())
        .collect();
    let told = Told::of(&scene, &found);
    print(&match asked.format {
        Format::Text => told.text(),
        Format::Json => format!("{:#}\n", told.object()),
    })?;
    if let Some(row) = rows.last()
        && let Some(written) = table.write(&run.times, &rows, (run.outcome.time, row))?
    {
        written.tell(asked.format)?;
    }
    Ok(if stopped(run).is_some() { Exit::Stopped } else { Exit::Done })
}

/// An optimal regulator with the run of its closed loop, as text and as a JSON object.
#[derive(Debug)]
pub struct RegulatorResult {
    pub text: String,
    pub object: Value,
}

/// The optimal regulator of a scene, with a run of the closed loop; `allowed` limits the time of the run.
///
/// # Errors
/// The reason for which there is no regulator, with the place in the text.
pub fn regulator(scene: &ModelScene, allowed: Duration) -> Result<RegulatorResult, Issue> {
    let found = regulated(scene, allowed)?;
    let told = Told::of(scene, &found);
    Ok(RegulatorResult { text: told.text(), object: told.object() })
}

/// The states and the inputs of the regulated system, each with its unit.
fn columns(scene: &ModelScene) -> Vec<(String, String)> {
    let model = &*scene.model;
    let inputs = model.regulator.iter().flat_map(|regulator| &regulator.inputs);
    let inputs = inputs.map(|&input| model.inputs[input].name.clone());
    let names = model.state_names().into_iter().map(|(name, _)| name).chain(inputs);
    names.map(|name| (name.clone(), unit_of(model, &name))).collect()
}

/// The reason for which a run stopped before its end; `None` where it reached the end.
fn stopped(run: &ClosedRun) -> Option<String> {
    run.left.map(str::to_owned).or_else(|| run.outcome.failure().map(|failure| failure.to_string()))
}
