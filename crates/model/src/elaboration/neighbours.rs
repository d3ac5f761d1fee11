//! Independent faults in several texts: a fault in one text of a table, or at one name of an expression, does not hide other faults.

use super::{Elaborator, Sound};
use crate::Text;
use crate::expression::{Expression, Form};

impl Elaborator<'_> {
    /// Returns `found`. If it is a fault, the other texts of the same item are checked for faults of their own.
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

    /// Reports the unknown names of an expression from the node `from` on, except the nodes in `but`.
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
