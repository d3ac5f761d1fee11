//! Numbers of a formula: decimals, exponents and limits of sums.

use field::{Rational, Scalar};

const MOST_DIGITS: usize = 400;

/// Returns the exact value of digits with an optional decimal point.
pub(super) fn decimal(digits: &str) -> Option<Rational> {
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    if whole.is_empty() || digits.ends_with('.') || whole.len() + part.len() > MOST_DIGITS {
        return None;
    }
    let ten = Rational::int(10);
    let value = whole
        .bytes()
        .chain(part.bytes())
        .fold(Rational::int(0), |value, byte| value * ten + Rational::int(i64::from(byte - b'0')));
    Some(part.bytes().fold(value, |value, _| value / ten))
}

/// Reads an integer of at most nine digits, with an optional minus sign.
pub(super) fn whole(text: &str) -> Option<i64> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let is_plain = !digits.is_empty() && digits.len() <= 9 && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_plain.then(|| text.parse().ok()).flatten()
}

/// Reads an exponent: an integer or a half-integer. Returns (numerator, denominator) in lowest terms; `None` if the numerator exceeds 64.
pub(super) fn power(spelt: &str) -> Option<(i32, u32)> {
    let (above, below) = match spelt.strip_prefix("-") {
        Some(rest) => fraction(rest).map(|(above, below)| (-above, below))?,
        None => fraction(spelt)?,
    };
    let small = above.unsigned_abs() <= 64;
    match below {
        1 if small => Some((above, 1)),
        2 if small && above % 2 == 0 => Some((above / 2, 1)),
        2 if small => Some((above, 2)),
        _ => None,
    }
}

fn fraction(text: &str) -> Option<(i32, u32)> {
    let number = |text: &str| whole(text).filter(|value| *value >= 0).and_then(|value| i32::try_from(value).ok());
    if let Some(value) = number(text) {
        return Some((value, 1));
    }
    let slash = text.split_once('/');
    let stacked = ["\\frac", "\\tfrac", "\\dfrac"].into_iter().find_map(|name| {
        let rest = text.strip_prefix(name)?;
        match rest.strip_prefix('{').and_then(|rest| rest.strip_suffix('}')) {
            Some(inner) => inner.split_once("}{"),
            None => {
                let rest = rest.trim_start();
                (rest.len() == 2 && rest.is_ascii()).then(|| rest.split_at(1))
            }
        }
    });
    let (above, below) = stacked.or(slash)?;
    Some((number(above)?, u32::try_from(number(below)?).ok()?))
}
