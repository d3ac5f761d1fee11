//! Numbers with units in expressions.

use super::Reader;
use crate::expression::Form;
use crate::expression::token::{Placed, Token};

impl Reader<'_> {
    /// Reads a text that consists only of a number and a unit, `20 mm`. Only there the parentheses may be omitted.
    pub(super) fn whole_quantity(&mut self) -> bool {
        let Some((number, unit)) = self.text.trim().split_once(char::is_whitespace) else { return false };
        if number.parse::<f64>().is_err() || units::quantity::parse_any(self.text.trim()).is_err() {
            return false;
        }
        let form = Form::Quantity { number: number.to_owned(), unit: unit.trim().to_owned() };
        self.at = self.tokens.len();
        self.push(form, 0);
        true
    }

    /// Reads `(20 mm)` or `(-9.81 m/s^2)`: a number that is followed by a name without an operator between them.
    pub(super) fn quantity(&mut self) -> Option<Form> {
        let sign = usize::from(matches!(self.tokens.get(self.at + 1), Some((_, Token::Sign('-')))));
        let (number, Token::Number(_)) = self.tokens.get(self.at + 1 + sign)? else { return None };
        let (unit, first) = self.tokens.get(self.at + 2 + sign)?;
        let per = matches!(self.tokens.get(self.at + 3 + sign), Some((_, Token::Sign('/'))));
        // the unit `1/s` begins with a number
        let begins_unit = matches!(first, Token::Name(_)) || *first == Token::Number("1") && per;
        if !begins_unit {
            return None;
        }
        let rest = &self.tokens[self.at + 2 + sign..];
        let length = rest.iter().position(|(_, token)| *token == Token::Sign(')'))?;
        // after another operator the number was meant to have its own parentheses
        let is_unit = |(_, token): &Placed<'_>| !matches!(token, Token::Sign('(' | '+' | ',' | '<' | '>' | '≤' | '≥'));
        if !rest[..length].iter().all(is_unit) {
            return None;
        }
        let begin = self.tokens[self.at + 1].0.start;
        let form = Form::Quantity {
            number: self.text[begin..number.end].replace(' ', "").replace('−', "-"),
            unit: self.text[unit.start..rest[length].0.start].trim().to_owned(),
        };
        self.at += 3 + sign + length;
        Some(form)
    }
}
