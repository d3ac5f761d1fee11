//! Functions such as `\sin`, with their arguments.

use super::{Read, Reader, ends_product};
use crate::NotFormula;
use crate::form::{Form, Function, Term};
use crate::name::inside;
use crate::token::{Kind, Token};

impl Reader<'_> {
    /// Reads a function with its argument: `\sin\theta`, `\sin 2\theta`, `\sin(a + b)`, `\sin^2\theta`.
    pub(super) fn function(&mut self, function: Function) -> Read<Term> {
        let start = self.at;
        self.at += 1;
        let name = self.text_of(start..start + 1).to_owned();
        let power = self.power_of_function(&name)?;
        if self.sign() == Some('_') {
            return Err(self.refused(self.at, format!("`{name}` has no subscript"), "here", format!("{name} x")));
        }
        self.skip_space();
        let argument = match self.peek().map(|token| &token.kind) {
            Some(Kind::Sign('(' | '[')) => {
                let close = self.partner(self.at);
                let argument = self.within(self.at + 1..close)?;
                self.at = close + 1;
                if self.sign() == Some('^') {
                    let title = format!(
                        "a power behind the argument of `{name}` reads as that of the argument, and of the function"
                    );
                    let accepted = format!("{name}^2(x) for the function's square, {name}(x^2) for the argument's");
                    return Err(self.refused(self.at, title, "of what?", accepted));
                }
                argument
            }
            _ => self.bare_argument(start, &name)?,
        };
        let form = Form::Function(function, Box::new(argument));
        let term = self.term(start, form);
        Ok(match power {
            Some(power) => self.term(start, Form::Power(Box::new(term), power)),
            None => term,
        })
    }

    fn power_of_function(&mut self, name: &str) -> Read<Option<i32>> {
        if self.sign() != Some('^') {
            return Ok(None);
        }
        let sign = self.at;
        let range = self.script()?;
        match self.whole_of(range) {
            Some(power @ 1..=64) => {
                i32::try_from(power).map(Some).map_err(|_| self.refused(sign, "too large a power", "here", "up to 64"))
            }
            Some(power) if power < 0 => {
                let title = format!("`{name}^{{{power}}}` reads as the inverse function, and as a quotient");
                Err(self.refused(
                    sign,
                    title,
                    "which one?",
                    format!(
                        r"\frac{{1}}{{{name} x}} for the quotient; the equation between x and its value for the inverse"
                    ),
                ))
            }
            _ => {
                let title = format!("the power of `{name}` is no whole number");
                Err(self.refused(sign, title, "here", format!("{name}^2 x, \\left({name} x\\right)^{{1/2}}")))
            }
        }
    }

    /// Reads an argument without parentheses: an optional number or fraction, then one letter; or a root. It is an error if a factor follows that could belong to the argument.
    fn bare_argument(&mut self, start: usize, name: &str) -> Read<Term> {
        if self.peek().is_some_and(|token| token.kind == Kind::Open) {
            let close = self.partner(self.at);
            let range = inside(self.tokens, self.at..close + 1);
            let outer = (self.at, self.end);
            (self.at, self.end) = (range.start, range.end);
            let argument = self.bare_argument(start, name);
            let is_whole = self.at == self.end;
            (self.at, self.end) = (close + 1, outer.1);
            let argument = argument?;
            if !is_whole {
                return Err(self.unclear(start, name));
            }
            return if self.peek().is_none_or(separates) { Ok(argument) } else { Err(self.unclear(start, name)) };
        }
        let first = self.at;
        let is_fraction = |token: &Token| ["frac", "tfrac", "dfrac"].into_iter().any(|name| token.is_command(name));
        let is_number = |token: &Token| matches!(token.kind, Kind::Digit(_));
        let is_letter = |token: &Token| match &token.kind {
            Kind::Letter(_) => true,
            Kind::Command(name) => {
                crate::name::is_letter_command(name) || crate::name::is_face(name) || name == "dot" || name == "ddot"
            }
            _ => false,
        };
        let mut argument: Option<Term> = None;
        let is_root = self.peek().is_some_and(|token| token.is_command("sqrt"));
        if is_root || self.peek().is_some_and(|token| is_number(token) || is_fraction(token)) {
            argument = Some(self.factor()?);
        }
        if !is_root && self.peek().is_some_and(is_letter) {
            let letter = self.letter()?;
            argument = Some(match argument {
                Some(number) => self.term(first, Form::Product(Box::new(number), Box::new(letter))),
                None => letter,
            });
        }
        let Some(argument) = argument else {
            let title = format!("`{name}` has no argument that is clear");
            return Err(self.refused(
                start,
                title,
                "this function",
                format!(r"{name}\theta, {name} 2\theta, {name}(a + b)"),
            ));
        };
        let is_power = match &argument.form {
            Form::Power(..) => true,
            Form::Product(_, last) => matches!(last.form, Form::Power(..)),
            _ => false,
        };
        if is_power {
            let title =
                format!("a power behind the argument of `{name}` reads as that of the argument, and of the function");
            let accepted = format!("{name}^2 x for the function's square, {name}(x^2) for the argument's");
            return Err(NotFormula::at(argument.span, title, "of what?", accepted));
        }
        match self.peek() {
            Some(next) if !separates(next) => Err(self.unclear(start, name)),
            _ => Ok(argument),
        }
    }

    fn unclear(&self, start: usize, name: &str) -> NotFormula {
        let span = self.place(start).start..self.place(self.at.min(self.end.saturating_sub(1))).end;
        let title = format!("it is not clear where the argument of `{name}` ends");
        let accepted = format!(r"{name}(x y) for the whole, {name}(x) y or {name} x\,y for the first letter alone");
        NotFormula::at(span, title, "more stands beside the argument", accepted)
    }
}

/// Returns whether an argument without parentheses ends before this token.
fn separates(token: &Token) -> bool {
    match &token.kind {
        Kind::Space => true,
        Kind::Command(name) => {
            name == "cdot" || name == "times" || Function::of_command(name).is_some() || ends_product(token)
        }
        _ => ends_product(token),
    }
}
