//! The ledger: judged claims as rows for machines.

use crate::Judged;
use serde::Serialize;
use std::collections::BTreeMap;

/// One row of `ledger --format json`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Entry {
    pub id: String,
    pub paper: String,
    pub equation: String,
    pub verdict: &'static str,
    /// The statement as a sentence, with its formulas where the whole is short enough.
    pub statement: String,
    /// Every formula of the statement, also where it is too long to stand with the sentence.
    pub formulas: Vec<String>,
    /// Everything that is presupposed: hypotheses, divisors that must not vanish, signs.
    pub requires: Vec<String>,
    /// Why the print fails, for a refuted claim.
    pub why: Option<String>,
    /// The reading of a damaged or ambiguous text.
    pub reading: Option<String>,
    /// A remark.
    pub note: Option<String>,
    /// Exact values by name, where the claim fails (or an example of existence).
    pub counterexample: Option<BTreeMap<String, String>>,
    /// The corrected claim.
    pub correction: Option<Box<Entry>>,
}

/// The rows of judged claims.
pub fn entries(judged: &[Judged]) -> Vec<Entry> {
    judged.iter().map(entry).collect()
}

fn entry(claim: &Judged) -> Entry {
    Entry {
        id: claim.id.clone(),
        paper: claim.id.split('/').next().unwrap_or_default().into(),
        equation: claim.equation.clone(),
        verdict: claim.verdict.name(),
        statement: claim.statement(),
        formulas: claim.text.clone(),
        requires: claim.requires.iter().chain(&claim.signs).map(|(text, _)| text.clone()).collect(),
        why: said(&claim.why),
        reading: said(&claim.reading),
        note: said(&claim.note),
        counterexample: (!claim.counterexample.is_empty()).then(|| claim.counterexample.iter().cloned().collect()),
        correction: claim.correction.as_ref().map(|correction| Box::new(entry(correction))),
    }
}

fn said(text: &str) -> Option<String> {
    (!text.is_empty()).then(|| text.to_owned())
}
