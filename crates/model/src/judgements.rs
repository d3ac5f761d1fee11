//! All checks of the equations of a model, each with its verdict.

use crate::agreement::{Agreement, agreement, projected_agreement};
use crate::parts::Implied;
use crate::presentation::{shorter, titles};
use crate::principles::{Principle, Projection};
use crate::quasi_velocities::{QuasiPrinciple, QuasiVelocities, quasi_agreement};
use crate::statements::{Mistake, Mistaken, mistaken, statements};
use crate::trace::Trace;
use symbolic::Sym;

/// A statement about the equations of a model, with its verdict.
#[derive(Clone, Debug)]
pub struct Judgement {
    pub subject: Subject,
    /// The verdict, or the reason why the statement does not apply to the model.
    pub agreement: Result<Agreement, String>,
    /// The grounds of the verdict: the points at which it was decided, or the terms that a mistake loses.
    pub behind: Vec<String>,
    /// Whether a refutation is an error of the program. It is not one for a mistaken derivation.
    pub must_hold: bool,
}

/// The subject of a statement.
#[derive(Clone, Debug)]
pub enum Subject {
    /// The equations of two principles are equal.
    Principles([&'static str; 2]),
    /// The equations of two principles in the named quasi-velocities are equal.
    InQuasiVelocities { principles: [&'static str; 2], speeds: Vec<String> },
    /// A statement about an energy, a momentum or a constraint.
    Statement { about: String, says: String },
    /// A derivation with a common mistake gives correct equations.
    Mistake { mistake: Mistake, says: String },
}

impl Judgement {
    /// Returns the statement in one line.
    pub fn title(&self) -> String {
        match &self.subject {
            Subject::Principles([one, other]) => format!("{one} = {other}"),
            Subject::InQuasiVelocities { principles: [one, other], speeds } => {
                format!("{one} = {other} in {}", speeds.join(", "))
            }
            Subject::Statement { about, says } => format!("{about}: {says}"),
            Subject::Mistake { says, .. } => format!("mistake: {says}"),
        }
    }

    /// Returns the verdict as a sentence.
    pub fn said(&self) -> String {
        match &self.agreement {
            Ok(agreement) => agreement.to_string(),
            Err(why) => format!("does not apply: {why}"),
        }
    }

    /// Returns the verdict as a word.
    pub fn degree(&self) -> &'static str {
        self.agreement.as_ref().map_or("does not apply", Agreement::degree)
    }

    /// Returns whether a statement that must hold is refuted or undecided.
    pub fn fails(&self) -> bool {
        let missed = matches!(self.agreement, Ok(Agreement::Refuted { .. } | Agreement::Undecided { .. }));
        self.must_hold && missed
    }
}

/// Checks a model: every principle against Lagrange's, the projections along independent rates, the principles in the quasi-velocities of the file, the
/// statements on integrals and constraints, and a common mistake.
pub fn judgements(trace: &Trace<'_>) -> Vec<Judgement> {
    let [first, others @ ..] = Principle::ALL;
    let plain = |principle: Principle| Judgement {
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
        Judgement { subject, agreement, behind, must_hold: true }
    };
    let axes = titles(trace);
    let along = |subject: String| match axes.iter().find(|(title, _)| *title == subject) {
        Some((_, along)) => along.clone(),
        None => subject,
    };
    let stated = statements(trace).into_iter().map(|statement| Judgement {
        subject: Subject::Statement { about: along(statement.subject), says: statement.says },
        agreement: Ok(statement.agreement),
        behind: Vec::new(),
        must_hold: true,
    });
    let mistake = judged_mistake(trace, Mistake::ConstraintsInEnergy);
    let rows = others.into_iter().map(plain).chain(Projection::ALL.into_iter().map(projected));
    let rows = rows.chain(in_quasi_velocities(trace)).chain(stated);
    // a mistake that is impossible in this model is not listed
    rows.chain(mistake.agreement.is_ok().then_some(mistake)).collect()
}

/// Returns a sentence on an equation that is redundant only on the branch of the start.
fn on_its_branch(implied: &Implied) -> Option<String> {
    let start = implied.branch.as_ref()?;
    Some(format!("{} follows from the others for positions near the start, {start}, and is left out", implied.title))
}

/// Checks that the principles that use quasi-velocities agree in the quasi-velocities of the file.
fn in_quasi_velocities(trace: &Trace<'_>) -> Vec<Judgement> {
    if trace.model.quasi_velocities.is_empty() {
        return Vec::new();
    }
    let speeds: Vec<String> = trace.model.quasi_velocities.iter().map(|speed| speed.name.clone()).collect();
    let quasi = QuasiVelocities::of(trace);
    let [first, others @ ..] = QuasiPrinciple::ALONG_ANY;
    let compared = |other: QuasiPrinciple| Judgement {
        subject: Subject::InQuasiVelocities { principles: [first.name(), other.name()], speeds: speeds.clone() },
        agreement: match &quasi {
            Ok(quasi) => quasi_agreement(quasi, first, other).map_err(|why| why.to_string()),
            // reported when the model was elaborated
            Err(faults) => Err(faults.iter().map(|fault| fault.title.clone()).collect::<Vec<_>>().join("; ")),
        },
        behind: Vec::new(),
        must_hold: true,
    };
    others.into_iter().map(compared).collect()
}

/// Terms with more characters are described by their number of operations.
const MOST_READ: usize = 400;

/// Checks a mistaken derivation on a model, and lists the terms that it loses.
pub fn judged_mistake(trace: &Trace<'_>, mistake: Mistake) -> Judgement {
    let (says, agreement, behind) = match mistaken(trace, mistake) {
        Ok(Mistaken { says, agreement, lost }) => {
            let lost = lost.into_iter().map(|(name, term)| {
                let term = shorter(trace, term);
                let operations = Sym::operations_of(&[term]);
                // the text of an expression has at least one character per operation
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
    Judgement { subject: Subject::Mistake { mistake, says }, agreement, behind, must_hold: false }
}
