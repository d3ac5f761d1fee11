//! The stage that judges the claims of a paper and reports them as they are judged.

use super::Broken;
use crate::claim_row::row;
use crate::clock;
use crate::watch::told::Told;
use charts::ClaimRow;
use charts::page::live::{self, LiveClaim, Part};
use manuscript::{Finding, PaperFindings, PaperText};
use std::path::Path;
use std::time::{Duration, Instant};

/// The least time between two reports.
const PAUSE: Duration = Duration::from_millis(120);

/// The time before the deadline at which the search for corrections ends.
const KEPT: Duration = Duration::from_millis(500);

/// Judges all claims, and reports the list of claims whenever further ones are judged.
pub(super) fn tell(path: &Path, text: String) -> Result<(), Broken> {
    let paper = PaperText::parse(path, text)?;
    let sources: Vec<LiveClaim> = paper.claims.iter().map(|claim| source(&paper, claim)).collect();
    // of two claims with one id, the second has a fault and no finding
    let ids = paper.claims.iter().map(|claim| claim.faults.is_empty().then(|| paper.id_of(claim)));
    let ids: Vec<Option<String>> = ids.collect();
    let shown = |findings: &[Finding]| -> Told {
        // claims that cannot be read have no finding
        let found = |id: &Option<String>| {
            let id = id.as_ref()?;
            findings.iter().find(|finding| finding.judged.id == *id)
        };
        let claims = sources.iter().cloned().zip(&ids);
        let claims: Vec<LiveClaim> =
            claims.map(|(claim, id)| LiveClaim { row: found(id).map(decided), ..claim }).collect();
        Told::part(Part::Claims, live::claims(&claims))
    };
    shown(&[]).write()?;
    let mut last = Instant::now();
    let so_far = |findings: &[Finding]| {
        if last.elapsed() > PAUSE {
            // an error means that the reader has ended, and this process ends with it
            let _ = shown(findings).write();
            last = Instant::now();
        }
    };
    let PaperFindings { findings, error, .. } = paper.findings(false, so_far, || clock::left() > KEPT)?;
    shown(&findings).write()?;
    Ok(error.map_or(Ok(()), Err)?)
}

fn source(paper: &PaperText, claim: &manuscript::ClaimText) -> LiveClaim {
    LiveClaim {
        source: claim.formula.text.clone(),
        row: None,
        label: format!("{}, line {}", claim.key(), paper.line_of(&claim.at)),
    }
}

/// The row of a judged claim without its reading, since the source stands next to the formula.
fn decided(finding: &Finding) -> ClaimRow {
    ClaimRow { reading: String::new(), ..row(&finding.judged) }
}
