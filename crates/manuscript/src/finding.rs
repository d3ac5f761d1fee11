//! The finding on a claim.

use crate::change::{Correction, Search};
use crate::claim_text::Kind;
use claims::certificate::Certificate;
use claims::{Judged, Verdict};
use std::fmt::Write;

/// A claim with its verdict, as text only.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The entry for ledgers and pages, with the first correction.
    pub judged: Judged,
    pub kind: Kind,
    /// The formula in LaTeX, as printed.
    pub printed: String,
    /// Hypotheses of the file, in LaTeX as written.
    pub given: Vec<String>,
    /// The verdict that the file expects, if any.
    pub expected: Option<Verdict>,
    /// The steps that were allowed to the equations of the model: combinations, constraints, hypotheses.
    pub allowed: String,
    /// The values of both sides at the counterexample.
    pub sides: Option<Sides>,
    /// The smallest edits of a refuted claim that are proved, all of one size.
    pub corrections: Vec<Correction>,
    pub search: Search,
    /// A sentence on parameters that are not positive at the counterexample; may be empty.
    pub(crate) unusual: String,
    /// Whether an exact point was found inside the presuppositions of a proved claim.
    pub(crate) has_inside: bool,
    /// Present if it was requested.
    pub certificate: Option<Certificate>,
}

/// Exact values at a counterexample.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sides {
    pub left: String,
    pub right: String,
}

impl Finding {
    /// Whether the verdict is the one that the file expects.
    ///
    /// # Errors
    /// It is not, in a sentence.
    pub fn as_expected(&self) -> Result<(), String> {
        let Judged { id, verdict, evidence, objections, .. } = &self.judged;
        match self.expected {
            Some(expected) if expected != *verdict => {
                Err(format!("{id}: {} was expected, found {}: {evidence}", expected.name(), verdict.name()))
            }
            _ => objections.first().map_or(Ok(()), |objection| Err(format!("{id}: {objection}"))),
        }
    }

    /// The certificates of the finding and of its corrections, where they were asked for.
    pub fn certificates(&self) -> impl Iterator<Item = Certificate> {
        let corrected = self.corrections.iter().enumerate().filter_map(|(place, one)| {
            let id = format!("{} (correction {})", self.judged.id, place + 1);
            one.certificate.clone().map(|certificate| Certificate { id, ..certificate })
        });
        self.certificate.clone().into_iter().chain(corrected)
    }

    /// For reading: the printed formula, how it was read, the verdict with its grounds.
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
            line("missing", difference);
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
        // a reason for a refutation is told once
        for objection in objections.iter().filter(|objection| !evidence.contains(objection.as_str())) {
            line("objection", objection);
        }
        page.push('\n');
        page
    }
}

/// The largest number of characters of one condition, and of a list of conditions, on a page for reading.
const MOST_OF_CONDITION: usize = 240;
const MOST_OF_CONDITIONS: usize = 800;

/// Conditions for reading: the short ones first, with the size of those that are too long; none if there are none.
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
