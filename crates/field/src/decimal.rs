//! Conversion between double-double and decimal digits, correctly rounded.

use crate::DoubleDouble;
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

/// The number with `places` decimal places; `None` where it is not finite.
pub fn decimal(number: DoubleDouble, places: usize) -> Option<String> {
    let exact = RBig::try_from(number.hi()).ok()? + RBig::try_from(number.lo()).ok()?;
    let negative = *exact.numerator() < IBig::ZERO;
    let (numerator, denominator) = exact.into_parts();
    let (_, size) = numerator.into_parts();
    let scaled = (size * power(places) * UBig::from(2u8) + &denominator) / (denominator * UBig::from(2u8));
    let digits = format!("{:0>width$}", scaled.to_string(), width = places + 1);
    let (whole, part) = digits.split_at(digits.len() - places);
    let sign = if negative && scaled != UBig::ZERO { "-" } else { "" };
    Some(if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") })
}

/// The double-double nearest to a decimal number such as `-12.0345`; `None` where the text is no such number.
pub fn from_decimal(text: &str) -> Option<DoubleDouble> {
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let (whole, part) = unsigned.split_once('.').unwrap_or((unsigned, ""));
    let digits = [whole, part].concat();
    if whole.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let numerator: IBig = digits.parse().ok()?;
    let numerator = if unsigned.len() < text.len() { -numerator } else { numerator };
    let exact = RBig::from_parts(numerator, power(part.len()));
    let high = exact.to_f64().value();
    let low = (exact - RBig::try_from(high).ok()?).to_f64().value();
    Some(DoubleDouble::from(high) + DoubleDouble::from(low))
}

fn power(places: usize) -> UBig {
    UBig::from(10u8).pow(places)
}
