//! Letters with their dots, subscripts, superscript marks and powers.

use super::factor::number;
use super::{Read, Reader};
use crate::NotFormula;
use crate::form::{Form, Term};
use crate::name::{Name, argument_end, base, inside, marks, spelling};
use crate::token::Kind;
use std::ops::Range;
use units::nearest;

/// Messages list at most this number of declared letters.
const MOST_LISTED: usize = 24;

impl Reader<'_> {
    /// Reads a letter, its time derivative, or a power of either.
    pub(super) fn letter(&mut self) -> Read<Term> {
        let start = self.at;
        let order = match self.peek().map(|token| &token.kind) {
            Some(Kind::Command(name)) if name == "dot" => 1,
            Some(Kind::Command(name)) if name == "ddot" => 2,
            _ => 0,
        };
        let mut name = if order > 0 { self.below_dots()? } else { self.plain_base()? };
        let mut power: Option<Range<usize>> = None;
        loop {
            match self.sign() {
                Some('_') => {
                    let at = self.at;
                    let range = self.script()?;
                    if name.below.is_some() {
                        return Err(self.refused(
                            at,
                            "two subscripts at one letter",
                            "the second one",
                            "one subscript: x_{12}",
                        ));
                    }
                    name.below = Some(self.indexed(range));
                }
                Some('\'') => {
                    name.marks += r"\prime";
                    self.at += 1;
                }
                Some('^') => {
                    let at = self.at;
                    let range = self.script()?;
                    let held = &self.tokens[range.clone()];
                    let with = Name { marks: name.marks.clone() + &spelling(held), ..name.clone() };
                    if let Some(marks) = marks(held) {
                        name.marks += &marks;
                    } else if self.known.contains(&with.spelt()) {
                        name = with;
                    } else if power.replace(range).is_some() {
                        return Err(self.refused(at, "two powers", "the second one", "(a^2)^3"));
                    }
                }
                _ => break,
            }
        }
        let base = match self.function_of(&name) {
            Some(declared) => self.declared_function(&declared, &name, start, power.is_some())?,
            None => {
                let form = self.resolved(&name, start, order)?;
                self.term(start, form)
            }
        };
        if power.is_none() && self.sign() == Some('^') && matches!(base.form, Form::Letter(_) | Form::Partial(..)) {
            power = Some(self.script()?);
        }
        let base = match order {
            0 => base,
            _ => self.term(start, Form::Rate(Box::new(base), order)),
        };
        match power {
            Some(range) => {
                let form = self.raised(base, range)?;
                Ok(self.term(start, form))
            }
            None => Ok(base),
        }
    }

    /// Returns the declaration `f(q)` of a function from its name, with or without primes; `None` if the name is not that of a declared function.
    fn function_of(&self, name: &Name) -> Option<String> {
        let is_primed = name.marks.replace(r"\prime", "").is_empty();
        let plain = Name { marks: String::new(), ..name.clone() }.spelt();
        if !is_primed || self.known.contains(&name.spelt()) {
            return None;
        }
        let of_it = |known: &&String| known.strip_prefix(&plain).is_some_and(|rest| rest.starts_with('('));
        self.known.iter().find(of_it).cloned()
    }

    /// Reads a declared function, with or without its argument. Each prime is a derivative with respect to the argument.
    fn declared_function(&mut self, declared: &str, name: &Name, start: usize, is_raised: bool) -> Read<Term> {
        let argument = declared.split_once('(').map_or("", |(_, rest)| rest.trim_end_matches(')')).to_owned();
        let value = self.term(start, Form::Letter(declared.to_owned()));
        if self.sign() == Some('(') {
            let open = self.at;
            let close = self.partner(open);
            let held = self.within(open + 1..close)?;
            let plain = declared.split('(').next().unwrap_or_default();
            if is_raised {
                let title = format!("the power of `{plain}` reads as that of its value, and as the function twice");
                return Err(self.refused(open, title, "of what?", format!("({declared})^2")));
            }
            if held.form != Form::Letter(argument.clone()) {
                let title = format!("`{plain}` is declared as a function of `{argument}`, and has no value elsewhere");
                let accepted = format!(r"{declared}, or {plain}\cdot(...) for a product");
                return Err(NotFormula::at(held.span, title, "another argument", accepted));
            }
            self.at = close + 1;
        }
        let by = self.term(start, Form::Letter(argument));
        let order = name.marks.matches(r"\prime").count();
        let derived = |of: Term, _| self.term(start, Form::Partial(Box::new(of), Box::new(by.clone())));
        Ok((0..order).fold(Term { span: self.term(start, value.form.clone()).span, ..value }, derived))
    }

    fn plain_base(&mut self) -> Read<Name> {
        let Some((base, end)) = base(self.tokens, self.at).filter(|(_, end)| *end <= self.end) else {
            return Err(self.refused(
                self.at,
                "no letter stands in this face",
                "here",
                r"\mathbf{r}, \mathrm{Re}, \vec{v}",
            ));
        };
        self.at = end;
        Ok(Name { base, ..Name::default() })
    }

    /// Reads the letter below one or two dots, with the subscript and the marks that stand below the dots.
    fn below_dots(&mut self) -> Read<Name> {
        let dot = self.at;
        let accepted = r"\dot{x}, \dot{x}_1, \ddot{\theta}; \frac{d}{dt}(a + b) for the rate of an expression";
        let Some(end) = argument_end(self.tokens, dot + 1).filter(|end| *end <= self.end) else {
            return Err(self.refused(dot, "a dot above nothing", "here", accepted));
        };
        let range = inside(self.tokens, dot + 1..end);
        let wrong =
            |reader: &Self| reader.refused(dot, "a dot stands above one letter", "above something else", accepted);
        let Some((base, mut at)) = base(self.tokens, range.start).filter(|(_, end)| *end <= range.end) else {
            return Err(wrong(self));
        };
        let mut name = Name { base, ..Name::default() };
        while at < range.end {
            let is_below = self.tokens[at].is_sign('_');
            let is_above = self.tokens[at].is_sign('^');
            if self.tokens[at].is_sign('\'') {
                name.marks += r"\prime";
                at += 1;
                continue;
            }
            let Some(end) = argument_end(self.tokens, at + 1).filter(|_| is_below || is_above) else {
                return Err(wrong(self));
            };
            let held = inside(self.tokens, at + 1..end);
            match marks(&self.tokens[held.clone()]) {
                Some(marks) if is_above => name.marks += &marks,
                _ if is_below && name.below.is_none() => name.below = Some(self.indexed(held)),
                _ => return Err(wrong(self)),
            }
            at = end;
        }
        self.at = end;
        Ok(name)
    }

    /// Returns a subscript in which indices of sums are replaced by their current values.
    fn indexed(&self, range: Range<usize>) -> String {
        let value = |at: usize| {
            let spelt = spelling(&self.tokens[at..at + 1]);
            self.indices.iter().rev().find(|(name, _)| *name == spelt).map(|(_, value)| value.to_string())
        };
        if self.indices.is_empty() || !range.clone().any(|at| value(at).is_some()) {
            return spelling(&self.tokens[range]);
        }
        range.map(|at| value(at).unwrap_or_else(|| spelling(&self.tokens[at..at + 1]))).collect()
    }

    fn resolved(&self, name: &Name, start: usize, order: u32) -> Read<Form> {
        let spelt = name.spelt();
        if self.known.contains(&spelt) || spelt == r"\pi" {
            return Ok(Form::Letter(spelt));
        }
        if let Some((_, value)) = self.indices.iter().rev().find(|(index, _)| *index == spelt)
            && order == 0
        {
            return Ok(number(*value));
        }
        let span = self.place(start).start..self.place(self.at.saturating_sub(1)).end;
        if !name.marks.is_empty() {
            let plain = Name { marks: String::new(), ..name.clone() }.spelt();
            if self.known.contains(&plain) {
                let title = format!("`{spelt}` is no declared letter, and a mark is no operation");
                let accepted = format!(r"\dot{{{plain}}} for the rate along the motion, or {spelt} in [letters]");
                return Err(NotFormula::at(span, title, "a letter of its own?", accepted));
            }
        }
        let near = nearest(&spelt, self.known.iter().map(String::as_str));
        let near = near.map_or_else(String::new, |near| format!("is `{near}` meant? "));
        let mut listed = self.known.iter().take(MOST_LISTED).map(String::as_str).collect::<Vec<_>>().join(", ");
        if self.known.len() > MOST_LISTED {
            listed += ", ...";
        }
        let accepted = format!("{near}declared letters: {listed}");
        Err(NotFormula::at(span, format!("unknown letter `{spelt}`"), "not declared in [letters]", accepted))
    }
}
