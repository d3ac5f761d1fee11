//! Tokens of an expression: numbers, names and operators.

use super::{NotExpression, Reason};
use field::{Rational, Scalar};
use std::ops::Range;

/// The largest number of digits of a number, and the largest absolute exponent of ten.
const MOST: usize = 60;

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token<'a> {
    Number(&'a str),
    Name(&'a str),
    /// One of + - * / ^ ( )
    Sign(char),
}

/// Splits a text into tokens with their ranges of bytes.
pub(super) fn tokens(text: &str) -> Result<Vec<(Range<usize>, Token<'_>)>, NotExpression> {
    let mut tokens = Vec::new();
    let mut start = 0;
    while let Some(first) = text[start..].chars().next() {
        let length = match first {
            _ if first.is_whitespace() => {
                start += first.len_utf8();
                continue;
            }
            _ if first.is_ascii_digit() || first == '.' => number_length(&text[start..]),
            _ if begins_name(first) => text[start..].find(|c| !continues_name(c)).unwrap_or(text.len() - start),
            _ => first.len_utf8(),
        };
        let span = start..start + length;
        let token = match first {
            '+' | '-' | '*' | '/' | '^' | '(' | ')' => Token::Sign(first),
            // the minus sign of printed mathematics, U+2212
            '−' => Token::Sign('-'),
            _ if first.is_ascii_digit() || first == '.' => Token::Number(&text[span.clone()]),
            _ if begins_name(first) => Token::Name(&text[span.clone()]),
            _ => return Err(NotExpression { span, reason: Reason::Letter(first) }),
        };
        tokens.push((span, token));
        start += length;
    }
    Ok(tokens)
}

fn begins_name(letter: char) -> bool {
    letter.is_alphabetic() || letter == '_'
}

/// Returns whether a character may continue a name: a letter, digit, combining mark, superscript, star or prime.
fn continues_name(letter: char) -> bool {
    begins_name(letter) || letter.is_numeric() || matches!(letter, '\u{300}'..='\u{36f}' | '′' | '″' | '\'' | '⋆' | '°')
}

/// Returns the length of the number at the start of the text: digits, an optional decimal point, an optional exponent.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |n| from + n);
    let mut end = digits(0);
    if text[end..].starts_with('.') {
        end = digits(end + 1);
    }
    let exponent = &text[end..];
    if exponent.starts_with(['e', 'E']) {
        let sign = usize::from(exponent[1..].starts_with(['+', '-']));
        let after = digits(end + 1 + sign);
        if after > end + 1 + sign {
            end = after;
        }
    }
    end
}

/// Returns the exact value of a decimal number.
pub(super) fn number(text: &str) -> Option<Rational> {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, part) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent: i64 = exponent.parse::<i64>().ok()?.checked_sub(i64::try_from(part.len()).ok()?)?;
    let written = whole.len() + part.len();
    if written == 0 || written > MOST || usize::try_from(exponent.abs()).ok()? > MOST {
        return None;
    }
    let ten = Rational::int(10);
    let digit = |value: Rational, byte: u8| value * ten + Rational::int(i64::from(byte - b'0'));
    let digits = whole.bytes().chain(part.bytes()).fold(Rational::int(0), digit);
    let scale = (0..exponent.abs()).fold(Rational::int(1), |scale, _| scale * ten);
    Some(if exponent < 0 { digits / scale } else { digits * scale })
}
