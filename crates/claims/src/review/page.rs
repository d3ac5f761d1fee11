//! A page read back, as `render` writes it.

use crate::Verdict;

/// A claim as a page states it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Told {
    pub id: String,
    pub verdict: String,
    pub sentence: String,
    pub equations: Vec<String>,
    /// The conditions that the claim requires, signs among them.
    pub requires: Vec<String>,
    /// Remarks: why the print fails, the reading, and notes.
    pub remarks: Vec<String>,
    /// The exact point and the words about it.
    pub rest: Vec<String>,
}

/// Every claim of a page; a correction counts as a claim, with an id of its own.
pub(super) fn claims(page: &str) -> Vec<Told> {
    let mut claims: Vec<Told> = Vec::new();
    for line in page.lines().map(str::trim) {
        if let Some(claim) = head(line) {
            claims.push(claim);
            continue;
        }
        let Some(claim) = claims.last_mut() else { continue };
        if let Some(equation) = line.strip_prefix("| ") {
            claim.equations.push(equation.to_owned());
        } else if let Some(conditions) = line.strip_prefix("requires ").or_else(|| line.strip_prefix("signs ")) {
            claim.requires.extend(conditions.split(", ").map(str::to_owned));
        } else if ["why: ", "reading: ", "note: "].iter().any(|word| line.starts_with(word)) {
            claim.remarks.push(line.to_owned());
        } else if !line.is_empty() && line != "correct:" {
            claim.rest.push(line.to_owned());
        }
    }
    claims
}

/// `proved     paper/entry/slug  sentence`.
fn head(line: &str) -> Option<Told> {
    let (verdict, rest) = line.split_once(' ')?;
    Verdict::ALL.iter().find(|known| known.name() == verdict)?;
    let (id, sentence) = rest.trim_start().split_once("  ")?;
    let named = id.contains('/') && !id.contains(' ');
    named.then(|| Told { id: id.into(), verdict: verdict.into(), sentence: sentence.into(), ..Told::default() })
}
