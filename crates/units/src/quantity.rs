//! Quantities as text: numbers, then a unit, as in `"1 0 2.5 mm"`.

use crate::{Dimension, NoUnit, Unit};
use std::fmt;

/// The reason why a text is not a quantity of the required shape and dimension.
#[derive(Clone, Debug, PartialEq)]
pub enum NoQuantity {
    /// A number is missing.
    NoNumber,
    /// The number is `nan` or `inf`, or is too large for double precision.
    NotFinite { text: String },
    /// The numbers have the wrong shape: `rows` rows of `columns` numbers are required. `found` lists the length of each row of the text.
    Shape { rows: usize, columns: usize, found: Vec<usize> },
    /// The unit is not valid.
    Unit(NoUnit),
    /// The unit has a dimension other than the required one.
    Dimension { found: Dimension, needed: Dimension },
    /// The unit is missing, but the required quantity is not a pure number.
    UnitMissing { needed: Dimension },
}

/// Reads `rows` rows, separated by semicolons, of `columns` numbers each, followed by one unit of the dimension `needed`.
/// Returns the values in SI units, row after row.
///
/// # Errors
/// The numbers are missing, not finite or of another shape; or the unit is missing, invalid or of another dimension.
pub fn parse(text: &str, rows: usize, columns: usize, needed: Dimension) -> Result<Vec<f64>, NoQuantity> {
    let (numbers, unit_text) = split(text);
    let mut found = Vec::new();
    let mut values = Vec::new();
    for row in numbers.split(';') {
        let before = values.len();
        for word in row.split_whitespace() {
            values.push(finite(word)?);
        }
        found.push(values.len() - before);
    }
    if values.is_empty() {
        return Err(NoQuantity::NoNumber);
    }
    let unit = Unit::parse(unit_text).map_err(NoQuantity::Unit)?;
    if found.len() != rows || found.iter().any(|&n| n != columns) {
        return Err(NoQuantity::Shape { rows, columns, found });
    }
    if unit_text.is_empty() && !needed.is_number() {
        return Err(NoQuantity::UnitMissing { needed });
    }
    if unit.dimension() != needed {
        return Err(NoQuantity::Dimension { found: unit.dimension(), needed });
    }
    let values: Vec<f64> = values.into_iter().map(|x| unit.to_si(x)).collect();
    match values.iter().find(|x| !x.is_finite()) {
        Some(value) => Err(NoQuantity::NotFinite { text: value.to_string() }),
        None => Ok(values),
    }
}

/// Reads one number with a unit of any dimension. Returns the value in SI units, and the dimension.
///
/// # Errors
/// The number is missing or not finite, there are several numbers, or the unit is invalid.
pub fn parse_any(text: &str) -> Result<(f64, Dimension), NoQuantity> {
    let dimension = Unit::parse(split(text).1).map_err(NoQuantity::Unit)?.dimension();
    let values = parse(text, 1, 1, dimension)?;
    values.first().map(|&value| (value, dimension)).ok_or(NoQuantity::NoNumber)
}

/// Reads a finite number in the notation of Rust or TOML, which allows underscores: `1_000.5`.
///
/// # Errors
/// The text is no number, or the number is not finite.
pub fn finite(word: &str) -> Result<f64, NoQuantity> {
    match word.replace('_', "").parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(NoQuantity::NotFinite { text: word.to_owned() }),
        Err(_) => Err(NoQuantity::NoNumber),
    }
}

/// Splits a text into its numbers and its unit. The unit begins at the first word that is not a number.
fn split(text: &str) -> (&str, &str) {
    let text = text.trim();
    let mut start = None;
    for (i, c) in text.char_indices().chain([(text.len(), ' ')]) {
        match (start, c.is_whitespace() || c == ';') {
            (None, false) => start = Some(i),
            (Some(from), true) => {
                let word = &text[from..i];
                if word.replace('_', "").parse::<f64>().is_err() {
                    return (&text[..from], &text[from..]);
                }
                start = None;
            }
            _ => {}
        }
    }
    (text, "")
}

/// Rows with more numbers are abbreviated in examples.
const MOST_SHOWN: usize = 9;

/// Returns an example of a quantity with the given shape and dimension, in quotes: `"0 0 1 kg"`.
pub fn example(rows: usize, columns: usize, needed: Dimension) -> String {
    let row =
        vec!["0"; columns.min(MOST_SHOWN).saturating_sub(1)].into_iter().chain(["1"]).collect::<Vec<_>>().join(" ");
    let row = if columns > MOST_SHOWN { format!("{columns} numbers: 0 ... {row}") } else { row };
    let numbers = if rows == 3 && columns == 3 { "1 0 0; 0 1 0; 0 0 1".to_owned() } else { vec![row; rows].join("; ") };
    match needed.usual().first() {
        Some(unit) if !needed.is_number() => format!("\"{numbers} {unit}\""),
        _ => format!("\"{numbers}\""),
    }
}

impl NoQuantity {
    /// Returns a sentence that states which quantities are accepted, for a quantity of this shape and dimension.
    pub fn accepted(&self, rows: usize, columns: usize, needed: Dimension) -> String {
        let example = example(rows, columns, needed);
        let units = needed.usual();
        let listed = units.iter().map(|unit| format!("`{unit}`")).collect::<Vec<_>>().join(", ");
        match self {
            Self::NoNumber | Self::NotFinite { .. } | Self::Shape { .. } => format!("written so: {example}"),
            Self::Unit(_) | Self::Dimension { .. } | Self::UnitMissing { .. } if needed.is_number() => {
                format!("a pure number or an angle is accepted: {example}")
            }
            _ if units.is_empty() => format!("a unit of the dimension {needed} is accepted"),
            _ => format!("units of the dimension {needed} are accepted: {listed}"),
        }
    }
}

impl fmt::Display for NoQuantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoNumber => write!(f, "no number"),
            Self::NotFinite { text } => write!(f, "`{text}` is not finite: a finite number is needed"),
            Self::Shape { rows: 1, columns: 1, found } => {
                write!(f, "{} numbers where one is needed", found.iter().sum::<usize>())
            }
            Self::Shape { rows: 1, columns, found } => {
                write!(f, "{} numbers where {columns} are needed", found.iter().sum::<usize>())
            }
            Self::Shape { rows, columns, found } => {
                let found = found.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
                write!(f, "{rows} rows of {columns} numbers are needed; found rows of {found}")
            }
            Self::Unit(unit) => write!(f, "{unit}"),
            Self::Dimension { found, needed } => write!(f, "this is {found}, but must be {needed}"),
            Self::UnitMissing { needed } => write!(f, "no unit, but must be {needed}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::example;
    use crate::Dimension;

    #[test]
    fn an_example_of_many_numbers_is_short() {
        assert_eq!(example(1, 3, Dimension::of("kg")), "\"0 0 1 kg\"");
        assert_eq!(example(1, 10_000, Dimension::of("kg")), "\"10000 numbers: 0 ... 0 0 0 0 0 0 0 0 1 kg\"");
    }
}
