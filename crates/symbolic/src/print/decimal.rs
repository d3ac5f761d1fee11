//! Constants as decimals, if these are shorter than fractions.

use field::Rational;

/// Fractions with denominators up to this one are not converted to decimals.
const LARGEST_DENOMINATOR: u64 = 16;

/// Decimals of at most this number of digits are exactly represented by their text after rounding to `f64`.
const DIGITS: usize = 15;

/// Returns a decimal that reads as exactly this constant: one of few digits, or the shortest representation of a floating-point number. Returns `None`
/// if a fraction is shorter, or if no such decimal exists.
pub(super) fn shorter(value: Rational) -> Option<String> {
    let big = value.to_big()?;
    if u64::try_from(big.denominator()).is_ok_and(|below| below <= LARGEST_DENOMINATOR) {
        return None;
    }
    let float = value.to_f64();
    if !float.is_finite() || float == 0.0 {
        return None;
    }
    let scientific = format!("{float:e}");
    let digits = scientific.chars().take_while(|c| *c != 'e').filter(char::is_ascii_digit).count();
    let is_same = if digits <= DIGITS { Rational::decimal(float) == value } else { Rational::exactly(float) == value };
    is_same.then(|| if (1e-4..1e6).contains(&float.abs()) { format!("{float}") } else { scientific })
}

#[cfg(test)]
mod tests {
    use super::shorter;
    use field::Rational;

    #[test]
    fn decimals_stand_where_they_are_exact_and_shorter() {
        assert_eq!(shorter(Rational::new(7, 20)).as_deref(), Some("0.35"));
        assert_eq!(shorter(Rational::new(5, 6)), None);
        assert_eq!(shorter(Rational::new(1, 300)), None);
        assert_eq!(shorter(Rational::exactly(0.965_925_826_289_068_3)).as_deref(), Some("0.9659258262890683"));
        assert_eq!(shorter(Rational::decimal(1.5e-9)).as_deref(), Some("1.5e-9"));
        assert_eq!(shorter(Rational::new(1, 2)), None);
    }
}
