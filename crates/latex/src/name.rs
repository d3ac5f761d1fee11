//! Normalised names of letters: a base with a subscript, stars and primes.

use crate::NotFormula;
use crate::token::{Kind, Token, tokens};
use std::ops::Range;

/// Commands that print one letter.
const LETTERS: &str = "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa varkappa lambda mu nu xi \
    omicron pi varpi rho varrho sigma varsigma tau upsilon phi varphi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma \
    Upsilon Phi Psi Omega ell hbar imath jmath Re Im aleph";

/// Commands for fonts and accents. They are part of the name of a letter.
const FACES: &str = "mathbf boldsymbol bm mathrm mathit mathsf mathcal mathfrak mathbb mathscr text textbf textrm vec hat bar \
    tilde overline underline check breve widehat widetilde";

/// Superscripts that are part of a name: (the sign or command, its normalised form).
const MARKS: [(&str, &str); 7] = [
    ("*", "*"),
    ("ast", "*"),
    ("star", r"\star"),
    ("prime", r"\prime"),
    ("dagger", r"\dagger"),
    ("circ", r"\circ"),
    ("ddagger", r"\ddagger"),
];

pub(crate) fn is_letter_command(name: &str) -> bool {
    LETTERS.split_whitespace().any(|known| known == name)
}

pub(crate) fn is_face(name: &str) -> bool {
    FACES.split_whitespace().any(|known| known == name)
}

/// The parts of a name: base letter, subscript, superscript marks.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Name {
    pub base: String,
    pub below: Option<String>,
    pub marks: String,
}

impl Name {
    /// Returns the normalised name, such as `m_{12}^{*}`.
    pub fn spelt(&self) -> String {
        let mut text = self.base.clone();
        if let Some(below) = &self.below {
            text += &format!("_{{{below}}}");
        }
        if !self.marks.is_empty() {
            text += &format!("^{{{}}}", self.marks);
        }
        text
    }
}

/// Returns tokens as normalised text: no typeset spaces, and a space only between a command and a following letter or digit.
pub(crate) fn spelling(tokens: &[Token]) -> String {
    let mut text = String::new();
    let mut after_command = false;
    for token in tokens {
        let next = match &token.kind {
            Kind::Command(name) => format!("\\{name}"),
            Kind::Letter(letter) | Kind::Digit(letter) | Kind::Sign(letter) => letter.to_string(),
            Kind::Open => "{".to_owned(),
            Kind::Close => "}".to_owned(),
            Kind::Space => continue,
        };
        if after_command && next.starts_with(char::is_alphanumeric) {
            text.push(' ');
        }
        after_command =
            matches!(&token.kind, Kind::Command(name) if name.starts_with(|c: char| c.is_ascii_alphabetic()));
        text += &next;
    }
    text
}

/// Returns the superscript mark that the tokens form; `None` if they contain anything else.
pub(crate) fn marks(tokens: &[Token]) -> Option<String> {
    let of = |token: &Token| match &token.kind {
        Kind::Sign('*') => Some("*"),
        Kind::Sign('\'') => Some(r"\prime"),
        Kind::Command(name) => MARKS.iter().find(|(known, _)| known == name).map(|(_, mark)| *mark),
        _ => None,
    };
    let found: Option<Vec<&str>> = tokens.iter().filter(|token| token.kind != Kind::Space).map(of).collect();
    found.filter(|marks| !marks.is_empty()).map(|marks| marks.concat())
}

/// Returns the end of the argument that begins at `at`: a group in braces, a font or accent command with its argument, or a single token.
pub(crate) fn argument_end(tokens: &[Token], at: usize) -> Option<usize> {
    match &tokens.get(at)?.kind {
        Kind::Open => {
            let mut depth = 0;
            for (place, token) in tokens.iter().enumerate().skip(at) {
                match token.kind {
                    Kind::Open => depth += 1,
                    Kind::Close => depth -= 1,
                    _ => {}
                }
                if depth == 0 {
                    return Some(place + 1);
                }
            }
            None
        }
        Kind::Command(name) if is_face(name) || matches!(name.as_str(), "dot" | "ddot") => argument_end(tokens, at + 1),
        _ => Some(at + 1),
    }
}

/// Returns the range of an argument without its braces.
pub(crate) fn inside(tokens: &[Token], range: Range<usize>) -> Range<usize> {
    match tokens.get(range.start).map(|token| &token.kind) {
        Some(Kind::Open) => range.start + 1..range.end - 1,
        _ => range,
    }
}

/// Reads the base of a name at `at`. Returns the base and its end; `None` if no letter begins there.
pub(crate) fn base(tokens: &[Token], at: usize) -> Option<(String, usize)> {
    match &tokens.get(at)?.kind {
        Kind::Letter(letter) => Some((letter.to_string(), at + 1)),
        Kind::Command(name) if is_letter_command(name) => Some((format!("\\{name}"), at + 1)),
        Kind::Command(name) if is_face(name) => {
            let end = argument_end(tokens, at + 1)?;
            let held = &tokens[inside(tokens, at + 1..end)];
            let is_plain = !held.is_empty()
                && held.iter().all(|token| match &token.kind {
                    Kind::Letter(_) | Kind::Digit(_) | Kind::Open | Kind::Close => true,
                    Kind::Command(name) => is_letter_command(name) || is_face(name),
                    _ => false,
                });
            is_plain.then(|| (format!("\\{name}{{{}}}", spelling(held)), end))
        }
        _ => None,
    }
}

/// Returns the normalised name of a declared letter: `m_p` and `m_{p}` give the same name.
///
/// # Errors
/// The text is not a single letter, is dotted, has two subscripts, or has a superscript that reads as a power.
pub fn letter_name(text: &str) -> Result<String, NotFormula> {
    let tokens = tokens(text)?;
    let whole = 0..text.len().max(1);
    let accepted =
        r"one letter with subscripts, stars and primes: m, \theta, l_{12}, \mathbf{r}, \omega^*, \mathrm{Re}";
    let wrong = |title: &str, span: Range<usize>| NotFormula::at(span, title, "here", accepted);
    let place = |at: usize| tokens.get(at).map_or(whole.clone(), |token| token.span.clone());
    let is_dotted = tokens.first().is_some_and(|first| first.is_command("dot") || first.is_command("ddot"));
    if is_dotted {
        return Err(wrong("a rate is known by itself where its letter is declared", place(0)));
    }
    let Some((base, mut at)) = base(&tokens, 0) else {
        return Err(wrong("this is no letter", place(0)));
    };
    let mut name = Name { base, ..Name::default() };
    while at < tokens.len() {
        if tokens[at].is_sign('\'') {
            name.marks += r"\prime";
            at += 1;
            continue;
        }
        let is_below = tokens[at].is_sign('_');
        if !is_below && !tokens[at].is_sign('^') {
            return Err(wrong("more than one letter stands here", place(at)));
        }
        let Some(end) = argument_end(&tokens, at + 1) else { return Err(wrong("a script without a sign", place(at))) };
        let held = &tokens[inside(&tokens, at + 1..end)];
        match (is_below, marks(held)) {
            (true, _) if name.below.is_none() => name.below = Some(spelling(held)),
            (false, Some(marks)) => name.marks += &marks,
            (false, None) if held.iter().any(|token| matches!(token.kind, Kind::Letter(_) | Kind::Sign('('))) => {
                name.marks += &spelling(held);
            }
            (false, None) => return Err(wrong("this reads as a power, not as a part of a name", place(at + 1))),
            (true, _) => return Err(wrong("two subscripts", place(at))),
        }
        at = end;
    }
    Ok(name.spelt())
}

/// Returns the normalised name of a letter, or of a function of one letter: `f(q)`.
///
/// # Errors
/// The errors of [`letter_name`].
pub fn declared_name(text: &str) -> Result<String, NotFormula> {
    match text.trim_end().strip_suffix(')').and_then(|rest| rest.split_once('(')) {
        Some((function, argument)) => Ok(format!("{}({})", letter_name(function)?, letter_name(argument)?)),
        None => letter_name(text),
    }
}

/// Returns a name for plain text: `theta_1`, `m_p`, `x⋆`. The argument of a function and all font commands are removed.
pub fn plain_name(spelt: &str) -> String {
    let spelt = spelt.split_once('(').map_or(spelt, |(function, _)| function);
    let mut faces: Vec<&str> = FACES.split_whitespace().collect();
    // the longest commands first: `textbf` before `text`
    faces.sort_by_key(|face| std::cmp::Reverse(face.len()));
    let faces = faces.into_iter().fold(spelt.to_owned(), |text, face| text.replace(&format!("\\{face}"), ""));
    let marked = faces.replace("^{", "").replace(r"\prime", "′").replace('*', "⋆").replace(r"\star", "⋆");
    marked.chars().filter(|letter| letter.is_alphanumeric() || matches!(letter, '_' | '′' | '⋆')).collect()
}
