//! Faults in several texts: a fault in one text of a table, or in one name of a text, hides no fault of another.

use super::{Elaborator, Sound};
use crate::Text;
use crate::expression::{Expression, Form};

impl Elaborator<'_> {
    /// A part of the system; where one of its texts is wrong, the others are checked for faults of their own.
    pub(super) fn beside<'t, T>(&mut self, found: Sound<T>, texts: impl IntoIterator<Item = &'t Text>) -> Sound<T> {
        if let Err(fault) = &found {
            let place = fault.span.clone();
            let is_apart = |text: &&Text| place.end <= text.span().start || text.span().end <= place.start;
            for text in texts.into_iter().filter(is_apart) {
                let read = self.value(text);
                self.kept(read);
            }
        }
        found
    }

    /// Reports unknown names from a place of an expression on.
    pub(super) fn later_names(&mut self, text: &Text, expression: &Expression, from: usize, but: &[usize]) {
        for place in (from..expression.parts.len()).filter(|place| !but.contains(place)) {
            let span = text.part(&expression.spans[place]);
            let read = match &expression.parts[place] {
                Form::Name(name) => self.named(&span, name).map(drop),
                Form::Member { of, name } => self.member(&span, of, name).map(drop),
                _ => Ok(()),
            };
            self.kept(read);
        }
    }
}
