//! Faults of a system as it was written, each with its place.

use std::ops::Range;

/// One fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Bytes of the text that the system was read from.
    pub span: Range<usize>,
    /// The fault in one line.
    pub title: String,
    /// A few words for the place itself.
    pub label: String,
    /// A text that would be accepted.
    pub accepted: String,
}

impl Fault {
    /// A consequence of another fault that is reported: this one is not reported.
    pub(crate) fn consequence(span: Range<usize>) -> Self {
        Fault { span, title: String::new(), label: String::new(), accepted: String::new() }
    }

    pub(crate) fn is_consequence(&self) -> bool {
        self.title.is_empty()
    }

    /// A fault at a place.
    pub fn at(
        span: Range<usize>,
        title: impl Into<String>,
        label: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Self {
        Fault { span, title: title.into(), label: label.into(), accepted: accepted.into() }
    }
}
