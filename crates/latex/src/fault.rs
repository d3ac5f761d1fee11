//! Errors in a formula.

use std::fmt;
use std::ops::Range;

/// The error of a text that is not a formula, or can be read in more than one way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotFormula {
    /// The range of bytes in the formula.
    pub span: Range<usize>,
    /// The error, in one line.
    pub title: String,
    /// The text beside the marks that underline the range.
    pub label: String,
    /// Examples of accepted input.
    pub accepted: String,
}

impl NotFormula {
    pub(crate) fn at(
        span: Range<usize>,
        title: impl Into<String>,
        label: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Self {
        NotFormula { span, title: title.into(), label: label.into(), accepted: accepted.into() }
    }
}

impl fmt::Display for NotFormula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; accepted is {}", self.title, self.accepted)
    }
}

impl std::error::Error for NotFormula {}
