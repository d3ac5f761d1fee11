//! An edit of a printed formula: a part of its text and the replacement.

use crate::change::EditKind;
use std::ops::Range;

/// An edit of a formula's text, or an added hypothesis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Edit {
    pub kind: EditKind,
    /// Bytes of the formula.
    pub span: Range<usize>,
    pub after: String,
    /// The edit in words.
    pub words: String,
    /// The part of the formula that is printed to show the edit.
    pub around: Range<usize>,
}

impl Edit {
    pub fn new(kind: EditKind, span: Range<usize>, after: impl Into<String>, words: String) -> Self {
        Edit { kind, around: span.clone(), span, after: after.into(), words }
    }

    /// The part of the formula that is shown, before the edit and after it.
    pub fn shown(&self, formula: &str) -> [String; 2] {
        let part = |range: Range<usize>| formula.get(range).unwrap_or_default();
        let before = part(self.around.clone());
        let (left, right) = (part(self.around.start..self.span.start), part(self.span.end..self.around.end));
        [before.trim().to_owned(), format!("{left}{}{right}", self.after).trim().to_owned()]
    }

    /// The edited formula, and the place of the edit in it.
    pub fn applied(&self, formula: &str) -> (String, Range<usize>) {
        let (before, behind) = (&formula[..self.span.start], &formula[self.span.end..]);
        // a command would be joined with the letter after it
        let swallows = |left: &str, right: &str| {
            let tail = left.trim_end_matches(|letter: char| letter.is_ascii_alphabetic());
            tail.len() < left.len()
                && tail.ends_with('\\')
                && right.starts_with(|letter: char| letter.is_ascii_alphabetic())
        };
        let first = if swallows(before, &self.after) { " " } else { "" };
        let joined = format!("{before}{first}{}", self.after);
        let second = if swallows(&joined, behind) { " " } else { "" };
        let start = before.len() + first.len();
        (format!("{joined}{second}{behind}"), start..start + self.after.len())
    }
}

/// Whether each `\left` and each `\right` stands before its bracket: an edit may not come between them.
pub(super) fn is_whole(formula: &str) -> bool {
    let stands = |command: &str| {
        formula.match_indices(command).all(|(at, _)| {
            let behind = &formula[at + command.len()..];
            behind.starts_with(|letter: char| letter.is_ascii_alphabetic())
                || behind.trim_start().starts_with(['(', ')', '[', ']', '.', '|', '\\'])
        })
    };
    stands(r"\left") && stands(r"\right")
}
