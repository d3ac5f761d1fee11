//! `dalembert inverse`: inverse dynamics, the forces under which a system that is defined in its file moves as prescribed.

use crate::arguments::{finite, whole};
use crate::csv;
use crate::exit::{Exit, print, warn};
use crate::progress::Progress;
use ::scenes::inverse::{AlongMotion, Forces, inverse};
use ::scenes::{SystemText, parse_prescribed, unit_of, unit_of_rate};
use clap::ValueEnum;
use reader::SceneError;
use serde_json::{Value, json};
use std::path::PathBuf;

/// Arguments of `inverse`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// A file with `[coordinates]`
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// A coordinate as an expression of the time and of parameters, such as "theta = 0.5*sin(w*t)"; a free frame by rotations, such as
    /// "F = w*t about z, then (10 deg) about x"; once for each degree of freedom. If the motion does not determine a current, prescribe it as well:
    /// "motor.i_f = (2 A)" or "id = 0"
    #[arg(long = "motion", value_name = "Q = EXPRESSION", required = true, value_parser = motion)]
    pub motions: Vec<(String, String)>,
    /// A parameter or an input that is unknown, such as a force; may be repeated
    #[arg(long = "unknown", value_name = "NAME")]
    pub unknowns: Vec<String>,
    /// The last instant, in seconds
    #[arg(long, value_name = "S", default_value = "1", value_parser = positive)]
    pub span: f64,
    /// Number of instants after the first
    #[arg(long, value_name = "N", default_value = "10", value_parser = whole::<u32>(1..=1_000_000))]
    pub samples: u32,
    /// Output format of the table
    #[arg(long, value_enum, default_value_t)]
    pub format: Form,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Form {
    #[default]
    Csv,
    Json,
}

fn motion(text: &str) -> Result<(String, String), String> {
    let parts = text.split_once('=').map(|(name, is)| (name.trim().to_owned(), is.trim().to_owned()));
    let parts = parts.filter(|(name, is)| !name.is_empty() && !is.is_empty());
    parts.ok_or_else(|| "a coordinate and an expression of t, such as \"theta = 0.5*sin(2*t)\", is accepted".to_owned())
}

fn positive(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value > 0.0 { Ok(value) } else { Err("a positive number of seconds is accepted".to_owned()) }
}

/// Prints the prescribed motion and the forces that produce it.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    let text = SystemText::read(&asked.scene)?;
    let times: Vec<f64> = (0..=asked.samples).map(|k| asked.span * f64::from(k) / f64::from(asked.samples)).collect();
    let wanted = Wanted { motions: &asked.motions, unknowns: &asked.unknowns, times: &times, called: "--motion" };
    let progress = Progress::new("inverse dynamics");
    let found = forces_along(&text, &wanted)?;
    drop(progress);
    for warning in &found.left_out {
        warn(&format!("warning: {}: {warning}", asked.scene.display()));
    }
    print(&match asked.format {
        Form::Json => format!("{:#}\n", found.object()),
        Form::Csv => found.table(),
    })?;
    Ok(Exit::Done)
}

/// A prescribed motion and the unknown forces.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// Names of coordinates, free frames and currents, each with an expression in the time.
    pub motions: &'a [(String, String)],
    /// The names of the unknown parameters and inputs; a repeated name counts once.
    pub unknowns: &'a [String],
    /// Instants in seconds, in ascending order.
    pub times: &'a [f64],
    /// The name of the prescribed motions in messages, such as `--motion`.
    pub called: &'a str,
}

/// The forces along a prescribed motion.
#[derive(Clone, Debug)]
pub struct ForceTable {
    /// Names of the columns with units: time, coordinates, speeds, accelerations, unknowns, multipliers of constraints.
    pub columns: Vec<(String, String)>,
    /// The values in SI units, one row for each instant.
    pub rows: Vec<Vec<f64>>,
    /// The names of the columns with unknowns, each once; `multipliers` are those with multipliers.
    pub unknowns: Vec<String>,
    pub multipliers: Vec<String>,
    /// Warnings about redundant constraints, whose multipliers are left out.
    pub left_out: Vec<String>,
}

/// The forces under which a system that is defined in a text moves as prescribed.
///
/// # Errors
/// All faults of the system and of the prescribed motions, or the reason for which no forces produce the motion.
pub fn forces_along(text: &SystemText, wanted: &Wanted<'_>) -> Result<ForceTable, SceneError> {
    let (model, prescribed) = parse_prescribed(text, wanted.motions, wanted.unknowns, wanted.called)?;
    let mut unknowns: Vec<String> = Vec::new();
    for name in wanted.unknowns {
        if !unknowns.contains(name) {
            unknowns.push(name.clone());
        }
    }
    let found = inverse(&model, &prescribed, &unknowns, wanted.times).map_err(|why| text.with_issue(why.at(&model)))?;
    let AlongMotion { forces, constraints, left_out, charges } = found;
    let with_unit = |name: &String| (name.clone(), unit_of(&model, name));
    let state: Vec<(String, String)> = model.state_names().iter().map(|(name, _)| with_unit(name)).collect();
    let speeds = &state[model.positions()..];
    // charges are left out, since each is the integral of its current from an arbitrary value
    let is_shown = |place: &usize| !charges.contains(place);
    let shown =
        |all: &[(String, String)]| (0..all.len()).filter(is_shown).map(|place| all[place].clone()).collect::<Vec<_>>();
    let columns: Vec<(String, String)> = std::iter::once(("time".to_owned(), "s".to_owned()))
        .chain(shown(&state))
        .chain(speeds.iter().map(|(name, unit)| (format!("{name}'"), unit_of_rate(unit))))
        .chain(unknowns.iter().map(with_unit))
        .chain(constraints.iter().map(|known| (known.multiplier(), known.unit.clone())))
        .collect();
    let row = |forces: &Forces| -> Vec<f64> {
        let Forces { time, coordinates, speeds, accelerations, unknowns, multipliers } = forces;
        let coordinates: Vec<f64> = (0..coordinates.len()).filter(is_shown).map(|place| coordinates[place]).collect();
        [&[*time][..], &coordinates, speeds, accelerations, unknowns, multipliers].concat()
    };
    let left_out = left_out.into_iter().map(|follows| format!("{}: it has no column", follows.title)).collect();
    let multipliers = constraints.iter().map(|known| known.multiplier()).collect();
    Ok(ForceTable { columns, rows: forces.iter().map(row).collect(), unknowns, multipliers, left_out })
}

impl ForceTable {
    fn object(&self) -> Value {
        let (names, units): (Vec<&String>, Vec<&String>) = self.columns.iter().map(|(name, unit)| (name, unit)).unzip();
        json!({ "columns": names, "units": units, "rows": self.rows })
    }

    fn table(&self) -> String {
        let line = |row: &Vec<f64>| row.iter().map(|value| format!("{value:?}")).collect::<Vec<_>>().join(",") + "\n";
        let heading: Vec<String> = self.columns.iter().map(|(name, unit)| csv::headed(name, unit)).collect();
        format!("{}\n{}", csv::line(&heading), self.rows.iter().map(line).collect::<String>())
    }
}
