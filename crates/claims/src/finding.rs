//! Findings: verdicts on properties that a motor or a system must have.

/// The verdict on a property.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PropertyVerdict {
    /// The property holds exactly for all states (and, for an identity, for all parameters); the text states it.
    Proved(String),
    /// The property holds in runs or at sampled points; the text states it.
    Tested(String),
    /// The property fails; the text is the reason.
    Fails(String),
    /// The prover gave up, so that the property is neither proved nor refuted; the text is the reason.
    Undecided(String),
    /// The property does not apply; the text is the reason.
    DoesNotApply(String),
}

/// A check with its result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The name of the checked property, one word.
    pub check: &'static str,
    pub verdict: PropertyVerdict,
}

impl PropertyVerdict {
    /// The name of the verdict on pages and in output.
    pub fn name(&self) -> &'static str {
        match self {
            PropertyVerdict::Proved(_) => "proved",
            PropertyVerdict::Tested(_) => "tested",
            PropertyVerdict::Fails(_) => "fails",
            PropertyVerdict::Undecided(_) => "undecided",
            PropertyVerdict::DoesNotApply(_) => "does not apply",
        }
    }

    /// The sentence that states the property, or the reason of the verdict.
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
