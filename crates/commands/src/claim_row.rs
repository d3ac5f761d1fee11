//! A judged claim as a row of the report's ledger.

use crate::values;
use charts::ClaimRow;
use claims::{Judged, Verdict};
use manuscript::UnjudgedClaim;

/// The row of a judged claim. Call it in the thread in which the claims of the paper were built.
pub fn row(claim: &Judged) -> ClaimRow {
    let requires = claim.requires.iter().chain(&claim.signs).map(|(_, latex)| format!("${latex}$")).collect();
    ClaimRow {
        id: claim.id.clone(),
        equation_label: label(&claim.equation),
        section: claim.section.clone(),
        title: claim.says.clone(),
        verdict: claim.verdict,
        latex: claim.latex.clone(),
        requires,
        evidence: evidence(claim),
        counterexample: values::compact(&claim.counterexample),
        difference: claim.difference.as_ref().map(|(_, latex)| latex.clone()),
        correction: claim.correction.as_ref().map(|correction| Box::new(row(correction))),
        why: claim.why.clone(),
        reading: claim.reading.clone(),
        note: claim.note.clone(),
    }
}

/// The row of a claim that could not be read: the printed text, the fault, and the accepted spelling.
pub fn unread_row(claim: &UnjudgedClaim) -> ClaimRow {
    let accepted = claim.accepted.as_ref().map_or_else(String::new, |accepted| format!("; accepted: {accepted}"));
    ClaimRow {
        id: claim.id.clone(),
        equation_label: format!("({})", claim.equation),
        verdict: Verdict::Open,
        evidence: format!("not read, line {} of the file: {}{accepted}", claim.line, claim.fault),
        reading: format!("printed: {}", claim.printed),
        ..ClaimRow::default()
    }
}

/// The evidence for the verdict. A formula that fails is named by its number, since the formula itself stands above.
fn evidence(claim: &Judged) -> String {
    let failing =
        claim.evidence.strip_suffix(" fails").and_then(|text| claim.text.iter().position(|line| line == text));
    match (claim.verdict, failing) {
        (Verdict::Definition, _) => String::new(),
        (_, Some(_)) if claim.text.len() == 1 => "it fails for the values below".into(),
        (_, Some(place)) => format!("its line {} fails for the values below", place + 1),
        _ => claim.evidence.clone(),
    }
}

/// The printed form of an identifier: `eq5.3` gives (5.3), `statement3D` Statement 3D, `section7.1-staude` Section 7.1.
fn label(equation: &str) -> String {
    if let Some(number) = equation.strip_prefix("eq") {
        return format!("({number})");
    }
    let head = equation.split('-').next().unwrap_or(equation);
    let number = head.find(|c: char| c.is_ascii_digit()).unwrap_or(head.len());
    let (word, number) = head.split_at(number);
    match (word, number) {
        ("statement" | "remark" | "section", number) if !number.is_empty() => {
            format!("{}{} {number}", word[..1].to_uppercase(), &word[1..])
        }
        ("forms", _) => "Forms".into(),
        ("beyond", _) => "Beyond".into(),
        _ => equation.to_owned(),
    }
}
