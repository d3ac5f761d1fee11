//! A text in a file, from which the place of each of its parts can be computed.

use latex::NotFormula;
use reader::{At, Issue, Table};
use std::ops::Range;

/// A text in a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Passage {
    pub text: String,
    /// The range of the value in the file in bytes, including its quotes.
    pub span: Range<usize>,
    /// The position of the first byte of the text; `None` if the text contains escapes, so that its parts have no places.
    start: Option<usize>,
}

impl Passage {
    /// The value of a key of a table.
    pub fn of(table: &Table<'_>, source: &str, value: &At<String>) -> Self {
        let start = table.part(value, &(0..0)).start;
        let is_plain = source.get(start..).is_some_and(|rest| rest.starts_with(&value.value));
        Passage { text: value.value.clone(), span: value.span.clone(), start: is_plain.then_some(start) }
    }

    /// The part of the text that begins at this byte.
    pub(crate) fn from(&self, text: String, start: usize) -> Self {
        Passage { text, span: self.span.clone(), start: self.start.map(|own| own + start) }
    }

    /// A replacement of the text, which is not in the file.
    pub(crate) fn with_text(&self, text: String) -> Self {
        Passage { text, span: self.span.clone(), start: None }
    }

    /// The range in the file of a part of the text.
    pub fn part(&self, part: &Range<usize>) -> Range<usize> {
        match self.start {
            Some(start) => start + part.start..start + part.end.max(part.start),
            None => self.span.clone(),
        }
    }

    /// The position of the text in the file.
    pub fn start(&self) -> usize {
        self.start.unwrap_or(self.span.start)
    }
}

/// The fault of a formula that cannot be read, with its place in the file.
pub(crate) fn placed(text: &Passage, fault: NotFormula) -> Issue {
    Issue::at(text.part(&fault.span), fault.title, fault.label).accepted(fault.accepted)
}
