//! Errors and warnings about the text of a system, with their positions.

use std::ops::Range;

/// One error or warning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The range of bytes in the text of the system.
    pub span: Range<usize>,
    /// The fault, in one line.
    pub title: String,
    /// A short text beside the marks at the position.
    pub label: String,
    /// Input that would be accepted.
    pub accepted: String,
}

impl Fault {
    /// Creates a consequence of another fault; consequences are not reported.
    pub(crate) fn consequence(span: Range<usize>) -> Self {
        Fault { span, title: String::new(), label: String::new(), accepted: String::new() }
    }

    pub(crate) fn is_consequence(&self) -> bool {
        self.title.is_empty()
    }

    /// Creates a fault at a range of bytes.
    pub fn at(
        span: Range<usize>,
        title: impl Into<String>,
        label: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Self {
        Fault { span, title: title.into(), label: label.into(), accepted: accepted.into() }
    }
}
