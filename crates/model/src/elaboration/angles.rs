//! Warnings about angles without a unit: they are in radians, but degrees may have been meant.

use super::Elaborator;
use crate::expression::{Expression, Form, Part, read};
use crate::{Entry, Fault, Text};
use std::f64::consts::TAU;
use std::ops::Range;

/// Larger numbers, slightly more than a full turn in radians, may be degrees.
const MOST: f64 = 6.3;

/// Returns a warning if a number without a unit exceeds a full turn. `degrees` is the text for the same angle in degrees, with {} in place of
/// the number.
pub fn bare_angle(place: Range<usize>, written: &str, degrees: &str) -> Option<Fault> {
    let written = written.trim();
    let value = units::quantity::finite(written).ok().filter(|value| value.abs() > MOST)?;
    let title = format!("{written} rad are {:.1} turns", value.abs() / TAU);
    let accepted = format!("degrees are written {}", degrees.replace("{}", written));
    Some(Fault::at(place, title, "a number alone is in radians", accepted))
}

impl<'s> Elaborator<'s> {
    /// Warns if a number without a unit, used as an angle, exceeds a full turn. `degrees` is the text for the angle in degrees, with {} in place of
    /// the number.
    pub(super) fn judge_angle(&mut self, place: Range<usize>, written: &str, degrees: &str) {
        let is_known = self.model.warnings.iter().any(|known| known.span == place);
        self.model.warnings.extend(bare_angle(place, written, degrees).filter(|_| !is_known));
    }

    /// Warns about numbers without a unit in an expression that is an angle.
    pub(super) fn judge_angle_text(&mut self, text: &Text) {
        if let Ok(expression) = read(&text.text) {
            self.judge_terms(text, &expression, expression.whole());
        }
    }

    /// Warns about numbers without a unit wherever an expression contains an angle: in `sin`, `cos` and `tan`, and in sums and comparisons with a symbol
    /// that is an angle.
    pub(super) fn judge_angles(&mut self, text: &Text, expression: &Expression) {
        let mut inner = vec![false; expression.parts.len()];
        for (place, form) in expression.parts.iter().enumerate().rev() {
            match form {
                Form::Call { function, arguments } if matches!(function.as_str(), "sin" | "cos" | "tan") => {
                    arguments.iter().for_each(|argument| self.judge_terms(text, expression, argument.value));
                }
                Form::Sum(..) | Form::Difference(..) | Form::Comparison(..) if !inner[place] => {
                    let terms = terms_of(expression, place, &mut inner);
                    if terms.iter().any(|term| self.is_angle(&expression.parts[*term])) {
                        self.judge_terms(text, expression, place);
                    }
                }
                _ => {}
            }
        }
    }

    fn judge_terms(&mut self, text: &Text, expression: &Expression, part: Part) {
        for term in terms_of(expression, part, &mut vec![false; expression.parts.len()]) {
            match &expression.parts[term] {
                Form::Number(digits) => {
                    self.judge_angle(text.part(&expression.spans[term]), digits, "({} deg)");
                }
                Form::Name(name) => {
                    let source = self.source;
                    let named = |entries: &'s [Entry]| entries.iter().find(|entry| entry.name.text == *name);
                    if let Some(Entry { value, .. }) = named(&source.parameters) {
                        self.judge_angle(value.span(), &value.text, "\"{} deg\"");
                    } else if let Some(Entry { value, .. }) = named(&source.definitions) {
                        self.judge_angle_text(value);
                    }
                }
                _ => {}
            }
        }
    }

    /// Returns whether a symbol has an angular unit.
    fn is_angle(&self, form: &Form) -> bool {
        let Form::Name(name) = form else { return false };
        let of_angle = |written: &str| ["rad", "deg", "rev"].iter().any(|unit| written.ends_with(unit));
        self.model.coordinates.iter().any(|one| one.name == *name && one.unit == "rad")
            || self.model.parameters.iter().any(|one| one.name == *name && of_angle(&one.written))
    }
}

/// Returns the terms of a sum, or of both sides of a comparison. The sums inside are marked in `inner`.
fn terms_of(expression: &Expression, part: Part, inner: &mut [bool]) -> Vec<Part> {
    let (mut open, mut terms) = (vec![part], Vec::new());
    while let Some(part) = open.pop() {
        inner[part] = true;
        match &expression.parts[part] {
            Form::Sum(a, b) | Form::Difference(a, b) | Form::Comparison(_, a, b) => open.extend([*a, *b]),
            Form::Negation(a) => open.push(*a),
            _ => terms.push(part),
        }
    }
    terms
}
