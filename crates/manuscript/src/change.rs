//! Changes of a printed formula that make a refuted claim true.

use claims::Judged;
use std::ops::Range;

/// The kind of an edit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EditKind {
    Sign,
    Direction,
    Function,
    Exponent,
    Letter,
    Dot,
    Number,
    MissingFactor,
    ExtraFactor,
    LostTerm,
    ExtraTerm,
    Hypothesis,
    Digits,
}

impl EditKind {
    /// As programs have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sign => "sign",
            Self::Direction => "direction",
            Self::Function => "function",
            Self::Exponent => "exponent",
            Self::Letter => "letter",
            Self::Dot => "dot",
            Self::Number => "number",
            Self::MissingFactor => "missing factor",
            Self::ExtraFactor => "superfluous factor",
            Self::LostTerm => "lost term",
            Self::ExtraTerm => "superfluous term",
            Self::Hypothesis => "missing hypothesis",
            Self::Digits => "digits",
        }
    }
}

/// An edit of the printed formula, or a hypothesis beside it, that makes a refuted claim true: it is proved by the judge of the claim.
#[derive(Clone, Debug)]
pub struct Correction {
    pub changes: Vec<Change>,
    /// The corrected formula in LaTeX.
    pub formula: String,
    /// The bytes of the corrected formula that the changes have.
    pub parts: Vec<Range<usize>>,
    /// The corrected claim with its verdict.
    pub judged: Judged,
}

/// One edit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    pub kind: EditKind,
    /// In words: `the sign of the second term of the left side`.
    pub words: String,
    /// The part of the print in LaTeX; empty where something was added.
    pub before: String,
    /// What stands there instead; empty where something was left out.
    pub after: String,
}

impl Correction {
    /// In words: `the sign of the second term: m g -> - m g`.
    pub fn says(&self) -> String {
        let each = self.changes.iter().map(|Change { words, before, after, .. }| {
            let told = |part: &str| if part.is_empty() { "nothing".to_owned() } else { format!("`{part}`") };
            format!("{words}: {} -> {}", told(before), told(after))
        });
        each.collect::<Vec<_>>().join("; ")
    }
}
