//! The findings on a paper, and its claims that could not be judged.

use crate::claim_text::ClaimText;
use crate::finding::Finding;
use crate::paper_text::PaperText;
use reader::{Issue, SceneError};

/// All claims of a paper: the judged ones, and those that could not be read.
#[derive(Clone, Debug)]
pub struct PaperFindings {
    /// The findings, in the order of the file.
    pub findings: Vec<Finding>,
    /// The claims that could not be read, in the order of the file.
    pub unjudged: Vec<UnjudgedClaim>,
    /// The faults of these claims, with their places; `None` if all claims were judged.
    pub error: Option<SceneError>,
}

/// A claim that was not judged.
#[derive(Clone, Debug)]
pub struct UnjudgedClaim {
    pub id: String,
    /// The number of the formula in the paper.
    pub equation: String,
    /// The formula in LaTeX, as printed.
    pub printed: String,
    /// The line of the fault in the file, from 1.
    pub line: usize,
    /// The first fault, as one line of text.
    pub fault: String,
    /// The input that would be accepted, if known.
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

    /// The findings, if every claim was judged.
    ///
    /// # Errors
    /// The faults of the claims that could not be read.
    pub fn whole(self) -> Result<Vec<Finding>, SceneError> {
        self.error.map_or(Ok(self.findings), Err)
    }
}
