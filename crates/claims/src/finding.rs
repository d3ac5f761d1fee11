//! Findings: each is a property that a motor or a system must have, with its verdict.

/// The verdict on a property.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PropertyVerdict {
    /// The statement holds exactly, for all states; an identity, for all parameters.
    Proved(String),
    /// The statement holds in runs and numbers.
    Tested(String),
    /// The statement fails, for this reason.
    Fails(String),
    /// The prover gave up, for this reason: neither that it holds nor that it fails is known.
    Undecided(String),
    /// The statement does not apply, for this reason.
    DoesNotApply(String),
}

/// A check with its result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The check in one word.
    pub check: &'static str,
    pub verdict: PropertyVerdict,
}

impl PropertyVerdict {
    /// The name on pages and in output.
    pub fn name(&self) -> &'static str {
        match self {
            PropertyVerdict::Proved(_) => "proved",
            PropertyVerdict::Tested(_) => "tested",
            PropertyVerdict::Fails(_) => "fails",
            PropertyVerdict::Undecided(_) => "undecided",
            PropertyVerdict::DoesNotApply(_) => "does not apply",
        }
    }

    /// The sentence that holds, or the reason why none does.
    pub fn says(&self) -> &str {
        match self {
            PropertyVerdict::Proved(says)
            | PropertyVerdict::Tested(says)
            | PropertyVerdict::Fails(says)
            | PropertyVerdict::Undecided(says)
            | PropertyVerdict::DoesNotApply(says) => says,
        }
    }
}
