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
    pub statement: String,
    pub requires: Vec<String>,
    /// Exact values by name, where the claim fails (or an example of existence).
    pub counterexample: Option<BTreeMap<String, String>>,
    /// What holds instead.
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
        statement: format!("{}: {}", claim.says, claim.text.join("; ")),
        requires: claim.requires.iter().map(|(text, _)| text.clone()).collect(),
        counterexample: (!claim.counterexample.is_empty()).then(|| claim.counterexample.iter().cloned().collect()),
        correction: claim.correction.as_ref().map(|correction| Box::new(entry(correction))),
    }
}
