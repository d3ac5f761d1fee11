//! `dalembert prove`: proofs that all principles give the same equations of motion of a system, and proofs of conservation laws.

use crate::arguments::Format;
use crate::exit::{Exit, is_quiet, print, warn};
use ::scenes::SystemText;
use clap::ValueEnum;
use model::{Agreement, Judgement, Mistake, Model, Subject, Trace, Work, forming, judged_mistake, judgements};
use serde_json::json;
use std::path::PathBuf;

/// Arguments of `prove`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// A file with `[coordinates]`; values of parameters are not needed
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Derives the equations with a known mistake instead, and prints the terms that are then missing
    #[arg(long, value_enum)]
    pub mistake: Option<MistakeName>,
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum MistakeName {
    /// Constraints of speeds are inserted into the kinetic energy before Lagrange's derivatives are formed
    ConstraintsInEnergy,
    /// The energy of accelerations is formed from the kinetic energy by replacing speeds by accelerations
    AccelerationsInEnergy,
}

impl From<MistakeName> for Mistake {
    fn from(name: MistakeName) -> Self {
        match name {
            MistakeName::ConstraintsInEnergy => Mistake::ConstraintsInEnergy,
            MistakeName::AccelerationsInEnergy => Mistake::AccelerationsInEnergy,
        }
    }
}

/// Compares the residuals of each principle with those of the first one, with parameters as letters, judges the conservation laws, and
/// prints a verdict for each.
pub fn prove(asked: &Args) -> Result<Exit, Exit> {
    let model = SystemText::read(&asked.scene)?.for_judgement()?;
    let mistake = asked.mistake.map(Mistake::from);
    tell_of_forming(&model);
    let rows: Vec<Judgement> = symbolic::apart(|| {
        let trace = Trace::of(&model).heard_by(tell);
        match mistake {
            Some(mistake) => vec![judged_mistake(&trace, mistake)],
            None => judgements(&trace),
        }
    });
    print(&match asked.format {
        Format::Text => {
            let mut known = Vec::new();
            rows.iter().map(|row| text(row, &mut known)).collect()
        }
        Format::Json => format!("{:#}\n", rows.iter().map(object).collect::<serde_json::Value>()),
    })?;
    let fails = |row: &Judgement| row.fails() || mistake.is_some() && row.agreement.is_err();
    Ok(if rows.iter().any(fails) { Exit::Stopped } else { Exit::Done })
}

/// The expected time in seconds above which a comparison is announced.
const SHORT: f64 = 0.2;

/// Announces a long derivation of equations with its expected time and memory.
fn tell_of_forming(model: &Model) {
    let (seconds, bytes) = forming(model);
    if seconds > SHORT && !is_quiet() {
        warn(&format!("equations by every principle: about {seconds:.1} s and {:.0} MB", bytes / 1e6));
    }
}

/// Announces a long comparison.
fn tell(work: &Work) {
    if work.seconds() > SHORT && !is_quiet() {
        warn(&work.to_string());
    }
}

/// The largest length in characters of a list of divisors that is repeated in each line; a longer list is written once.
const MOST_REPEATED: usize = 100;

/// The line of a judgement. `known` contains the lists of divisors of earlier lines, each with the title of its line.
fn text(row: &Judgement, known: &mut Vec<(Vec<String>, String)>) -> String {
    let behind = row.behind.iter().map(|line| format!("    {line}\n"));
    let mut said = row.said();
    if let Ok(agreement @ Agreement::Proved { divisors, .. }) = &row.agreement
        && divisors.iter().map(String::len).sum::<usize>() > MOST_REPEATED
    {
        match known.iter().find(|(list, _)| list == divisors) {
            Some((_, line)) => said = agreement.said_behind(line),
            None => known.push((divisors.clone(), row.title())),
        }
    }
    let title = match (&row.subject, &row.agreement) {
        (Subject::Mistake { says, .. }, Err(why)) => format!("This mistake does not apply ({says}): {why}"),
        _ => format!("{}: {said}", row.title()),
    };
    format!("{title}\n{}", behind.collect::<String>())
}

fn object(row: &Judgement) -> serde_json::Value {
    let error = match &row.agreement {
        Ok(Agreement::Identified { error, .. } | Agreement::Theorem { error, .. }) => Some(*error),
        _ => None,
    };
    let mut object = json!({ "verdict": row.degree(), "log2_error": error, "said": row.said(), "behind": row.behind });
    match &row.subject {
        Subject::Principles(names) => object["principles"] = json!(names),
        Subject::InQuasiVelocities { principles, speeds } => {
            object["principles"] = json!(principles);
            object["quasi_velocities"] = json!(speeds);
        }
        Subject::Statement { about, says } => {
            object["about"] = json!(about);
            object["says"] = json!(says);
        }
        Subject::Mistake { mistake, says } => {
            object["mistake"] = json!(mistake.name());
            object["says"] = json!(says);
        }
    }
    object
}
