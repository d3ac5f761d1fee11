//! An edit of a printed formula: a range of its text and the replacement.

use crate::change::EditKind;
use std::ops::Range;

/// An edit of a formula's text, or an added hypothesis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Edit {
    pub kind: EditKind,
    /// The replaced range of the formula, in bytes.
    pub span: Range<usize>,
    pub after: String,
    /// The edit in words.
    pub words: String,
    /// The range of the formula that is shown to explain the edit.
    pub around: Range<usize>,
    /// A further text, such as a closing bracket, and the position after the range at which it is inserted.
    pub closing: Option<(usize, String)>,
}

impl Edit {
    pub fn new(kind: EditKind, span: Range<usize>, after: impl Into<String>, words: String) -> Self {
        Edit { kind, around: span.clone(), span, after: after.into(), words, closing: None }
    }

    /// The edit with a text that is also inserted at a later position.
    pub fn closed(self, at: usize, text: String) -> Self {
        Edit { around: self.around.start..self.around.end.max(at), closing: Some((at, text)), ..self }
    }

    /// The shown part of the formula, without and with the edit.
    pub fn shown(&self, formula: &str) -> [String; 2] {
        let part = |range: Range<usize>| formula.get(range).unwrap_or_default();
        let before = part(self.around.clone());
        let (left, right) = (part(self.around.start..self.span.start), part(self.span.end..self.around.end));
        let closing = self.closing.as_ref().map_or("", |(_, text)| text);
        [before.trim().to_owned(), format!("{left}{}{right}{closing}", self.after).trim().to_owned()]
    }

    /// The edit as one or two edits of single ranges.
    pub fn parts(&self) -> Vec<Edit> {
        let Some((at, text)) = &self.closing else { return vec![self.clone()] };
        let first = Edit { closing: None, around: self.span.clone(), ..self.clone() };
        vec![first, Edit::new(self.kind, *at..*at, text.as_str(), String::new())]
    }

    /// Whether the ranges of two edits do not overlap.
    pub fn is_apart(&self, other: &Edit) -> bool {
        let apart = |one: &Range<usize>, other: &Range<usize>| one.end <= other.start || other.end <= one.start;
        let places = |edit: &Edit| edit.parts().into_iter().map(|part| part.span).collect::<Vec<_>>();
        places(self).iter().all(|one| places(other).iter().all(|other| apart(one, other)))
    }

    /// The edited formula, and the range of the edit in it, in bytes.
    pub fn applied(&self, formula: &str) -> (String, Range<usize>) {
        let (before, behind) = (&formula[..self.span.start], &formula[self.span.end..]);
        // a space separates a LaTeX command from a letter after it
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

/// Whether each `\left` and each `\right` is still followed by its bracket, so that no edit came between them.
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
