//! Numbers with units: scalars, vectors and matrices, converted to SI units.

use super::{At, Table};
use crate::issue::Issue;
use nalgebra::{Matrix3, Vector3};
use std::ops::Range;
use toml::de::DeValue;
use units::Dimension;
use units::quantity::{self, NoQuantity};

impl Table<'_> {
    /// Reads a number with a unit of the dimension of `unit`. Returns the value in SI units; the replacement of a wrong or missing value is 1.
    pub fn scalar(&mut self, key: &str, meaning: &str, unit: &str) -> At<f64> {
        let found = self.numbers(key, meaning, 1, 1, Dimension::of(unit));
        At { value: found.value[0], span: found.span }
    }

    /// Reads a number with a unit of any dimension. Returns the value in SI units and the dimension; `None` if the key is absent or its value wrong.
    pub fn of_any_unit(&mut self, key: &str) -> Option<At<(f64, Dimension)>> {
        let found = self.find(key)?;
        let span = found.span();
        let read = match found.get_ref() {
            DeValue::String(text) => quantity::parse_any(text),
            DeValue::Float(number) => quantity::parse_any(number.as_str()),
            DeValue::Integer(number) if number.radix() == 10 => quantity::parse_any(number.as_str()),
            other => {
                self.wrong_kind(span, key, other, &format!("a parameter is written so: {key} = \"0.15 N m\""));
                return None;
            }
        };
        match read {
            Ok(value) => Some(At { value, span }),
            Err(wrong) => {
                let title = format!("the parameter `{key}` cannot be read");
                self.report(Issue::at(span, title, wrong.to_string()).accepted("a number and its unit: \"0.15 N m\""));
                None
            }
        }
    }

    /// Reads an optional number with a unit of the dimension of `unit`, in SI units.
    pub fn optional_scalar(&mut self, key: &str, meaning: &str, unit: &str) -> Option<At<f64>> {
        self.find(key).is_some().then(|| self.scalar(key, meaning, unit))
    }

    /// Reads three components with one unit, in SI units.
    pub fn vector(&mut self, key: &str, meaning: &str, unit: &str) -> At<Vector3<f64>> {
        let found = self.numbers(key, meaning, 1, 3, Dimension::of(unit));
        At { value: Vector3::from_row_slice(&found.value), span: found.span }
    }

    /// Reads a 3 x 3 matrix, its rows separated by semicolons, with one unit, in SI units.
    pub fn matrix(&mut self, key: &str, meaning: &str, unit: &str) -> At<Matrix3<f64>> {
        let found = self.numbers(key, meaning, 3, 3, Dimension::of(unit));
        At { value: Matrix3::from_row_slice(&found.value), span: found.span }
    }

    /// Reads an optional row of `columns` numbers with one unit, in SI units.
    pub fn optional_row(&mut self, key: &str, meaning: &str, columns: usize, unit: &str) -> Option<At<Vec<f64>>> {
        self.optional_rows(key, meaning, 1, columns, unit)
    }

    /// Reads optional `rows` rows of `columns` numbers with one unit, in SI units, row after row.
    pub fn optional_rows(
        &mut self,
        key: &str,
        meaning: &str,
        rows: usize,
        columns: usize,
        unit: &str,
    ) -> Option<At<Vec<f64>>> {
        self.find(key).is_some().then(|| self.numbers(key, meaning, rows, columns, Dimension::of(unit)))
    }

    fn numbers(&mut self, key: &str, meaning: &str, rows: usize, columns: usize, needed: Dimension) -> At<Vec<f64>> {
        let harmless = vec![1.0; rows * columns];
        let Some(found) = self.find(key) else {
            let example = quantity::example(rows, columns, needed);
            self.missing_number(key, &format!("{}, such as {key} = {example}", with_article(meaning)));
            return At { value: harmless, span: self.span() };
        };
        let span = found.span();
        let read = match found.get_ref() {
            DeValue::String(text) => quantity::parse(text, rows, columns, needed),
            DeValue::Float(number) => quantity::parse(number.as_str(), rows, columns, needed),
            DeValue::Integer(number) if number.radix() == 10 => quantity::parse(number.as_str(), rows, columns, needed),
            other => {
                let example = quantity::example(rows, columns, needed);
                self.wrong_kind(span.clone(), key, other, &format!("the {meaning} is written so: {example}"));
                return At { value: harmless, span };
            }
        };
        let value = read.unwrap_or_else(|wrong| {
            self.report(of_quantity(key, meaning, span.clone(), &wrong, &wrong.accepted(rows, columns, needed)));
            harmless
        });
        At { value, span }
    }
}

/// Puts an article before the meaning of a datum: `the mass`; for a meaning that begins with its letter in formulas, `m, the mass`.
pub(super) fn with_article(meaning: &str) -> String {
    match meaning.split_once(", ") {
        Some((letter, rest)) if !letter.contains(' ') || letter.contains(" + ") => format!("{letter}, the {rest}"),
        _ if meaning.starts_with("a ") => meaning.to_owned(),
        _ => format!("the {meaning}"),
    }
}

fn of_quantity(key: &str, meaning: &str, span: Range<usize>, wrong: &NoQuantity, accepted: &str) -> Issue {
    let title = format!("`{key}`, {}, cannot be read", with_article(meaning));
    Issue::at(span, title, wrong.to_string()).accepted(accepted)
}
