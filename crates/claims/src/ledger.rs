//! The ledger in a machine-readable form: one entry for each judged claim.

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
    /// The sentence of the claim, with its formulas where the whole is short enough.
    pub statement: String,
    /// All formulas of the statement.
    pub formulas: Vec<String>,
    /// All premises: hypotheses, divisors that must not vanish, signs.
    pub requires: Vec<String>,
    /// The reason for which the printed statement fails, for a refuted claim.
    pub why: Option<String>,
    /// The reading of a damaged or ambiguous text.
    pub reading: Option<String>,
    /// A remark.
    pub note: Option<String>,
    /// Exact values by name at which the claim fails, or that show an existence.
    pub counterexample: Option<BTreeMap<String, String>>,
    /// The corrected claim.
    pub correction: Option<Box<Entry>>,
}

/// The entries of judged claims, in their order.
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
