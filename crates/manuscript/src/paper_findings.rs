//! The findings on a paper, beside its claims that were not judged.

use crate::claim_text::ClaimText;
use crate::finding::Finding;
use crate::paper_text::PaperText;
use reader::{Issue, SceneError};

/// All claims of a paper: those that were judged, and those that were not read.
#[derive(Clone, Debug)]
pub struct PaperFindings {
    /// In the order of the file.
    pub findings: Vec<Finding>,
    /// In the order of the file.
    pub unjudged: Vec<UnjudgedClaim>,
    /// The faults of these claims, each at its place.
    pub error: Option<SceneError>,
}

/// A claim that was not judged.
#[derive(Clone, Debug)]
pub struct UnjudgedClaim {
    pub id: String,
    /// The paper's own number of the formula.
    pub equation: String,
    /// The formula in LaTeX, as printed.
    pub printed: String,
    /// The line of the file at which the fault stands, from 1.
    pub line: usize,
    /// The first fault, in one line.
    pub fault: String,
    /// The input that would be accepted.
    pub accepted: Option<String>,
}

impl PaperFindings {
    pub(crate) fn of(paper: &PaperText, findings: Vec<Finding>, faults: Vec<(&ClaimText, Vec<Issue>)>) -> Self {
        let unjudged = faults.iter().filter_map(|(claim, issues)| {
            let issue = issues.first()?;
            Some(UnjudgedClaim {
                id: paper.id_of(claim),
                equation: claim.equation.clone(),
                printed: claim.formula.text.clone(),
                line: paper.line_of(issue.span.as_ref().unwrap_or(&claim.at)),
                fault: issue.title.clone(),
                accepted: issue.help.clone(),
            })
        });
        let unjudged: Vec<UnjudgedClaim> = unjudged.collect();
        let issues: Vec<Issue> = faults.into_iter().flat_map(|(_, issues)| issues).collect();
        let error = (!issues.is_empty()).then(|| paper.error(issues));
        PaperFindings { findings, unjudged, error }
    }

    /// The findings where every claim was judged.
    ///
    /// # Errors
    /// The faults of those that were not.
    pub fn whole(self) -> Result<Vec<Finding>, SceneError> {
        self.error.map_or(Ok(self.findings), Err)
    }
}
