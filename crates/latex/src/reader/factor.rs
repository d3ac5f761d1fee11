//! Factors of a product: numbers, groups, letters and commands, each with its power.

use super::numbers::{decimal, power, whole};
use super::{Read, Reader};
use crate::NotFormula;
use crate::form::{Form, Function, Term};
use crate::name::{argument_end, inside, is_face, is_letter_command, marks};
use crate::token::Kind;
use field::{Rational, Scalar};
use std::ops::Range;
use units::nearest;

/// Functions that are often written without their backslash.
const BARE: [&str; 9] = ["sinh", "cosh", "tanh", "sin", "cos", "tan", "exp", "sqrt", "frac"];

impl Reader<'_> {
    /// Reads a factor at the present token: a number, letter, group, fraction or function, with its exponents.
    ///
    /// # Errors
    /// No factor begins here, or it can be read in two ways; the message states an accepted spelling.
    pub(super) fn factor(&mut self) -> Read<Term> {
        let start = self.at;
        let Some(token) = self.peek() else {
            let last = self.end.saturating_sub(1);
            return Err(self.refused(
                last,
                "the formula ends where something must follow",
                "behind this",
                "an expression",
            ));
        };
        let base = match &token.kind {
            Kind::Digit(_) => self.number()?,
            Kind::Sign('(' | '[') => self.group()?,
            Kind::Command(name) if name == "{" => self.group()?,
            Kind::Open => self.braces()?,
            Kind::Letter(_) => {
                self.no_bare_function()?;
                return self.letter();
            }
            Kind::Command(name) if is_letter_command(name) || is_face(name) || name == "dot" || name == "ddot" => {
                return self.letter();
            }
            Kind::Command(name) => match Function::of_command(name) {
                Some(function) => return self.function(function),
                None => self.special(name)?,
            },
            Kind::Sign(sign @ ('+' | '-')) => {
                let title = format!("two signs stand side by side: `{sign}` follows another");
                return Err(self.refused(self.at, title, "the second sign", "a - (-b), a\\cdot(-b)"));
            }
            _ => {
                let title = format!("`{}` stands where an expression must", &self.text[token.span.clone()]);
                return Err(self.refused(self.at, title, "no expression", "a number, a letter, a group or a function"));
            }
        };
        self.powers(start, base)
    }

    /// Reads adjacent digits with at most one decimal point.
    fn number(&mut self) -> Read<Term> {
        let start = self.at;
        let mut digits = String::new();
        let mut end = self.place(start).start;
        while let Some(token) = self.peek() {
            let is_next = token.span.start == end;
            match token.kind {
                Kind::Digit(digit) if is_next => digits.push(digit),
                Kind::Digit(_) => {
                    return Err(self.refused(
                        self.at,
                        "two numbers stand side by side",
                        "the second one",
                        r"12, or 1\cdot 2",
                    ));
                }
                Kind::Sign('.') if is_next && !digits.contains('.') => digits.push('.'),
                Kind::Sign(',')
                    if is_next && self.peek_at(1).is_some_and(|next| matches!(next.kind, Kind::Digit(_))) =>
                {
                    return Err(self.refused(
                        self.at,
                        "a comma in a number",
                        "a decimal comma?",
                        "a decimal point: 1.5",
                    ));
                }
                _ => break,
            }
            end = token.span.end;
            self.at += 1;
        }
        let value = decimal(&digits).ok_or_else(|| {
            self.refused(
                start,
                format!("`{digits}` is no number"),
                "here",
                "up to 400 digits with one point between them",
            )
        })?;
        Ok(self.term(start, Form::Number(value)))
    }

    /// Reads a group in parentheses or brackets, and returns its content.
    fn group(&mut self) -> Read<Term> {
        let close = self.partner(self.at);
        let held = self.within(self.at + 1..close)?;
        self.at = close + 1;
        Ok(held)
    }

    /// Reads a group in braces. A sum, or a product with a power, is an error: braces are not printed, hence the printed formula would read differently.
    fn braces(&mut self) -> Read<Term> {
        let (open, close) = (self.at, self.partner(self.at));
        let held = self.within(open + 1..close)?;
        if matches!(held.form, Form::Sum(..) | Form::Difference(..) | Form::Negation(_)) {
            let accepted = format!("parentheses: ({})", self.text_of(open + 1..close));
            return Err(self.refused(open, "braces are not printed, and they hold a sum", "these braces", accepted));
        }
        self.at = close + 1;
        let powered = self.peek().is_some_and(|token| token.is_sign('^'));
        if powered && matches!(held.form, Form::Product(..) | Form::Dot(..) | Form::Cross(..)) {
            let accepted = format!("({})^2", self.text_of(open + 1..close));
            return Err(self.refused(
                open,
                "braces are not printed, and their power reads as that of the last factor",
                "these braces",
                accepted,
            ));
        }
        Ok(held)
    }

    /// Reads the power or transposition of a factor that is not a letter.
    fn powers(&mut self, start: usize, base: Term) -> Read<Term> {
        if self.sign() == Some('_') || self.sign() == Some('\'') {
            return Err(self.refused(
                self.at,
                "a script at something that is no letter",
                "here",
                "subscripts and primes at letters alone",
            ));
        }
        if self.sign() != Some('^') {
            return Ok(base);
        }
        let range = self.script()?;
        let form = self.raised(base, range)?;
        if self.sign() == Some('^') {
            return Err(self.refused(self.at, "two powers", "the second one", "(a^2)^3"));
        }
        Ok(self.term(start, form))
    }

    /// Reads the script after `^` or `_`. Returns the range of its tokens, without braces.
    pub(super) fn script(&mut self) -> Read<Range<usize>> {
        let sign = self.at;
        let end = argument_end(self.tokens, sign + 1).filter(|end| *end <= self.end);
        let Some(end) = end else {
            return Err(self.refused(sign, "a script without a sign", "nothing follows", "x^2, x_1, x^{10}"));
        };
        let range = inside(self.tokens, sign + 1..end);
        let is_digit = |at: usize| matches!(self.tokens.get(at).map(|token| &token.kind), Some(Kind::Digit(_)));
        let touches =
            |at: usize| self.tokens.get(at).is_some_and(|next| next.span.start == self.tokens[at - 1].span.end);
        if end == sign + 2 && is_digit(sign + 1) && end < self.end && is_digit(end) && touches(end) {
            let first = self.text_of(sign..end);
            let (mark, digit) = first.split_at(1);
            let title = format!("`{first}` takes one digit alone: TeX prints the next one beside it");
            let more = self.text_of(end..end + 1);
            let accepted = format!("x{mark}{{{digit}{more}}} or x{first}\\cdot {more}");
            return Err(self.refused(end, title, "this digit is no part of the script", accepted));
        }
        if range.is_empty() {
            return Err(self.refused(sign, "an empty script", "nothing stands in it", "x^2, x_1, x^{10}"));
        }
        self.at = end;
        Ok(range)
    }

    /// Returns a base with its exponent; `T`, `\top` and `\intercal` mean transposition.
    pub(super) fn raised(&self, base: Term, script: Range<usize>) -> Read<Form> {
        let tokens = &self.tokens[script.clone()];
        let spelt = crate::name::spelling(tokens);
        if matches!(spelt.as_str(), "T" | r"\top" | r"\mathrm{T}" | r"\mathsf{T}" | r"\intercal") {
            return Ok(Form::Transposed(Box::new(base)));
        }
        if marks(tokens).is_some() {
            return Err(self.refused(
                script.start,
                "a mark at something that is no letter of this name",
                "here",
                "a declared letter with its mark",
            ));
        }
        match power(&spelt) {
            Some((exponent, 1)) => Ok(Form::Power(Box::new(base), exponent)),
            Some((exponent, 2)) => {
                let span = base.span.clone();
                let root = Term { span, form: Form::Root(Box::new(base)) };
                Ok(if exponent == 1 { root.form } else { Form::Power(Box::new(root), exponent) })
            }
            _ => {
                let title = format!("`{spelt}` is no exponent that is read");
                let accepted = r"whole numbers from -64 to 64, halves such as 1/2 or \frac{3}{2}, or a declared letter with this superscript";
                Err(NotFormula::at(
                    self.place(script.start).start..self.place(script.end - 1).end,
                    title,
                    "here",
                    accepted,
                ))
            }
        }
    }

    /// Returns an error if a row of letters begins with the name of a function without its backslash.
    fn no_bare_function(&self) -> Read<()> {
        let mut word = String::new();
        let mut end = self.place(self.at).start;
        for token in &self.tokens[self.at..self.end] {
            match token.kind {
                Kind::Letter(letter) if token.span.start == end => word.push(letter),
                _ => break,
            }
            end = token.span.end;
        }
        match BARE.into_iter().find(|name| word.starts_with(name)) {
            Some(name) => {
                let span = self.place(self.at).start..end;
                let spread: Vec<String> = name.chars().map(String::from).collect();
                let accepted = format!("\\{name} for the function, {} for a product of letters", spread.join(" "));
                Err(NotFormula::at(
                    span,
                    format!("`{name}` without a backslash prints as a product of letters"),
                    "a function?",
                    accepted,
                ))
            }
            None => Ok(()),
        }
    }

    pub(super) fn unknown_command(&self, name: &str) -> NotFormula {
        const KNOWN: [&str; 12] =
            ["frac", "sqrt", "dot", "ddot", "sin", "cos", "tan", "cdot", "times", "sum", "partial", "mathrm"];
        let near = nearest(name, KNOWN).map_or_else(String::new, |near| format!("is `\\{near}` meant? "));
        let hint = match name {
            "arcsin" | "arccos" | "arctan" => "the equation between sines, cosines or tangents",
            "log" => r"\ln",
            "pm" | "mp" => "a claim for each sign",
            "int" | "oint" | "lim" | "prod" => "the value, as a letter with its meaning",
            "rm" | "bf" | "it" => r"\mathrm{...}, \mathbf{...}",
            "dddot" => r"\frac{d}{dt}(\ddot{x}) is not known either: a motion has no third rate",
            "partial" => r"\frac{\partial L}{\partial x}",
            _ => r"letters, \frac, \sqrt, \dot, \ddot, functions, \cdot, \times, \sum, \begin{pmatrix}",
        };
        self.refused(self.at, format!("`\\{name}` is not read"), "not known here", format!("{near}{hint}"))
    }

    /// Returns the integer that a range of tokens spells; `None` if it is something else.
    pub(super) fn whole_of(&self, range: Range<usize>) -> Option<i64> {
        whole(&crate::name::spelling(&self.tokens[range]))
    }
}

pub(super) fn number(value: i64) -> Form {
    Form::Number(Rational::int(value))
}
