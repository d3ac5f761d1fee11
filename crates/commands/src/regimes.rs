//! `dalembert regimes`: all consistent regimes of contacts and conditions at the start of a scene.

use crate::arguments::Format;
use crate::exit::{Exit, placed, print};
use ::scenes::{CriticalFriction, Motions, Regimes, Task, read_titled, regimes};
use model::Model;
use reader::Issue;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;

/// Arguments of `regimes`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a TOML file with contacts or conditions; the folders `scenes/friction` and `scenes/models` hold examples
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// Output format
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Prints the consistent regimes at the start of a scene.
pub fn show(asked: &Args) -> Result<Exit, Exit> {
    let (title, model) = read_titled(&asked.scene, Task::Run)?;
    let found = consistent_regimes(&title, model).map_err(|issue| placed(&asked.scene, issue))?;
    print(&match asked.format {
        Format::Text => found.text,
        Format::Json => format!("{:#}\n", found.object),
    })?;
    Ok(if found.is_determined { Exit::Done } else { Exit::Stopped })
}

/// The consistent regimes at the start, as text and as a JSON object.
#[derive(Debug)]
pub struct RegimesResult {
    pub text: String,
    pub object: Value,
    /// Whether the motion from the start is uniquely determined.
    pub is_determined: bool,
}

/// All regimes of the contacts and conditions of a model that are consistent at its start.
///
/// # Errors
/// The reason for which the model has no start that satisfies its constraints, or no regimes, with the place in the text.
pub fn consistent_regimes(title: &str, model: Model) -> Result<RegimesResult, Issue> {
    let answer = Answer::of(regimes(model)?);
    Ok(RegimesResult {
        text: format!("{title}\n{}", answer.text()),
        object: answer.object(title),
        is_determined: answer.determined,
    })
}

/// The consistent regimes at the start, with the verdict on the uniqueness of the motion.
struct Answer {
    regimes: Vec<Regime>,
    verdict: String,
    determined: bool,
    /// The critical coefficient of friction, up to which reactions are uniquely determined.
    critical: Option<CriticalFriction>,
}

/// A regime with the margins of its conditions.
struct Regime {
    name: String,
    margins: Vec<Margin>,
    reactions_determined: bool,
}

/// A condition on a contact, with the margin by which it is satisfied.
struct Margin {
    contact: String,
    condition: String,
    /// The distance from the limit of the condition, in `unit`; positive where the condition holds.
    value: f64,
    unit: &'static str,
}

impl Answer {
    fn of(found: Regimes) -> Self {
        let regimes = found.regimes.iter().map(|regime| Regime {
            name: regime.name.clone(),
            margins: (regime.margins.iter())
                .map(|margin| Margin {
                    contact: margin.of.clone(),
                    condition: margin.asks.to_owned(),
                    value: margin.value,
                    unit: margin.unit,
                })
                .collect(),
            reactions_determined: !regime.is_one_choice,
        });
        let verdict = match found.motions {
            Motions::One => "one motion",
            Motions::OneOnItsBoundary => "one motion, on the boundary of its regime",
            Motions::None => "no motion",
            Motions::Several => "several motions",
            Motions::Continuum => "infinitely many motions",
            Motions::NotTried => "not decided: more combinations of contacts and conditions than are tried",
        };
        let determined = matches!(found.motions, Motions::One | Motions::OneOnItsBoundary);
        let regimes = regimes.collect();
        Answer { regimes, verdict: verdict.to_owned(), determined, critical: found.critical }
    }

    fn text(&self) -> String {
        let mut text = String::new();
        // writing to a String cannot fail
        let width = self.regimes.iter().flat_map(|regime| &regime.margins).map(|margin| margin.contact.chars().count());
        let width = width.max().unwrap_or(0).max(8);
        for Regime { name, margins, reactions_determined } in &self.regimes {
            let _ = writeln!(text, "\n{name}");
            for Margin { contact, condition, value, unit } in margins {
                let line = format!("  {contact:<width$} {condition:<28} {value:>14.6} {unit}");
                let _ = writeln!(text, "{}", line.trim_end());
            }
            if !reactions_determined {
                let _ = writeln!(text, "  the reactions are not determined by the motion: these are possible ones");
            }
        }
        if let Some(CriticalFriction { factor, regime }) = &self.critical {
            let _ = writeln!(
                text,
                "\nfriction: below {factor:.6} times these coefficients the reactions of sliding contacts are unique for all loads; at this multiple they become singular in the regime\n  {regime}"
            );
        }
        let _ = writeln!(text, "\nverdict: {}", self.verdict);
        text
    }

    fn object(&self, title: &str) -> Value {
        let regimes = self.regimes.iter().map(|regime| {
            let margins = regime.margins.iter().map(
                |Margin { contact, condition, value, unit }| json!({ "contact": contact, "condition": condition, "margin": value, "unit": unit }),
            );
            json!({
                "regime": regime.name, "margins": margins.collect::<Vec<_>>(),
                "reactions_determined": regime.reactions_determined,
            })
        });
        json!({
            "title": title, "regimes": regimes.collect::<Vec<_>>(), "verdict": self.verdict, "determined": self.determined,
            "critical_friction": self.critical.as_ref().map(|found| json!({ "factor": found.factor, "regime": found.regime })),
        })
    }
}
