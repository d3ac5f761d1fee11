//! `dalembert prove`: whether every principle gives a system the same equations of motion.

use crate::arguments::Format;
use crate::ending::{Ending, print};
use ::scenes::read_model;
use clap::Args;
use model::principles::Principle;
use model::{Agreement, Trace, agreement};
use serde_json::json;
use std::path::PathBuf;

/// Which system is to be proved.
#[derive(Args, Debug)]
pub struct Asked {
    /// A file with `[coordinates]`; values of parameters are not needed
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// A principle beside the first one.
struct Row {
    principle: Principle,
    /// Why it does not apply, otherwise.
    agreement: Result<Agreement, String>,
}

/// Compares the residuals of every principle with those of the first, parameters as letters, and prints a verdict for each.
pub fn prove(asked: &Asked) -> Result<Ending, Ending> {
    let model = read_model(&asked.scene)?;
    let [first, others @ ..] = Principle::ALL;
    let rows: Vec<Row> = symbolic::apart(|| {
        let trace = Trace::of(&model);
        let row = |principle| Row {
            principle,
            agreement: agreement(&trace, first, principle).map_err(|why| why.to_string()),
        };
        others.into_iter().map(row).collect()
    });
    print(&match asked.format {
        Format::Text => text(first, &rows),
        Format::Json => format!("{:#}\n", object(first, &rows)),
    })?;
    let sound = |row: &Row| !matches!(row.agreement, Ok(Agreement::Refuted { .. } | Agreement::Undecided { .. }));
    Ok(if rows.iter().all(sound) { Ending::Done } else { Ending::Stopped })
}

fn text(first: Principle, rows: &[Row]) -> String {
    let line = |Row { principle, agreement }: &Row| {
        let verdict = match agreement {
            Ok(agreement) => agreement.to_string(),
            Err(why) => format!("does not apply: {why}"),
        };
        format!("{} = {}: {verdict}\n", first.name(), principle.name())
    };
    rows.iter().map(line).collect()
}

fn object(first: Principle, rows: &[Row]) -> serde_json::Value {
    let row = |Row { principle, agreement }: &Row| {
        let (verdict, error) = match agreement {
            Ok(Agreement::Proved { .. }) => ("proved", None),
            Ok(Agreement::Identified { error, .. }) => ("identified", Some(*error)),
            Ok(Agreement::Refuted { .. }) => ("refuted", None),
            Ok(Agreement::Undecided { .. }) => ("undecided", None),
            Err(_) => ("does not apply", None),
        };
        let said = agreement.as_ref().map_or_else(Clone::clone, ToString::to_string);
        json!({ "principles": [first.name(), principle.name()], "verdict": verdict, "log2_error": error, "said": said })
    };
    rows.iter().map(row).collect()
}
