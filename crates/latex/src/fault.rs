//! A fault of a formula, at its place.

use std::fmt;
use std::ops::Range;

/// Why a text is no formula, or has more than one reading.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotFormula {
    /// Bytes of the formula.
    pub span: Range<usize>,
    /// The fault, in one line.
    pub title: String,
    /// The text beside the marks under the place.
    pub label: String,
    /// Texts that would be accepted.
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
