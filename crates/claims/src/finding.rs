//! Findings: each is a property that a motor or a system must have, with its verdict.

/// The verdict on a property.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
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
    pub verdict: Verdict,
}

impl Verdict {
    /// As pages and programs have it.
    pub fn name(&self) -> &'static str {
        match self {
            Verdict::Proved(_) => "proved",
            Verdict::Tested(_) => "tested",
            Verdict::Fails(_) => "fails",
            Verdict::Undecided(_) => "undecided",
            Verdict::DoesNotApply(_) => "does not apply",
        }
    }

    /// The sentence that holds, or the reason why none does.
    pub fn says(&self) -> &str {
        match self {
            Verdict::Proved(says)
            | Verdict::Tested(says)
            | Verdict::Fails(says)
            | Verdict::Undecided(says)
            | Verdict::DoesNotApply(says) => says,
        }
    }
}
