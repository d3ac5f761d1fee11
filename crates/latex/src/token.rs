//! Tokens of a formula: commands, letters, digits, braces and signs.

use crate::NotFormula;
use std::ops::Range;

/// The largest accepted length of a formula, in bytes.
const MOST_BYTES: usize = 20_000;

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Token {
    pub kind: Kind,
    pub span: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kind {
    /// A command, without its backslash.
    Command(String),
    Letter(char),
    Digit(char),
    Sign(char),
    /// `{`
    Open,
    /// `}`
    Close,
    /// A space that is printed: `\,`, `\quad`.
    Space,
}

impl Token {
    pub fn is_sign(&self, sign: char) -> bool {
        self.kind == Kind::Sign(sign)
    }

    pub fn is_command(&self, name: &str) -> bool {
        matches!(&self.kind, Kind::Command(own) if own == name)
    }
}

/// Commands that change only the size of the sign that follows.
const SIZES: [&str; 14] =
    ["left", "right", "big", "Big", "bigg", "Bigg", "bigl", "bigr", "Bigl", "Bigr", "biggl", "biggr", "Biggl", "Biggr"];
const STYLES: [&str; 4] = ["displaystyle", "textstyle", "limits", "nolimits"];
const SPACES: [&str; 10] = [",", ";", ":", "!", " ", "quad", "qquad", "thinspace", "medspace", "enspace"];

/// Splits a formula into tokens, checks that braces and parentheses match, and drops punctuation and spaces at the end.
pub(crate) fn tokens(text: &str) -> Result<Vec<Token>, NotFormula> {
    if text.len() > MOST_BYTES {
        let title = format!("this formula has {} bytes", text.len());
        return Err(NotFormula::at(0..1, title, "from here on", format!("up to {MOST_BYTES}")));
    }
    let mut tokens = Vec::new();
    let mut start = 0;
    while let Some(first) = text[start..].chars().next() {
        let mut end = start + first.len_utf8();
        let kind = match first {
            '\\' => {
                let letters = text[end..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len() - end);
                end += if letters > 0 { letters } else { text[end..].chars().next().map_or(0, char::len_utf8) };
                Some(command(&text[start + 1..end], start..end)?)
            }
            '~' => Some(Kind::Space),
            '{' => Some(Kind::Open),
            '}' => Some(Kind::Close),
            space if space.is_whitespace() => None,
            digit if digit.is_ascii_digit() => Some(Kind::Digit(digit)),
            letter if letter.is_alphabetic() => Some(Kind::Letter(letter)),
            '−' => Some(Kind::Sign('-')),
            '+' | '-' | '*' | '/' | '^' | '_' | '&' | '=' | '<' | '>' | '(' | ')' | '[' | ']' | ',' | '.' | ';'
            | '\'' => Some(Kind::Sign(first)),
            '$' => return Err(stray(start..end, "$", "the formula without dollar signs")),
            '%' => return Err(stray(start..end, "%", "the formula without comments")),
            '|' => return Err(stray(start..end, "|", r"\sqrt{x^2} for the size of x, or a letter of its own for it")),
            other => {
                return Err(stray(
                    start..end,
                    &other.to_string(),
                    "letters, digits, commands and + - * / ^ _ ( ) [ ] { } = < >",
                ));
            }
        };
        match kind {
            Some(Kind::Command(name)) if SIZES.contains(&name.as_str()) && is_blank(&text[end..]) => {
                return Err(stray(start..end, &format!("\\{name}."), "parentheses in pairs"));
            }
            Some(Kind::Command(name)) if SIZES.contains(&name.as_str()) || STYLES.contains(&name.as_str()) => {}
            Some(kind) => tokens.push(Token { kind, span: start..end }),
            None => {}
        }
        start = end;
    }
    paired(&tokens)?;
    while tokens
        .last()
        .is_some_and(|last| last.kind == Kind::Space || [',', '.', ';'].into_iter().any(|sign| last.is_sign(sign)))
    {
        tokens.pop();
    }
    Ok(tokens)
}

/// Returns whether a point follows, which after `\left` or `\right` means a delimiter that is not printed.
fn is_blank(rest: &str) -> bool {
    rest.trim_start().starts_with('.')
}

fn stray(span: Range<usize>, sign: &str, accepted: &str) -> NotFormula {
    NotFormula::at(span, format!("`{sign}` has no meaning here"), "not known here", accepted)
}

fn command(name: &str, span: Range<usize>) -> Result<Kind, NotFormula> {
    if name.is_empty() {
        return Err(stray(span, "\\", "the name of a command behind a backslash"));
    }
    Ok(match name {
        _ if SPACES.contains(&name) => Kind::Space,
        "lbrace" => Kind::Command("{".to_owned()),
        "rbrace" => Kind::Command("}".to_owned()),
        _ => Kind::Command(name.to_owned()),
    })
}

/// Returns an error if a brace or parenthesis has no partner of its own kind.
fn paired(tokens: &[Token]) -> Result<(), NotFormula> {
    let mut open: Vec<(&Token, &str)> = Vec::new();
    for token in tokens {
        let (opens, closes) = match &token.kind {
            Kind::Open => (Some("}"), None),
            Kind::Close => (None, Some("}")),
            Kind::Sign('(') => (Some(")"), None),
            Kind::Sign(')') => (None, Some(")")),
            Kind::Sign('[') => (Some("]"), None),
            Kind::Sign(']') => (None, Some("]")),
            Kind::Command(name) if name == "{" => (Some(r"\}"), None),
            Kind::Command(name) if name == "}" => (None, Some(r"\}")),
            _ => continue,
        };
        if let Some(partner) = opens {
            open.push((token, partner));
        } else if let Some(closing) = closes {
            match open.pop() {
                Some((_, partner)) if partner == closing => {}
                Some((before, partner)) => {
                    let title = format!("`{closing}` closes what `{partner}` should");
                    let accepted =
                        format!("`{partner}` here, the partner of the sign at byte {}", before.span.start + 1);
                    return Err(NotFormula::at(token.span.clone(), title, "another kind of bracket", accepted));
                }
                None => {
                    let title = format!("`{closing}` closes nothing");
                    let accepted = "braces and parentheses in pairs";
                    return Err(NotFormula::at(token.span.clone(), title, "without a partner", accepted));
                }
            }
        }
    }
    match open.pop() {
        Some((token, partner)) => {
            let title = format!("`{partner}` is missing");
            let accepted = "braces and parentheses in pairs";
            Err(NotFormula::at(token.span.clone(), title, "this one is not closed", accepted))
        }
        None => Ok(()),
    }
}
