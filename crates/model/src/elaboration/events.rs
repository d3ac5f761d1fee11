//! Events: instants at which an expression passes through zero, and the state after them.

use super::{Elaborator, Sound};
use crate::expression::{Form, read};
use crate::{Assignment, Direction, Entry, Event, EventSource, Fault, Text};

/// Returns the two sides if the whole text is a comparison.
pub(super) fn compared(text: &Text) -> Option<[&str; 2]> {
    let expression = read(&text.text).ok()?;
    match expression.parts.last() {
        Some(Form::Comparison(_, left, right)) => {
            Some([left, right].map(|side| &text.text[expression.spans[*side].clone()]))
        }
        _ => None,
    }
}

/// Returns whether a text is a name, a number, or in parentheses.
fn is_whole(text: &str) -> bool {
    let is_word = text.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.' | '\''));
    let closes = |inner: &str| {
        let mut depth = 0_i32;
        inner.chars().all(|c| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            depth >= 0
        })
    };
    is_word || text.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).is_some_and(closes)
}

impl Elaborator<'_> {
    pub(super) fn events(&mut self) {
        for event in &self.source.events {
            let found = self.event(event);
            let found = self.beside(found, event.set.iter().map(|entry| &entry.value));
            if let Some(event) = self.kept(found) {
                self.model.events.push(event);
            }
        }
    }

    fn event(&mut self, source: &EventSource) -> Sound<Event> {
        if let Some([left, right]) = compared(&source.when) {
            let right = if is_whole(right) { right.to_owned() } else { format!("({right})") };
            let accepted = format!("when = \"{left} - {right}\", with direction = \"up\" or \"down\"");
            let title = "an event is an instant at which an expression passes zero";
            return Err(Box::new(Fault::at(source.when.span(), title, "a condition", accepted)));
        }
        let when = self.scalar_value(&source.when, "`when`", None)?;
        let direction = match &source.direction {
            None => Direction::Both,
            Some(word) => match word.text.trim() {
                "up" => Direction::Up,
                "down" => Direction::Down,
                "both" => Direction::Both,
                _ => {
                    let accepted = "\"up\", \"down\" or \"both\"";
                    let title = format!("`{}` is not a direction in which an expression passes zero", word.text.trim());
                    return Err(Box::new(Fault::at(word.span(), title, "not one of these", accepted)));
                }
            },
        };
        let mut set = Vec::new();
        for entry in &source.set {
            set.push(self.assignment(entry)?);
        }
        if set.is_empty() && !source.ends {
            let accepted = "set = { \"x'\" = \"-e*x'\" }, or end = true";
            return Err(Box::new(Fault::at(source.at.clone(), "this event changes nothing", "here", accepted)));
        }
        let name = source.name.as_ref().map_or_else(String::new, |name| name.text.clone());
        Ok(Event { name, when, direction, set, ends: source.ends, at: source.at.clone() })
    }

    /// Reads `"x'" = "-e*x'"`: the value after the event, from the values before it.
    fn assignment(&mut self, Entry { name, value }: &Entry) -> Sound<Assignment> {
        let (coordinate, order) = self.of_state(name)?;
        let needed = self.dimension_of_state(coordinate, order);
        let is = self.scalar_value(value, &format!("`{}`", name.text), Some(needed))?;
        if order == 0 && self.model.coordinates[coordinate].unit == "rad" {
            self.judge_angle_text(value);
        }
        Ok(Assignment { coordinate, order, is })
    }
}
