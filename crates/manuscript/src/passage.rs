//! A text of a file with the place of each of its parts.

use latex::NotFormula;
use reader::{At, Issue, Table};
use std::ops::Range;

/// A text as it stands in a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Passage {
    pub text: String,
    /// The value with its quotes.
    pub span: Range<usize>,
    /// The beginning of the text; none if the text has escapes, so that its parts have no places.
    start: Option<usize>,
}

impl Passage {
    /// A value of a table.
    pub fn of(table: &Table<'_>, source: &str, value: &At<String>) -> Self {
        let start = table.part(value, &(0..0)).start;
        let is_plain = source.get(start..).is_some_and(|rest| rest.starts_with(&value.value));
        Passage { text: value.value.clone(), span: value.span.clone(), start: is_plain.then_some(start) }
    }

    /// A part of the text that begins at this byte; its parts keep their places.
    pub(crate) fn from(&self, text: String, start: usize) -> Self {
        Passage { text, span: self.span.clone(), start: self.start.map(|own| own + start) }
    }

    /// Another text instead, which is in no file.
    pub(crate) fn with_text(&self, text: String) -> Self {
        Passage { text, span: self.span.clone(), start: None }
    }

    /// The bytes of the file that a part of the text has.
    pub fn part(&self, part: &Range<usize>) -> Range<usize> {
        match self.start {
            Some(start) => start + part.start..start + part.end.max(part.start),
            None => self.span.clone(),
        }
    }

    /// Where the text begins.
    pub fn start(&self) -> usize {
        self.start.unwrap_or(self.span.start)
    }
}

/// The fault of a formula that cannot be read, at its place in the file.
pub(crate) fn placed(text: &Passage, fault: NotFormula) -> Issue {
    Issue::at(text.part(&fault.span), fault.title, fault.label).accepted(fault.accepted)
}
