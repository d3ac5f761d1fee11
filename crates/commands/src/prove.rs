//! `dalembert prove`: whether every principle gives a system the same equations of motion, and whether these keep what they should.

use crate::arguments::Format;
use crate::exit::{Exit, print};
use ::scenes::{Task, on_branch, read_model, start_of, starting, without_implied};
use clap::{Args, ValueEnum};
use model::principles::{Principle, Projection};
use model::{
    Agreement, Implied, Mistake, Mistaken, QuasiPrinciple, QuasiVelocities, Trace, agreement, mistaken,
    projected_agreement, quasi_agreement, shorter, statements, titles,
};
use serde_json::json;
use std::path::PathBuf;

/// Which system is to be proved.
#[derive(Args, Debug)]
pub struct Asked {
    /// A file with `[coordinates]`; values of parameters are not needed
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    /// A mistaken derivation in the place of all others: whether it is refuted, and the terms that it loses
    #[arg(long, value_enum)]
    pub mistake: Option<MistakeName>,
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum MistakeName {
    /// Constraints of speeds are put into the kinetic energy before Lagrange's derivatives are taken
    ConstraintsInEnergy,
    /// Appell's energy of accelerations is made of the kinetic energy by writing accelerations for speeds
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

/// A line: what is stated, and its verdict.
struct Row {
    /// The principles that are compared, or the quantity that a statement is about.
    subject: Subject,
    /// Why it does not apply, otherwise.
    agreement: Result<Agreement, String>,
    /// Grounds of the verdict: where it was decided, and the loss by a mistake.
    behind: Vec<String>,
    /// Whether the verdict must not be a refutation.
    must_hold: bool,
}

enum Subject {
    Principles([&'static str; 2]),
    /// In quasi-velocities, by their names.
    InQuasiVelocities {
        principles: [&'static str; 2],
        speeds: Vec<String>,
    },
    Statement {
        about: String,
        says: String,
    },
    Mistake {
        mistake: Mistake,
        says: String,
    },
}

/// Compares the residuals of every principle with those of the first, parameters as letters, states what the equations keep, and
/// prints a verdict for each.
pub fn prove(asked: &Asked) -> Result<Exit, Exit> {
    let mut model = read_model(&asked.scene, Task::Write)?;
    // of constraints that contradict each other there is no motion of which anything could be said
    without_implied(&asked.scene, &mut model.clone())?;
    // off the branch the constraints leave other motions
    on_branch(&mut model);
    if let Ok(state) = start_of(&model) {
        model = starting(&model, &state);
    }
    let mistake = asked.mistake.map(Mistake::from);
    let rows: Vec<Row> = symbolic::apart(|| {
        let trace = Trace::of(&model);
        match mistake {
            Some(mistake) => vec![of_mistake(&trace, mistake)],
            None => all(&trace),
        }
    });
    print(&match asked.format {
        Format::Text => {
            let mut known = Vec::new();
            rows.iter().map(|row| text(row, &mut known)).collect()
        }
        Format::Json => format!("{:#}\n", rows.iter().map(object).collect::<serde_json::Value>()),
    })?;
    let fails = |row: &Row| {
        let missed = matches!(row.agreement, Ok(Agreement::Refuted { .. } | Agreement::Undecided { .. }));
        row.must_hold && missed || mistake.is_some() && row.agreement.is_err()
    };
    Ok(if rows.iter().any(fails) { Exit::Stopped } else { Exit::Done })
}

fn all(trace: &Trace<'_>) -> Vec<Row> {
    let [first, others @ ..] = Principle::ALL;
    let plain = |principle: Principle| Row {
        subject: Subject::Principles([first.name(), principle.name()]),
        agreement: agreement(trace, first, principle).map_err(|why| why.to_string()),
        behind: Vec::new(),
        must_hold: true,
    };
    let projected = |projection: Projection| {
        let (agreement, behind) = match projected_agreement(trace, projection) {
            Ok(found) => (Ok(found.agreement), vec![found.points]),
            Err(why) => (Err(why.to_string()), Vec::new()),
        };
        let subject = Subject::Principles([first.name(), projection.name()]);
        let branches = trace.model.implied.iter().filter_map(on_its_branch);
        let behind = behind.into_iter().chain(branches).collect();
        Row { subject, agreement, behind, must_hold: true }
    };
    let axes = titles(trace);
    let along = |subject: String| match axes.iter().find(|(title, _)| *title == subject) {
        Some((_, along)) => along.clone(),
        None => subject,
    };
    let stated = statements(trace).into_iter().map(|statement| Row {
        subject: Subject::Statement { about: along(statement.subject), says: statement.says },
        agreement: Ok(statement.agreement),
        behind: Vec::new(),
        must_hold: true,
    });
    let mistake = of_mistake(trace, Mistake::ConstraintsInEnergy);
    let rows = others.into_iter().map(plain).chain(Projection::ALL.into_iter().map(projected));
    let rows = rows.chain(in_quasi_velocities(trace)).chain(stated);
    // nothing is said of a mistake that cannot be made
    rows.chain(mistake.agreement.is_ok().then_some(mistake)).collect()
}

/// An equation that is left out on the branch of the start.
fn on_its_branch(implied: &Implied) -> Option<String> {
    let start = implied.branch.as_ref()?;
    Some(format!("{} follows from the others on the branch of the start, {start}, and is left out", implied.title))
}

/// Whether the principles that use quasi-velocities agree in those of the file.
fn in_quasi_velocities(trace: &Trace<'_>) -> Vec<Row> {
    if trace.model.quasi_velocities.is_empty() {
        return Vec::new();
    }
    let speeds: Vec<String> = trace.model.quasi_velocities.iter().map(|speed| speed.name.clone()).collect();
    let quasi = QuasiVelocities::of(trace);
    let [first, others @ ..] = QuasiPrinciple::ALONG_ANY;
    let compared = |other: QuasiPrinciple| Row {
        subject: Subject::InQuasiVelocities { principles: [first.name(), other.name()], speeds: speeds.clone() },
        agreement: match &quasi {
            Ok(quasi) => quasi_agreement(quasi, first, other).map_err(|why| why.to_string()),
            // judged when the file was read
            Err(faults) => Err(faults.iter().map(|fault| fault.title.clone()).collect::<Vec<_>>().join("; ")),
        },
        behind: Vec::new(),
        must_hold: true,
    };
    others.into_iter().map(compared).collect()
}

/// Characters of the longest term that is written out.
const MOST_READ: usize = 400;

fn of_mistake(trace: &Trace<'_>, mistake: Mistake) -> Row {
    let (says, agreement, behind) = match mistaken(trace, mistake) {
        Ok(Mistaken { says, agreement, lost }) => {
            let lost = lost.into_iter().map(|(name, term)| {
                let term = shorter(trace, term);
                let operations = symbolic::Sym::operations_of(&[term]);
                // an expression has at least a character for each operation
                let written = (operations <= MOST_READ).then(|| term.to_string());
                let term = match written.filter(|written| written.len() <= MOST_READ) {
                    Some(written) => written,
                    None => format!("a term of {operations} operations"),
                };
                format!("lost in the equation of {name}: {term}")
            });
            (says, Ok(agreement), lost.collect())
        }
        Err(why) => (mistake.says().to_owned(), Err(why.to_string()), Vec::new()),
    };
    Row { subject: Subject::Mistake { mistake, says }, agreement, behind, must_hold: false }
}

impl Row {
    fn title(&self) -> String {
        match &self.subject {
            Subject::Principles([one, other]) => format!("{one} = {other}"),
            Subject::InQuasiVelocities { principles: [one, other], speeds } => {
                format!("{one} = {other} in {}", speeds.join(", "))
            }
            Subject::Statement { about, says } => format!("{about}: {says}"),
            Subject::Mistake { says, .. } => format!("mistake: {says}"),
        }
    }

    fn said(&self) -> String {
        match &self.agreement {
            Ok(agreement) => agreement.to_string(),
            Err(why) => format!("does not apply: {why}"),
        }
    }
}

/// Characters of a list of divisors that is written in each line; a longer one in the first line that has it.
const MOST_REPEATED: usize = 100;

/// A line, where lists of divisors are known from lines before it.
fn text(row: &Row, known: &mut Vec<(Vec<String>, String)>) -> String {
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
    format!("{}: {said}\n{}", row.title(), behind.collect::<String>())
}

fn object(row: &Row) -> serde_json::Value {
    let verdict = row.agreement.as_ref().map_or("does not apply", Agreement::rung);
    let error = match &row.agreement {
        Ok(Agreement::Identified { error, .. } | Agreement::Theorem { error, .. }) => Some(*error),
        _ => None,
    };
    let mut object = json!({ "verdict": verdict, "log2_error": error, "said": row.said(), "behind": row.behind });
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
