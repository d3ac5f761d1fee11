//! Numbers as text: coordinates with fixed decimals, values for readers.

/// A coordinate rounded to a tenth of a pixel, without a superfluous `.0` or `-0`.
pub(crate) fn coordinate(x: f64) -> String {
    tenths(x).to_string_tenths()
}

/// A coordinate in tenths of a pixel. Relative paths in integers accumulate no rounding errors.
pub(crate) fn tenths(x: f64) -> Tenths {
    Tenths((x * 10.0).round() as i64)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Tenths(pub i64);

impl Tenths {
    pub fn to_string_tenths(self) -> String {
        let sign = if self.0 < 0 { "-" } else { "" };
        let (whole, tenth) = (self.0.unsigned_abs() / 10, self.0.unsigned_abs() % 10);
        match (whole, tenth) {
            (whole, 0) => format!("{sign}{whole}"),
            (0, tenth) => format!("{sign}.{tenth}"),
            (whole, tenth) => format!("{sign}{whole}.{tenth}"),
        }
    }
}

/// A value with a number of significant digits: decimal between 0.001 and a million, with a power of ten elsewhere. NaN is `undefined`,
/// an infinite value `unbounded`.
pub fn significant(value: f64, digits: usize) -> String {
    match value {
        0.0 => return "0".to_owned(),
        value if value.is_nan() => return "undefined".to_owned(),
        value if value.is_infinite() => return "unbounded".to_owned(),
        _ => {}
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = if (-3..6).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        trim(&format!("{value:.decimals$}"))
    } else {
        format!("{}·10{}", trim(mantissa), superscript(exponent))
    };
    text.replace('-', "−")
}

/// A tolerance as text, as a power of ten where it is one; `none` for NaN, the tolerance of a method with constant steps.
pub fn tolerance(value: f64) -> String {
    if value.is_nan() {
        return "none".to_owned();
    }
    match format!("{value:.1e}").split_once('e') {
        Some(("1.0", exponent)) => format!("10{}", superscript(exponent.parse().unwrap_or(0))),
        _ => significant(value, 2),
    }
}

fn trim(decimal: &str) -> String {
    if decimal.contains('.') {
        decimal.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        decimal.to_owned()
    }
}

/// An integer in superscript digits.
pub(crate) fn superscript(value: i32) -> String {
    let raise = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    value.to_string().chars().map(raise).collect()
}

/// An integer with its digits in groups of three; any other number with four significant digits.
pub(crate) fn counted(value: f64) -> String {
    if value.fract() != 0.0 || value.abs() >= 1e15 {
        return significant(value, 4);
    }
    let digits = format!("{:.0}", value.abs());
    let mut out = String::new();
    for (position, digit) in digits.chars().enumerate() {
        if position > 0 && (digits.len() - position).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(digit);
    }
    if value < 0.0 { format!("−{out}") } else { out }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_have_one_decimal_at_most() {
        let shown: Vec<_> = [1.0, -0.04, 0.25, -0.3, 12.34].map(coordinate).into();
        assert_eq!(shown, ["1", "0", ".3", "-.3", "12.3"]);
    }

    #[test]
    fn values_are_short_and_signs_are_minus_signs() {
        let shown: Vec<_> = [0.0, -1.5, 123456.0, 3.2e-9, 1e7].map(|v| significant(v, 3)).into();
        assert_eq!(shown, ["0", "−1.5", "123456", "3.2·10⁻⁹", "1·10⁷"]);
    }

    #[test]
    fn thousands_stand_apart() {
        assert_eq!(counted(1234567.0), "1\u{202f}234\u{202f}567");
        assert_eq!(counted(-12.0), "−12");
    }
}
