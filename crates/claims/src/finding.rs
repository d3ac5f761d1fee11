//! Findings: each is a property that a motor or a system must have, with its verdict.

/// The verdict on a property.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PropertyVerdict {
    /// Exactly, for all states; of an identity, for all parameters.
    Proved(String),
    /// By runs and numbers.
    Tested(String),
    /// And why.
    Fails(String),
    /// The prover gave up, and why: neither that it holds nor that it fails is known.
    Undecided(String),
    /// And why not.
    DoesNotApply(String),
}

/// A check with what it came to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// One word.
    pub check: &'static str,
    pub verdict: PropertyVerdict,
}

impl PropertyVerdict {
    /// As pages and programs have it.
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
