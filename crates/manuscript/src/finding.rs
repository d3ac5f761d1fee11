//! The finding on a claim: its verdict with all results.

use crate::change::{Correction, Search};
use crate::claim_text::Kind;
use claims::certificate::Certificate;
use claims::{Judged, Verdict};
use std::fmt::Write;

/// A judged claim. It contains text only.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The claim with its verdict and its first correction, as ledgers and pages contain it.
    pub judged: Judged,
    pub kind: Kind,
    /// The formula in LaTeX, as printed.
    pub printed: String,
    /// The hypotheses of the file, in LaTeX without changes.
    pub given: Vec<String>,
    /// The verdict that the file expects, if it states one.
    pub expected: Option<Verdict>,
    /// A sentence on the permitted use of the model: combinations of equations, constraints, hypotheses.
    pub allowed: String,
    /// The values of both sides at the counterexample.
    pub sides: Option<Sides>,
    /// The smallest edits of a refuted claim with which it is proved, all of the same size.
    pub corrections: Vec<Correction>,
    pub search: Search,
    /// A sentence on parameters that are zero or not positive at the counterexample; may be empty.
    pub(crate) unusual: String,
    /// Whether an exact point was found inside the domain of a proved claim.
    pub(crate) has_inside: bool,
    /// The certificate, if requested.
    pub certificate: Option<Certificate>,
}

/// The exact values of both sides at a counterexample.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sides {
    pub left: String,
    pub right: String,
}

impl Finding {
    /// Checks that the verdict is the one that the file expects and that there are no objections.
    ///
    /// # Errors
    /// A sentence on the deviation.
    pub fn as_expected(&self) -> Result<(), String> {
        let Judged { id, verdict, evidence, objections, .. } = &self.judged;
        match self.expected {
            Some(expected) if expected != *verdict => {
                Err(format!("{id}: expected {}, got {}: {evidence}", expected.name(), verdict.name()))
            }
            _ => objections.first().map_or(Ok(()), |objection| Err(format!("{id}: {objection}"))),
        }
    }

    /// The certificates of the finding and of its corrections, if requested.
    pub fn certificates(&self) -> impl Iterator<Item = Certificate> {
        let corrected = self.corrections.iter().enumerate().filter_map(|(place, one)| {
            let id = format!("{} (correction {})", self.judged.id, place + 1);
            one.certificate.clone().map(|certificate| Certificate { id, ..certificate })
        });
        self.certificate.clone().into_iter().chain(corrected)
    }

    /// The finding as text: the printed formula, its reading, the verdict with its grounds.
    pub fn text(&self) -> String {
        let Judged {
            id, says, verdict, text, evidence, requires, signs, counterexample, difference, objections, ..
        } = &self.judged;
        let mut page = format!("{} {:<9} {id}  {}\n", verdict.sign(), verdict.name(), said(says, self.kind));
        let mut line = |word: &str, told: &str| {
            // writing to a string cannot fail
            let _ = writeln!(page, "    {word:<9} {told}");
        };
        line("printed", &self.printed);
        for read in text {
            line("read as", read);
        }
        if let Some(conditions) = told(requires.iter().chain(signs)) {
            line("where", &conditions);
        }
        if !self.allowed.is_empty() {
            line("allowed", &self.allowed);
        }
        line("because", evidence);
        if !counterexample.is_empty() {
            let values: Vec<String> = counterexample.iter().map(|(name, value)| format!("{name} = {value}")).collect();
            line("at", &values.join(", "));
        }
        if let Some((difference, _)) = difference {
            line("missing", &format!("{difference} on the right side"));
        }
        if self.corrections.len() > 1 {
            line("several", &format!("{} edits of one size make it true", self.corrections.len()));
        }
        if let Some(told) = self.search.told().filter(|_| self.corrections.is_empty()) {
            line("edit", told);
        }
        for correction in &self.corrections {
            line("edit", &correction.says());
            line("corrected", &correction.formula);
            let Judged { verdict, evidence, requires, signs, .. } = &correction.judged;
            line("", &format!("{}: {evidence}", verdict.name()));
            if let Some(conditions) = told(requires.iter().chain(signs)) {
                line("where", &conditions);
            }
        }
        // an objection that is also the reason of the refutation is printed once
        for objection in objections.iter().filter(|objection| !evidence.contains(objection.as_str())) {
            line("objection", objection);
        }
        page.push('\n');
        page
    }
}

/// The largest length in characters of a condition that is printed; [`MOST_OF_CONDITIONS`]: of a list of conditions.
const MOST_OF_CONDITION: usize = 240;
const MOST_OF_CONDITIONS: usize = 800;

/// The conditions as text, with the lengths of those that are too long; `None` without conditions.
fn told<'a>(conditions: impl Iterator<Item = &'a (String, String)>) -> Option<String> {
    let (mut shown, mut hidden, mut length) = (Vec::new(), Vec::new(), 0);
    for (text, _) in conditions {
        let own = text.chars().count();
        if own <= MOST_OF_CONDITION && length + own <= MOST_OF_CONDITIONS {
            length += own;
            shown.push(text.clone());
        } else {
            hidden.push(own);
        }
    }
    match hidden[..] {
        [] => {}
        [own] => shown.push(format!("one more condition of {own} characters, which --json has")),
        _ => shown.push(format!(
            "{} more conditions of {} characters, which --json has",
            hidden.len(),
            hidden.iter().sum::<usize>()
        )),
    }
    (!shown.is_empty()).then(|| shown.join(", "))
}

fn said(says: &str, kind: Kind) -> String {
    if says.is_empty() { kind.name().to_owned() } else { says.to_owned() }
}
