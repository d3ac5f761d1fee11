//! The verdicts on claims, with their names and meanings.

/// The verdict on a claim.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    Refuted,
    Undefined,
    Undecided,
    Proved,
    Enclosed,
    Identified,
    Tested,
    Definition,
    #[default]
    Open,
}

impl Verdict {
    /// All verdicts, those that need a reader's attention first.
    pub const ALL: [Verdict; 9] = [
        Verdict::Refuted,
        Verdict::Undefined,
        Verdict::Undecided,
        Verdict::Proved,
        Verdict::Enclosed,
        Verdict::Identified,
        Verdict::Tested,
        Verdict::Definition,
        Verdict::Open,
    ];

    /// The name, one lower-case word; labels, filters and CSS classes use it.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Refuted => "refuted",
            Verdict::Undefined => "undefined",
            Verdict::Undecided => "undecided",
            Verdict::Proved => "proved",
            Verdict::Enclosed => "enclosed",
            Verdict::Identified => "identified",
            Verdict::Tested => "tested",
            Verdict::Definition => "definition",
            Verdict::Open => "open",
        }
    }

    /// A sign that tells verdicts apart without colour.
    pub fn sign(self) -> &'static str {
        match self {
            Verdict::Refuted => "✗",
            Verdict::Undefined => "∅",
            Verdict::Undecided => "?",
            Verdict::Proved => "✓",
            Verdict::Enclosed => "[ ]",
            Verdict::Identified => "≡",
            Verdict::Tested => "≈",
            Verdict::Definition => "≔",
            Verdict::Open => "○",
        }
    }

    /// The meaning of the verdict, in one line.
    pub fn meaning(self) -> &'static str {
        match self {
            Verdict::Refuted => "an exact counterexample exists",
            Verdict::Undefined => "a denominator vanishes identically",
            Verdict::Undecided => "the prover gave up",
            Verdict::Proved => "holds for all values within the stated hypotheses",
            Verdict::Enclosed => "shown on the stated set by interval or certificate arithmetic",
            Verdict::Identified => {
                "holds at random points modulo large random primes, with a stated bound on the probability of error"
            }
            Verdict::Tested => "held wherever it was tried; not a proof",
            Verdict::Definition => "introduces a name; makes no claim",
            Verdict::Open => "not attempted",
        }
    }
}
