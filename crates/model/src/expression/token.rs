//! Tokens of an expression, with their ranges of bytes.

use super::{NotExpression, Reason};
use std::ops::Range;

/// The largest accepted length of an expression, in bytes.
const LONGEST: usize = 20_000;

/// A number, a name or an operator.
#[derive(Clone, Debug, PartialEq)]
pub enum Token<'a> {
    Number(&'a str),
    Name(&'a str),
    /// A name in quotes, which may contain spaces: the name of a constraint.
    Quoted(&'a str),
    /// One of `+ - * / ^ ( ) , < > ≤ ≥`.
    Sign(char),
    /// ` . ` with spaces on both sides: the scalar product.
    Dot,
    /// `.` within `N.x`, which selects a member of the preceding name.
    Part,
}

/// A token with its range of bytes.
pub type Placed<'a> = (Range<usize>, Token<'a>);

/// Splits a text into tokens with their ranges of bytes.
pub fn tokens(text: &str) -> Result<Vec<Placed<'_>>, NotExpression> {
    if text.len() > LONGEST {
        return Err(NotExpression { span: 0..0, reason: Reason::Long { most: LONGEST } });
    }
    let mut tokens: Vec<Placed<'_>> = Vec::new();
    let mut start = 0;
    while let Some(first) = text[start..].chars().next() {
        let rest = &text[start..];
        let (length, token) = match first {
            _ if first.is_whitespace() => {
                start += first.len_utf8();
                continue;
            }
            _ if first.is_ascii_digit() || (first == '.' && begins_with_digit(&rest[1..])) => {
                let length = number_length(rest);
                (length, Token::Number(&rest[..length]))
            }
            _ if begins_name(first) => {
                let length = rest.find(|c| !continues_name(c)).unwrap_or(rest.len());
                (length, Token::Name(&rest[..length]))
            }
            '"' => match rest[1..].find('"') {
                Some(length) => (length + 2, Token::Quoted(&rest[1..=length])),
                None => return Err(NotExpression { span: start..start + 1, reason: Reason::Letter('"') }),
            },
            '.' => (1, dot(&text[..start], &rest[1..], start)?),
            '<' | '>' if rest[1..].starts_with('=') => (2, Token::Sign(if first == '<' { '≤' } else { '≥' })),
            '+' | '-' | '*' | '/' | '^' | '(' | ')' | ',' | '<' | '>' | '≤' | '≥' => {
                (first.len_utf8(), Token::Sign(first))
            }
            '=' => return Err(NotExpression { span: start..start + 1, reason: Reason::Equation }),
            // the printed minus sign, U+2212
            '−' => (first.len_utf8(), Token::Sign('-')),
            '·' | '×' => {
                return Err(NotExpression { span: start..start + first.len_utf8(), reason: Reason::Product });
            }
            _ => return Err(NotExpression { span: start..start + first.len_utf8(), reason: Reason::Letter(first) }),
        };
        tokens.push((start..start + length, token));
        start += length;
    }
    Ok(tokens)
}

/// Returns the token of a point: between two names without spaces it selects a member, with spaces on both sides it is the scalar product.
fn dot(before: &str, after: &str, start: usize) -> Result<Token<'static>, NotExpression> {
    let spaced = [before.chars().next_back(), after.chars().next()].map(|next| next.is_some_and(char::is_whitespace));
    let named = [before.chars().next_back().is_some_and(continues_name), after.chars().next().is_some_and(begins_name)];
    match (spaced, named) {
        ([true, true], _) => Ok(Token::Dot),
        (_, [true, true]) => Ok(Token::Part),
        _ => Err(NotExpression { span: start..start + 1, reason: Reason::Dot }),
    }
}

fn begins_with_digit(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit())
}

fn begins_name(letter: char) -> bool {
    letter.is_alphabetic() || letter == '_'
}

/// Returns whether a character may continue a name: a letter, digit, combining mark or prime.
fn continues_name(letter: char) -> bool {
    begins_name(letter) || letter.is_numeric() || matches!(letter, '\u{300}'..='\u{36f}' | '′' | '″' | '\'')
}

/// Returns the length of the number at the start of the text: digits, an optional decimal point, an optional exponent.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| text[from..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |n| from + n);
    let mut end = digits(0);
    if text[end..].starts_with('.') && !text[end + 1..].starts_with(begins_name) {
        end = digits(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) {
        let sign = usize::from(text[end + 1..].starts_with(['+', '-']));
        let after = digits(end + 1 + sign);
        if after > end + 1 + sign {
            end = after;
        }
    }
    end
}

/// Returns whether the text is a single name of the language.
pub fn is_name(text: &str) -> bool {
    text.starts_with(begins_name) && text.chars().all(continues_name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_a_decimal_a_part_or_a_product_by_what_stands_around_it() {
        fn kinds(text: &str) -> Result<Vec<Token<'_>>, NotExpression> {
            tokens(text).map(|all| all.into_iter().map(|(_, token)| token).collect())
        }
        assert_eq!(kinds("2.5e-3"), Ok(vec![Token::Number("2.5e-3")]));
        assert_eq!(kinds("N.x"), Ok(vec![Token::Name("N"), Token::Part, Token::Name("x")]));
        assert_eq!(kinds("a . b"), Ok(vec![Token::Name("a"), Token::Dot, Token::Name("b")]));
        assert_eq!(kinds("a .b").map_err(|wrong| wrong.reason), Err(Reason::Dot));
        assert_eq!(kinds("theta' <= .5"), Ok(vec![Token::Name("theta'"), Token::Sign('≤'), Token::Number(".5")]));
    }
}
