//! `dalembert linearise`: the linear equations of a system that is defined in its file, about a point or along its run.

mod boundaries;
mod crossings;
mod multipliers;
mod print;

use self::boundaries::AlongWhat;
use self::print::{Found, Headed, csv, object, text};
use crate::clock;
use crate::exit::{Exit, placed, warn};
use crate::named_value::named_value;
use crate::progress::Progress;
use ::scenes::linearisation::{NotLinear, Standing, VariedEquations, inputs_of, law_at_rest, point_of, points};
use ::scenes::steady_motions::{EnclosedSpectrum, NotEnclosed};
use ::scenes::{Given, ModelScene, Task, read_model, set_values, without_law};
use clap::ValueEnum;
use model::Model;
use reader::read_text;
use serde_json::json;
use std::borrow::Cow;
use std::path::PathBuf;

/// Arguments of `linearise`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// A file with `[coordinates]`
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// The point: the start of the file, or an equilibrium near it
    #[arg(long, value_enum, default_value_t)]
    pub about: About,
    /// Instants of the run in seconds, up to its end, instead of a point: 0,0.5,2
    #[arg(long, value_name = "T,T", value_delimiter = ',', value_parser = instant, allow_negative_numbers = true, conflicts_with = "about")]
    pub times: Vec<f64>,
    /// The period, in seconds, of the motion from the start of the file: prints the Floquet multipliers of this period instead of A, B, C, D
    #[arg(long, value_name = "T", value_parser = period, allow_negative_numbers = true, conflicts_with_all = ["about", "times", "inputs"])]
    pub period: Option<f64>,
    /// A parameter along which stability changes: exact boundaries by Routh's criterion. With a range, NAME=FROM..TO, of a parameter or of a
    /// coordinate or speed at the start: brackets of the values at which eigenvalues cross the imaginary axis, by enclosures
    #[arg(long, value_name = "NAME[=FROM..TO]", value_parser = boundaries::asked, conflicts_with_all = ["times", "inputs", "period"])]
    pub along: Option<boundaries::AlongWhat>,
    /// Another value, in SI units, for a parameter, or for a coordinate or a speed at the start; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = named_value)]
    pub values: Vec<(String, f64)>,
    /// A parameter that is an input, in addition to the inputs of the file; may be repeated
    #[arg(long = "input", value_name = "NAME")]
    pub inputs: Vec<String>,
    /// Format of the matrices; CSV has a line for each entry: time, matrix, row, column, value. The unit of an entry is that of its row over
    /// that of its column, and per second in A and B
    #[arg(long, value_enum, default_value_t)]
    pub format: Form,
}

impl Args {
    /// The scene of the file with the values of `--set`, ready to run.
    fn run(&self) -> Result<ModelScene, Exit> {
        let given = Given { values: self.values.clone(), ..Given::default() };
        Ok(ModelScene::parse_with(&self.scene.display().to_string(), &read_text(&self.scene)?, given)?)
    }
}

/// The point of linearisation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum About {
    /// The start of the file; values that it leaves out follow from the constraints
    #[default]
    Start,
    /// An equilibrium, found from the coordinates at the start; speeds in the file are ignored
    Equilibrium,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Form {
    #[default]
    Text,
    Json,
    Csv,
}

fn instant(text: &str) -> Result<f64, String> {
    let time = text.trim().parse().ok().filter(|time: &f64| time.is_finite() && *time >= 0.0);
    time.ok_or_else(|| "a time that is not negative, in seconds, such as 0.5 is accepted".to_owned())
}

fn period(text: &str) -> Result<f64, String> {
    let period = text.trim().parse().ok().filter(|period: &f64| period.is_finite() && *period > 0.0);
    period.ok_or_else(|| "a time above zero, in seconds, such as 0.5 is accepted".to_owned())
}

/// Prints the matrices, the eigenvalues and the verdict on stability.
pub fn linearise(asked: &Args) -> Result<Exit, Exit> {
    let refused = |why: String| Exit::refused(format!("{}: {why}", asked.scene.display()));
    if let Some(period) = asked.period {
        return multipliers::show(asked, period);
    }
    let mut model = read_model(&asked.scene, Task::Vary)?;
    set_values(&mut model, &asked.values).map_err(|why| refused(format!("--set: {why}")))?;
    // inputs without a value are zero at the point of linearisation
    model.close_inputs();
    let inputs = inputs_of(&mut model, &asked.inputs).map_err(refused)?;
    let whole = model.clone();
    let _progress = Progress::new("the linear equations");
    let instances = instances(&mut model, asked)?;
    match (&asked.along, &instances[..]) {
        (Some(AlongWhat { name, range: None }), [(_, state)]) => return boundaries::show(asked, &model, state, name),
        (Some(AlongWhat { name, range: Some(range) }), _) => return crossings::show(asked, &whole, name, *range),
        _ => {}
    }
    let equations_of = |model: &Model| {
        VariedEquations::of(model, &inputs)
            .map_err(|why| placed(&asked.scene, without_law(model, &why, "there are no linear equations")))
    };
    let equations = equations_of(&model)?;
    if !equations.feedback.is_empty() {
        let inputs: Vec<String> = equations.feedback.iter().map(|name| format!("`{name}`")).collect();
        warn(&format!(
            "warning: {}: A does not hold the feedback by {}: an input is held at its value at the point; a value that stands in the force itself is \
             part of A",
            asked.scene.display(),
            inputs.join(", ")
        ));
    }
    let mut all = Vec::with_capacity(instances.len());
    for (time, state) in instances {
        let no_linear = |why: NotLinear| placed(&asked.scene, why.at(&model, time));
        let linear = match law_at_rest(&model, &state) {
            Cow::Borrowed(_) => equations.about(time, &state),
            Cow::Owned(resting) => equations_of(&resting)?.about(time, &state),
        };
        let linear = linear.map_err(no_linear)?;
        let enclosed = match linear.standing {
            Standing::Moving if !equations.feedback.is_empty() => None,
            _ if !equations.feedback.is_empty() => Some(Err(NotEnclosed::Feedback)),
            standing => {
                let found = EnclosedSpectrum::near(&model, &state, || clock::goes_on().is_continue());
                // along a relative equilibrium the linear equations are constant once the cyclic coordinates are left out
                Some(found).filter(|found| found.is_ok() || standing != Standing::Moving)
            }
        };
        all.push(Found { linear, enclosed });
    }
    let names = Headed::of(&model, &equations);
    crate::exit::print(&match asked.format {
        Form::Text => all.iter().map(|found| text(&names, found)).collect::<Vec<_>>().join("\n"),
        Form::Json => {
            format!("{:#}\n", json!({ "points": all.iter().map(|found| object(&names, found)).collect::<Vec<_>>() }))
        }
        Form::Csv => csv(&names, &all),
    })?;
    Ok(Exit::Done)
}

/// The times of linearisation, each with its state.
fn instances(model: &mut Model, asked: &Args) -> Result<Vec<points::Instance>, Exit> {
    let refused = |why: String| Exit::refused(format!("{}: {why}", asked.scene.display()));
    if !asked.times.is_empty() {
        let scene = asked.run()?;
        if let Some(late) = asked.times.iter().find(|time| **time > scene.run.span) {
            return Err(refused(format!(
                "--times {late}: the run ends at t = {} s; times up to it are accepted, or a longer `span` in [run]",
                scene.run.span
            )));
        }
        model.implied.clone_from(&scene.model.implied);
        let along = points::along(&scene, &asked.times, clock::left());
        return along.map_err(|failure| refused(format!("the run does not reach these times: {failure}")));
    }
    let (instance, choice) =
        point_of(model, asked.about == About::Equilibrium).map_err(|issue| placed(&asked.scene, issue))?;
    if let Some(choice) = choice {
        warn(&format!("note: {}: {choice}", asked.scene.display()));
    }
    Ok(vec![instance])
}
