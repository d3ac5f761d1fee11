//! Changes of a printed formula that make a refuted claim true.

use claims::Judged;
use claims::certificate::Certificate;
use std::ops::Range;

/// The largest number of edits that are described one by one; more are counted.
const FEW: usize = 3;

/// The kind of an edit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EditKind {
    Sign,
    /// A relation that includes equality.
    Strictness,
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
    Part,
    Hypothesis,
    Digits,
}

impl EditKind {
    /// The name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sign => "sign",
            Self::Strictness => "strictness",
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
            Self::Part => "part",
            Self::Hypothesis => "missing hypothesis",
            Self::Digits => "digits",
        }
    }
}

/// The search for corrections of a claim.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Search {
    /// The claim is not refuted, or no correction was asked for.
    #[default]
    None,
    /// The search was completed.
    Whole,
    /// The search was stopped by the time limit.
    Cut,
}

impl Search {
    /// A sentence about a search without result.
    pub fn told(self) -> Option<&'static str> {
        match self {
            Self::None => None,
            Self::Whole => Some("none of the edits that were tried makes the claim true"),
            Self::Cut => Some("the time was over before an edit was found that makes the claim true"),
        }
    }
}

/// An edit of the printed formula, or an added hypothesis, that makes a refuted claim true; the corrected claim is proved.
#[derive(Clone, Debug)]
pub struct Correction {
    pub changes: Vec<Change>,
    /// The corrected formula in LaTeX.
    pub formula: String,
    /// The byte ranges of the changes in the corrected formula.
    pub parts: Vec<Range<usize>>,
    /// The corrected claim with its verdict.
    pub judged: Judged,
    /// The certificate, where one was asked for.
    pub certificate: Option<Certificate>,
}

/// One edit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    pub kind: EditKind,
    /// The changed part in words: `the sign of the second term of the left side`.
    pub words: String,
    /// The part of the print in LaTeX; empty where something was added.
    pub before: String,
    /// The replacement; empty where something was removed.
    pub after: String,
}

impl Correction {
    /// The change in words: ``the sign of the second term: `m g` -> `-m g` ``.
    pub fn says(&self) -> String {
        let each = self.changes.iter().map(|Change { words, before, after, .. }| {
            let told = |part: &str| if part.is_empty() { "nothing".to_owned() } else { format!("`{part}`") };
            format!("{words}: {} -> {}", told(before), told(after))
        });
        let each = each.collect::<Vec<_>>();
        let count = if each.len() > FEW { format!("{} places differ: ", each.len()) } else { String::new() };
        count + &each.join("; ")
    }

    /// The change in words, with its formulas between dollar signs.
    pub(crate) fn typeset(&self) -> String {
        let says = self.says().replace(" -> ", " $\\to$ ");
        let mut parts = says.split('`');
        let mut text = parts.next().unwrap_or_default().to_owned();
        for (place, part) in parts.enumerate() {
            match (place % 2, part.starts_with('^')) {
                (0, true) => text += &format!("${{}}{part}$"),
                (0, false) => text += &format!("${part}$"),
                _ => text += part,
            }
        }
        text
    }

    /// The corrected formula with the changes underlined.
    pub(crate) fn marked(&self) -> String {
        let mut text = self.formula.clone();
        let mut parts = self.parts.clone();
        parts.sort_by_key(|part| std::cmp::Reverse(part.start));
        for part in parts {
            let changed = &self.formula[part.clone()];
            let held = changed.trim();
            let marked = match held.strip_prefix('^') {
                _ if held.is_empty() => continue,
                Some(exponent) => format!(r"^{{\underline{{{exponent}}}}}"),
                None => format!(r" {{\underline{{{held}}}}} "),
            };
            text.replace_range(part, &marked);
        }
        text
    }
}
