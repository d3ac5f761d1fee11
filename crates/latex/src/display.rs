//! Display formulas: splits environments with several lines, and formulas with double signs, into single formulas.

use crate::NotFormula;
use crate::name::argument_end;
use crate::token::{Kind, Token, tokens};
use std::ops::Range;

/// Environments whose content is one or more lines of formulas.
const ENVIRONMENTS: &str = "aligned align align* alignedat split gathered gather gather* multline multline* eqnarray eqnarray* \
    equation equation* displaymath math";

/// Commands for numbers of formulas and for line breaks, with the number of their arguments.
const NUMBERS: [(&str, usize); 5] = [("tag", 1), ("label", 1), ("nonumber", 0), ("notag", 0), ("displaybreak", 0)];

/// One formula of a display.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Displayed {
    /// The label of the formula within the display: `1`, `upper`, `2/lower`; empty for a single formula.
    pub name: String,
    /// The text of the formula. Parts of the display outside the formula are replaced by blanks, so that byte `i` here is byte `start + i` of the display.
    pub text: String,
    /// The byte of the display at which the formula begins.
    pub start: usize,
}

/// Returns the formulas of a display. A line that begins with a relation continues the previous line, as does a line after one that ends with
/// an operator. `\pm` and `\mp` give two formulas: one with all upper signs and one with all lower signs.
///
/// # Errors
/// A line begins with a sign, and may either continue the previous line or be a formula of its own.
pub fn formulas(text: &str) -> Result<Vec<Displayed>, NotFormula> {
    let plain = || vec![Displayed { name: String::new(), text: text.to_owned(), start: 0 }];
    // a text that has no tokens gives its error when the formula is read
    let Ok(tokens) = tokens(text) else { return Ok(plain()) };
    let whole = unwrapped(&tokens);
    let is_plain = |token: &Token| !["pm", "mp", "\\"].into_iter().any(|name| token.is_command(name));
    let is_numbered = |token: &Token| NUMBERS.iter().any(|(name, _)| token.is_command(name));
    if whole == (0..tokens.len()) && tokens.iter().all(|token| is_plain(token) && !is_numbered(token)) {
        return Ok(plain());
    }
    let lines = lines(&tokens, whole, text)?;
    if lines.is_empty() {
        return Ok(plain());
    }
    let count = lines.len();
    let mut all = Vec::new();
    for (place, range) in lines.into_iter().enumerate() {
        let number = if count > 1 { (place + 1).to_string() } else { String::new() };
        let held = &tokens[range];
        let (Some(first), Some(last)) = (held.first(), held.last()) else { continue };
        let start = first.span.start;
        let mut line = text[start..last.span.end].to_owned();
        for span in blanks(held) {
            let blank = " ".repeat(span.len());
            line.replace_range(span.start - start..span.end - start, &blank);
        }
        let doubled = held.iter().any(|token| token.is_command("pm") || token.is_command("mp"));
        if !doubled {
            all.push(Displayed { name: number, text: line, start });
            continue;
        }
        for (name, plus, minus) in [("upper", "pm", "mp"), ("lower", "mp", "pm")] {
            let mut one = line.clone();
            for token in held {
                let sign = match &token.kind {
                    Kind::Command(command) if command == plus => "+",
                    Kind::Command(command) if command == minus => "-",
                    _ => continue,
                };
                one.replace_range(token.span.start - start..token.span.end - start, &format!("{sign:<3}"));
            }
            let name = if number.is_empty() { name.to_owned() } else { format!("{number}/{name}") };
            all.push(Displayed { name, text: one, start });
        }
    }
    Ok(all)
}

/// Returns the range of tokens inside the outer environments of a display.
fn unwrapped(tokens: &[Token]) -> Range<usize> {
    let mut range = 0..tokens.len();
    loop {
        let Some(begin) = environment(tokens, range.start, "begin") else { return range };
        let Some(end) = (range.start..range.end).rev().find(|&at| tokens[at].is_command("end")) else { return range };
        let closes = environment(tokens, end, "end").is_some_and(|close| close.1 == range.end && close.0 == begin.0);
        if !closes || !ENVIRONMENTS.split_whitespace().any(|known| known == begin.0) {
            return range;
        }
        range = begin.1..end;
        // the argument of `alignedat` is the number of columns
        if begin.0 == "alignedat" {
            range.start = argument_end(tokens, range.start).unwrap_or(range.start);
        }
    }
}

/// Returns the name of the environment whose `\begin` or `\end` stands at `at`, and the end of that name.
fn environment(tokens: &[Token], at: usize, command: &str) -> Option<(String, usize)> {
    tokens.get(at).filter(|token| token.is_command(command))?;
    let end = argument_end(tokens, at + 1)?;
    let name = tokens[at + 1..end].iter().filter_map(|token| match token.kind {
        Kind::Letter(letter) | Kind::Sign(letter) => Some(letter),
        _ => None,
    });
    Some((name.collect(), end))
}

/// Returns the ranges of tokens of the single formulas.
fn lines(tokens: &[Token], whole: Range<usize>, text: &str) -> Result<Vec<Range<usize>>, NotFormula> {
    let mut depth = 0usize;
    let mut breaks = Vec::new();
    for at in whole.clone() {
        match &tokens[at].kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Command(name) if name == "begin" => depth += 1,
            Kind::Command(name) if name == "end" => depth = depth.saturating_sub(1),
            Kind::Command(name) if name == "\\" && depth == 0 => breaks.push(at),
            _ => {}
        }
    }
    let mut all: Vec<Range<usize>> = Vec::new();
    let mut start = whole.start;
    for end in breaks.into_iter().chain([whole.end]) {
        let line = start..end;
        start = end + 1;
        let content: Vec<&Token> = tokens[line.clone()].iter().filter(|token| is_content(token)).collect();
        let Some(first) = content.first() else { continue };
        let Some(last) = all.last_mut() else {
            all.push(line);
            continue;
        };
        let before: Vec<&Token> = tokens[last.clone()].iter().filter(|token| is_content(token)).collect();
        let goes_on = super::reader::is_relation(first) || before.last().is_some_and(|last| is_open(last));
        let is_signed = first.is_sign('+') || first.is_sign('-') || first.is_command("pm") || first.is_command("mp");
        let relates = |tokens: &[&Token]| tokens.iter().any(|token| super::reader::is_relation(token));
        match (goes_on, is_signed) {
            (true, _) => last.end = line.end,
            (false, true) if !relates(&content) => last.end = line.end,
            (false, true) => {
                let title = "a line that begins with a sign goes on with the line before, or is a formula of its own";
                let accepted = "the sign at the end of the line before, or parentheses about the side: (-a) = b";
                let written = &text[first.span.clone()];
                return Err(NotFormula::at(first.span.clone(), title, format!("`{written}` of which line?"), accepted));
            }
            (false, false) => all.push(line),
        }
    }
    Ok(all)
}

fn is_content(token: &Token) -> bool {
    token.kind != Kind::Space && !token.is_sign('&')
}

/// Returns whether a formula cannot end with this token.
fn is_open(token: &Token) -> bool {
    let is_operator = ["cdot", "times", "pm", "mp"].into_iter().any(|name| token.is_command(name));
    is_operator || ['+', '-', '/'].into_iter().any(|sign| token.is_sign(sign)) || super::reader::is_relation(token)
}

/// Returns the ranges of bytes that are no part of the formula: line breaks, alignment marks, formula numbers, final punctuation.
fn blanks(tokens: &[Token]) -> Vec<Range<usize>> {
    let mut depth = 0usize;
    let mut all = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        match &token.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            Kind::Command(name) if name == "begin" => depth += 1,
            Kind::Command(name) if name == "end" => depth = depth.saturating_sub(1),
            Kind::Command(name) if name == "\\" && depth == 0 => all.push(token.span.clone()),
            Kind::Sign('&') if depth == 0 => all.push(token.span.clone()),
            Kind::Command(name) => {
                if let Some((_, arguments)) = NUMBERS.iter().find(|(known, _)| known == name) {
                    let end = (0..*arguments).try_fold(at + 1, |at, _| argument_end(tokens, at));
                    let last = end.and_then(|end| tokens.get(end.saturating_sub(1)));
                    all.push(token.span.start..last.map_or(token.span.end, |last| last.span.end));
                }
            }
            _ => {}
        }
    }
    let is_end = |at: usize| tokens.get(at).is_none_or(|next| next.is_command("\\"));
    let points = tokens
        .iter()
        .enumerate()
        .filter(|(at, token)| [',', '.', ';'].into_iter().any(|sign| token.is_sign(sign)) && is_end(at + 1));
    all.extend(points.map(|(_, token)| token.span.clone()));
    all
}
