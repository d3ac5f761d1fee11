//! Parser of the text of a page that [`crate::render`] writes.

use crate::Verdict;

/// A claim as it stands in the text of a page.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Told {
    pub id: String,
    pub verdict: String,
    pub sentence: String,
    pub equations: Vec<String>,
    /// The conditions that the claim requires, including those about signs.
    pub requires: Vec<String>,
    /// Remarks: the reason of a failure, the reading, notes.
    pub remarks: Vec<String>,
    /// The exact point, and the text about it.
    pub rest: Vec<String>,
}

/// All claims of a page; a correction is listed as a claim with its own id.
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

/// Parses the first line of a claim: `proved     paper/entry/slug  sentence`.
fn head(line: &str) -> Option<Told> {
    let (verdict, rest) = line.split_once(' ')?;
    Verdict::ALL.iter().find(|known| known.name() == verdict)?;
    let (id, sentence) = rest.trim_start().split_once("  ")?;
    let named = id.contains('/') && !id.contains(' ');
    named.then(|| Told { id: id.into(), verdict: verdict.into(), sentence: sentence.into(), ..Told::default() })
}
