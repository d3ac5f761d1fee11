//! The value of a quantity as an option gives it: `m=0.5`.

/// Parses a name with a number in SI units.
pub(crate) fn named_value(text: &str) -> Result<(String, f64), String> {
    let accepted = || "a name with a number in SI units, without the unit, such as m=0.5, is accepted".to_owned();
    let (name, value) = text.split_once('=').ok_or_else(accepted)?;
    let value = value.trim().parse().ok().filter(|value: &f64| value.is_finite()).ok_or_else(accepted)?;
    Ok((name.trim().to_owned(), value))
}
