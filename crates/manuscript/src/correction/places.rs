//! The ranges of a formula that can be edited: terms with their signs, factors, letters, numbers, powers.

use field::Rational;
use latex::{Form, Function, Statement, Term};
use std::ops::Range;

/// A term of a sum, or a product that is not part of a sum.
pub(super) struct Summand {
    /// The position of the sign in bytes, and the sign; `None` for a positive first term.
    pub sign: Option<(usize, char)>,
    /// The range of the term without its sign.
    pub span: Range<usize>,
    /// The number of the term in the sum, from 1; `count` is the number of terms.
    pub number: usize,
    pub count: usize,
    /// The index of its sum in [`Places::sums`].
    pub sum: usize,
    /// The index of the side to which the sum belongs; `None` for a sum inside a group.
    pub side: Option<usize>,
    /// The ranges of its factors, including their brackets.
    pub factors: Vec<Range<usize>>,
}

/// A letter (order 0) or a rate of it.
pub(super) struct Atom {
    /// The range of the letter with its dots.
    pub span: Range<usize>,
    pub name: String,
    /// The number of dots, or the order of the derivative.
    pub order: u32,
    /// Whether the letter is the base of a power.
    pub is_powered: bool,
}

/// A function with the range of its command.
pub(super) struct Call {
    /// The range of the command, such as `\sin`.
    pub command: Range<usize>,
    pub function: Function,
    /// The range of the argument.
    pub argument: Range<usize>,
    /// Whether the function has an exponent.
    pub is_powered: bool,
}

/// A power: the range of `^2` or `^{10}`, and the exponent.
pub(super) struct Raised {
    pub script: Range<usize>,
    pub exponent: i32,
}

/// All editable ranges of a formula.
#[derive(Default)]
pub(super) struct Places {
    pub summands: Vec<Summand>,
    pub atoms: Vec<Atom>,
    pub calls: Vec<Call>,
    pub powers: Vec<Raised>,
    /// Printed numbers with their ranges.
    pub numbers: Vec<(Range<usize>, Rational)>,
    /// Quotients of two numbers.
    pub fractions: Vec<(Range<usize>, Rational)>,
    /// Sides, contents of groups, numerators and denominators; a term may be added at the end of each.
    pub sums: Vec<Range<usize>>,
}

impl Places {
    /// The editable ranges of a statement that was read from this text.
    pub fn of(statement: &Statement, text: &str) -> Self {
        let mut finder = Finder { text, found: Places::default() };
        let sides = statement.chains.iter().flat_map(|chain| &chain.sides);
        for (side, term) in sides.enumerate() {
            finder.sum(term, Some(side));
        }
        finder.found
    }
}

impl Places {
    /// Whether a term is a single letter that forms the left side, so that the right side defines it.
    pub fn is_told(&self, summand: &Summand) -> bool {
        let is_alone = summand.side == Some(0) && summand.count == 1;
        is_alone && self.atoms.iter().any(|atom| atom.span == summand.span)
    }
}

struct Finder<'a> {
    text: &'a str,
    found: Places,
}

impl Finder<'_> {
    fn sum(&mut self, term: &Term, side: Option<usize>) {
        let sum = self.found.sums.len();
        self.found.sums.push(term.span.clone());
        let parts = self.terms(term);
        let count = parts.len();
        let signs: Vec<Option<(usize, char)>> = parts.iter().map(|(sign, _)| *sign).collect();
        for (place, (sign, part)) in parts.into_iter().enumerate() {
            let from = sign.map_or_else(|| self.with_left(term.span.start), |(at, _)| at + 1);
            let to = signs.get(place + 1).copied().flatten().map_or(term.span.end, |(at, _)| at);
            let span = self.trimmed(from..to);
            let leaves = factors(part);
            let factors = leaves.iter().map(|leaf| self.with_brackets(&leaf.span, &span)).collect();
            self.found.summands.push(Summand { sign, span, number: place + 1, count, sum, side, factors });
            for leaf in leaves {
                self.leaf(leaf);
            }
        }
    }

    /// The position, or that of the command `\left` before the bracket at this position.
    fn with_left(&self, at: usize) -> usize {
        let before = self.text[..at].trim_end();
        before.strip_suffix(r"\left").map_or(at, str::len)
    }

    /// The terms of a sum with their signs, in their order.
    fn terms<'t>(&self, sum: &'t Term) -> Vec<(Option<(usize, char)>, &'t Term)> {
        let mut parts = Vec::new();
        let mut rest = sum;
        loop {
            match &rest.form {
                Form::Sum(left, right) | Form::Difference(left, right) => {
                    let between = self.text.get(left.span.end..right.span.start).unwrap_or_default();
                    let sign = between.char_indices().find(|(_, letter)| matches!(letter, '+' | '-'));
                    parts.push((sign.map(|(at, sign)| (left.span.end + at, sign)), &**right));
                    if left.span.start != rest.span.start {
                        // the left part is a group, whose signs are its own
                        parts.push((None, &**left));
                        break;
                    }
                    rest = left;
                }
                Form::Negation(of) => {
                    parts.push((Some((rest.span.start, '-')), &**of));
                    break;
                }
                _ => {
                    parts.push((None, rest));
                    break;
                }
            }
        }
        parts.reverse();
        parts
    }

    fn leaf(&mut self, term: &Term) {
        match &term.form {
            Form::Number(value) => self.found.numbers.push((term.span.clone(), *value)),
            Form::Letter(_) | Form::Rate(..) => self.atom(term, term.span.clone(), false),
            Form::Power(base, exponent) => {
                let script = self.script(term, base);
                if let Some(script) = &script {
                    self.found.powers.push(Raised { script: script.clone(), exponent: *exponent });
                }
                match &base.form {
                    Form::Letter(_) | Form::Rate(..) => {
                        let end = script.map_or(term.span.end, |script| script.start);
                        // without an opening bracket before the base
                        let bracket = self.text.get(term.span.start..base.span.start).unwrap_or_default();
                        let start = if bracket.contains(['(', '[']) { base.span.start } else { term.span.start };
                        self.atom(base, start..end.min(base.span.end), true);
                    }
                    Form::Function(function, argument) => self.call(base, *function, argument, true),
                    Form::Number(_) => {}
                    _ => self.sum(base, None),
                }
            }
            Form::Function(function, argument) => self.call(term, *function, argument, false),
            Form::Quotient(above, below) => {
                if let (Form::Number(over), Form::Number(under)) = (&above.form, &below.form) {
                    self.found.fractions.push((term.span.clone(), *over / *under));
                }
                self.sum(above, None);
                self.sum(below, None);
            }
            Form::Root(of) | Form::Transposed(of) | Form::Partial(of, _) => self.sum(of, None),
            Form::Matrix(rows) => rows.iter().flatten().for_each(|entry| self.sum(entry, None)),
            Form::Negation(_) | Form::Sum(..) | Form::Difference(..) => self.sum(term, None),
            Form::Product(..) | Form::Dot(..) | Form::Cross(..) => self.sum(term, None),
        }
    }

    fn atom(&mut self, term: &Term, span: Range<usize>, is_powered: bool) {
        match &term.form {
            Form::Letter(name) => self.found.atoms.push(Atom { span, name: name.clone(), order: 0, is_powered }),
            Form::Rate(of, order) => match &of.form {
                Form::Letter(name) if self.text[span.clone()].trim_start_matches('\\').contains("dot{") => {
                    self.found.atoms.push(Atom { span, name: name.clone(), order: *order, is_powered });
                }
                Form::Letter(name) if self.text[span.clone()].starts_with(r"\d") => {
                    self.found.atoms.push(Atom { span, name: name.clone(), order: *order, is_powered });
                }
                _ => self.sum(of, None),
            },
            _ => {}
        }
    }

    fn call(&mut self, term: &Term, function: Function, argument: &Term, is_powered: bool) {
        let start = term.span.start;
        let name = self.text[start..].char_indices().skip(1).find(|(_, letter)| !letter.is_ascii_alphabetic());
        let end = name.map_or(self.text.len(), |(at, _)| start + at);
        let command = start..end.min(term.span.end);
        let behind = match is_powered {
            true => self.script_at(command.end).map_or(command.end, |script| script.end),
            false => command.end,
        };
        let argument_is = self.trimmed(behind..term.span.end);
        self.found.calls.push(Call { command, function, argument: argument_is, is_powered });
        self.sum(argument, None);
    }

    /// The range of the exponent of a power, including `^`.
    fn script(&self, term: &Term, base: &Term) -> Option<Range<usize>> {
        let text = self.text.get(term.span.clone())?;
        if matches!(base.form, Form::Function(..)) {
            let name = text.char_indices().skip(1).find(|(_, letter)| !letter.is_ascii_alphabetic())?.0;
            return self.script_at(term.span.start + name);
        }
        let at = text.rfind('^')?;
        let script = self.script_at(term.span.start + at)?;
        (script.end == term.span.end).then_some(script)
    }

    fn script_at(&self, at: usize) -> Option<Range<usize>> {
        let held = self.text.get(at..)?.strip_prefix('^')?;
        let length = match held.starts_with('{') {
            true => held.find('}')? + 1,
            false => held.chars().next()?.len_utf8(),
        };
        Some(at..at + 1 + length)
    }

    fn trimmed(&self, range: Range<usize>) -> Range<usize> {
        let Some(text) = self.text.get(range.clone()) else { return range };
        let start = range.start + (text.len() - text.trim_start().len());
        start..start + text.trim().len()
    }

    /// The range of a factor extended by the brackets around it within the bounds.
    fn with_brackets(&self, span: &Range<usize>, bounds: &Range<usize>) -> Range<usize> {
        let mut span = span.clone();
        loop {
            let before = self.text.get(bounds.start..span.start).unwrap_or_default().trim_end();
            let behind = self.text.get(span.end..bounds.end).unwrap_or_default();
            let closing = behind.trim_start();
            let skipped = behind.len() - closing.len();
            let (closing, sized) = closing
                .strip_prefix(r"\right")
                .map_or((closing, 0), |rest| (rest.trim_start(), closing.len() - rest.trim_start().len()));
            let Some(open) = before.strip_suffix(['(', '[']) else { return span };
            if !closing.starts_with([')', ']']) {
                return span;
            }
            let open = open.trim_end();
            let open = open.strip_suffix(r"\left").unwrap_or(open);
            span = bounds.start + open.len()..span.end + skipped + sized + 1;
        }
    }
}

/// The factors of a product, in their order.
fn factors(product: &Term) -> Vec<&Term> {
    let mut found = Vec::new();
    let mut rest = product;
    loop {
        match &rest.form {
            Form::Product(left, right) | Form::Dot(left, right) | Form::Cross(left, right) => {
                found.push(&**right);
                if left.span.start != rest.span.start {
                    found.push(&**left);
                    break;
                }
                rest = left;
            }
            _ => {
                found.push(rest);
                break;
            }
        }
    }
    found.reverse();
    found
}
