//! `dalembert choose`: the cheapest model and method that meet a tolerance in selected outputs, with a receipt of the decision.

mod command;
mod picture;
mod receipt;

use crate::arguments::{Format, tolerance};
use crate::clock;
use crate::exit::{Exit, print};
use crate::output::{Form, Writes};
use crate::run::{refuse, with_model};
use reader::Family;
use serde_json::Value;
use simulation::models::Modelled;
use simulation::{Axes, Choice, RunFailure, Stored, references};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use studies::AnyScene;
use studies::model_reduction::{Forms, Hierarchy, Models, Receipt, TextModels, Wish, choose};
use studies::scene::Setup;

/// Arguments of `choose`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Largest error allowed, relative to the size of each output
    #[arg(long = "tol", value_name = "T", value_parser = tolerance, allow_negative_numbers = true, default_value = "1e-6")]
    pub tolerance: f64,
    /// The outputs that must meet the tolerance, by the names of a run's columns. The default is the `outputs` of [run], or all columns if
    /// [run] names none; the answer lists them
    #[arg(long, value_name = "A,B", value_delimiter = ',')]
    pub outputs: Vec<String>,
    /// The model to compare with: another model of the motor, made of the scene's data
    #[arg(long)]
    pub model: Option<String>,
    /// The file of a chart: error against the cost of every model
    #[arg(long, value_name = "FILE.svg")]
    pub out: Option<PathBuf>,
    /// Replaces the file of --out even if `choose` did not write it
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Also measures times, alternately for three seconds, and searches for segments of the run on which a reduced model of a motor
    /// is accurate enough; the choice itself always uses counted work
    #[arg(long)]
    pub times: bool,
    /// Output format of the result; JSON has null for a number that is not defined
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// The time for measuring times, which are reported only, and again for finding instants at which to switch between models.
const MEASURING: Duration = Duration::from_secs(3);

/// Chooses a model and a method, prints the receipt, and draws the requested picture.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    let scene = match AnyScene::open(&asked.scene)? {
        AnyScene::Driven(scene) => {
            AnyScene::Driven(Box::new(with_model(*scene, asked.model.as_deref(), &asked.scene)?))
        }
        other => other,
    };
    let (models, given): (Box<dyn Models>, Vec<String>) = match &scene {
        AnyScene::Driven(scene) => {
            let axes = if matches!(scene.system, Setup::Bench { .. }) { &AXES[..1] } else { &AXES[..] };
            let ladders = axes.iter().map(|axes| Hierarchy::of_scene(scene, *axes)).collect();
            (Box::new(Forms::of(ladders, Stored::beside(&asked.scene))), scene.run.outputs.clone())
        }
        AnyScene::Model(scene) => {
            refuse("a system that is written in its file", asked.model.is_some(), false, &asked.scene)?;
            (Box::new(TextModels::of(scene, Stored::beside(&asked.scene))), scene.run().outputs.clone())
        }
    };
    let title = scene.title();
    let (outputs, origin) = outputs(asked, given, models.columns())?;
    let own = match &scene {
        AnyScene::Model(scene) => Some(&**scene),
        AnyScene::Driven(_) => None,
    };
    let allowed = if asked.times { MEASURING.min(clock::left() / 8) } else { Duration::ZERO };
    let wish = Wish { tolerance: asked.tolerance, outputs, allowed };
    let kept = references::place(&asked.scene);
    let writes = Writes { command: "choose", force: asked.force, reads: vec![&asked.scene, &kept] };
    let output = writes.optional(asked.out.as_deref(), &[Form::Picture])?;
    let receipt = match decided(&*models, &wish, own) {
        Ok(receipt) => receipt,
        Err(why) => {
            print(&format!("{title}\n\n{why}\n"))?;
            return Ok(Exit::Stopped);
        }
    };
    let command = receipt.taken.and_then(|at| {
        let formed = matches!(scene, AnyScene::Driven(_));
        command::of(&asked.scene, asked.model.as_deref(), at, &receipt.lines[at], formed)
    });
    print(&match asked.format {
        Format::Text => receipt::text(title, (&receipt, origin), command.as_deref()),
        Format::Json => format!("{:#}\n", receipt::object(title, (&receipt, origin), command.as_deref())),
    })?;
    if let Some(output) = output {
        output.write_text(&picture::of(title, &*models, &wish, receipt.clone()).svg())?.tell(asked.format)?;
    }
    Ok(if receipt.taken.is_some() { Exit::Done } else { Exit::Stopped })
}

/// The receipt of the choice among models.
///
/// # Errors
/// The reason for which nothing can be chosen, as a sentence.
fn decided(models: &dyn Models, wish: &Wish, own: Option<&dyn Modelled>) -> Result<Receipt, String> {
    let receipt = choose(models, wish).map_err(|why| format!("nothing can be chosen: {why}"))?;
    match own.and_then(|scene| missed(scene, &receipt)) {
        None => Ok(receipt),
        Some(failure) => Err(format!(
            "nothing can be chosen: the run that meets the tolerance has missed something at t = {:.9} s: {}; {}",
            failure.at, failure.evidence, failure.remedy
        )),
    }
}

/// The receipt of a choice: as text, as a JSON object, and as an SVG picture.
#[derive(Debug)]
pub struct ChosenModel {
    pub text: String,
    pub object: Value,
    pub picture: String,
}

/// The cheapest model and method that compute the given outputs of a system to a tolerance; all columns where `outputs` is empty.
///
/// # Errors
/// An output is unknown, or nothing can be chosen.
pub fn chosen_model(scene: &Arc<dyn Modelled>, tolerance: f64, outputs: Vec<String>) -> Result<ChosenModel, String> {
    let models = TextModels::of(scene, None);
    let (outputs, origin) = watched(&outputs, scene.run().outputs.clone(), models.columns(), ORIGINS)?;
    let wish = Wish { tolerance, outputs, allowed: Duration::ZERO };
    let (title, receipt) = (scene.title(), decided(&models, &wish, Some(&**scene))?);
    Ok(ChosenModel {
        text: receipt::text(title, (&receipt, origin), None),
        object: receipt::object(title, (&receipt, origin), None),
        picture: picture::of(title, &models, &wish, receipt).svg(),
    })
}

/// A failure of the chosen run of the scene's own model that no error estimate shows, such as a pulse that falls between two steps.
fn missed(scene: &dyn Modelled, receipt: &Receipt) -> Option<RunFailure> {
    let plan = &receipt.lines.get(receipt.taken.filter(|at| *at == 0)?)?.choice.as_ref()?.plan;
    let choice = Choice { method: plan.method, tolerance: plan.tolerance, ..scene.run().choice() };
    let trajectory = scene.problem(choice.axes).simulate_while(&choice, |_| clock::goes_on());
    let failures = scene.told(&choice, &trajectory).failures;
    failures.into_iter().find(|failure| failure.kind.spoils())
}

const AXES: [Axes; 2] = [Axes::First, Axes::Second];

/// Descriptions of the three possible origins of the outputs: all columns, `outputs` of the scene, the command line.
type Origins = [&'static str; 3];

const ORIGINS: Origins = ["all columns of the run", "as `outputs` of [run] names them", "as `outputs` names them"];
const ORIGINS_OF_OPTIONS: Origins = [
    "all columns of the run; --outputs names others",
    "as `outputs` of [run] names them; --outputs names others",
    "as --outputs names them",
];

fn outputs(asked: &Args, given: Vec<String>, known: &[String]) -> Result<(Vec<String>, &'static str), Exit> {
    watched(&asked.outputs, given, known, ORIGINS_OF_OPTIONS)
        .map_err(|why| Exit::refused(format!("{}: {why}", asked.scene.display())))
}

/// The outputs that must meet the tolerance, with a description of their origin: those `asked`, else those of the scene, else all states.
fn watched(
    asked: &[String],
    given: Vec<String>,
    known: &[String],
    [all, of_scene, named]: Origins,
) -> Result<(Vec<String>, &'static str), String> {
    // the column `work` of a run does not exist in reduced models
    if let Some(wrong) = asked.iter().find(|name| !known.contains(name) || *name == "work") {
        let known: Vec<&str> = known.iter().map(String::as_str).filter(|name| *name != "work").collect();
        return Err(format!("unknown output `{wrong}`; known: {}", known.join(", ")));
    }
    let state = |name: &&String| *name != "work";
    Ok(match (asked, &given[..]) {
        ([], []) => (known.iter().filter(state).cloned().collect(), all),
        ([], _) => (given, of_scene),
        (asked, _) => (asked.to_vec(), named),
    })
}
