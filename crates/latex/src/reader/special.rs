//! Commands with their own syntax: fractions, derivatives, roots, sums with an index, matrices.

use super::{MOST_TERMS, Read, Reader};
use crate::NotFormula;
use crate::form::{Form, Term};
use crate::name::{argument_end, inside, spelling};
use crate::token::{Kind, Token};
use std::ops::Range;

impl Reader<'_> {
    pub(super) fn special(&mut self, name: &str) -> Read<Term> {
        match name {
            "frac" | "dfrac" | "tfrac" | "cfrac" => self.fraction(),
            "sqrt" => self.root(),
            "sum" => self.indexed_sum(),
            "begin" => self.matrix(),
            _ => Err(self.unknown_command(name)),
        }
    }

    /// Reads the next argument of the command at `of`. Returns its range without braces.
    fn argument(&mut self, of: usize) -> Read<Range<usize>> {
        match argument_end(self.tokens, self.at).filter(|end| *end <= self.end) {
            Some(end) => {
                let range = inside(self.tokens, self.at..end);
                self.at = end;
                Ok(range)
            }
            None => Err(self.refused(of, "an argument is missing", "of this command", r"\frac{a}{b}, \sqrt{a}")),
        }
    }

    fn fraction(&mut self) -> Read<Term> {
        let start = self.at;
        self.at += 1;
        let (above, below) = (self.argument(start)?, self.argument(start)?);
        let is_plain = |at: usize| matches!(self.tokens.get(at).map(|token| &token.kind), Some(Kind::Letter('d')));
        let is_rate =
            is_plain(above.start) && matches!(spelling(&self.tokens[below.clone()]).as_str(), "dt" | "dt^2" | "dt^{2}");
        if is_rate && self.is_declared("d") && self.is_declared("t") {
            let title = "`d` and `t` are declared letters, so that this is a rate, or a quotient of products";
            let accepted =
                r"\frac{\mathrm{d}}{\mathrm{d}t}(x) for the rate; the quotient without the common factor `d`";
            return Err(self.refused(start, title, "which one?", accepted));
        }
        if let Some(sign) = self.differential(below.start, is_rate) {
            return self.derivative(start, sign, above, below, is_rate);
        }
        let (above, below) = (self.within(above)?, self.within(below)?);
        Ok(self.term(start, Form::Quotient(Box::new(above), Box::new(below))))
    }

    fn is_declared(&self, name: &str) -> bool {
        self.known.iter().any(|letter| letter == name)
    }

    /// The sign of a derivative at a place: `d`, `\mathrm{d}` or `\partial`, and its end. A declared letter d is one above and below the bar of a rate.
    fn differential(&self, at: usize, is_rate: bool) -> Option<(char, usize)> {
        let token = self.tokens.get(at)?;
        match &token.kind {
            Kind::Letter('d') if is_rate || !self.is_declared("d") => Some(('d', at + 1)),
            Kind::Command(name) if name == "partial" => Some(('p', at + 1)),
            Kind::Command(name) if name == "mathrm" || name == "text" => {
                let end = argument_end(self.tokens, at + 1)?;
                (spelling(&self.tokens[inside(self.tokens, at + 1..end)]) == "d").then_some(('d', end))
            }
            _ => None,
        }
    }

    /// Reads a derivative: `\frac{d}{dt}(...)`, `\frac{d x}{dt}`, `\frac{d^2 x}{dt^2}`, `\frac{\partial L}{\partial \dot{x}}`.
    fn derivative(
        &mut self,
        start: usize,
        (sign, after): (char, usize),
        above: Range<usize>,
        below: Range<usize>,
        is_rate: bool,
    ) -> Read<Term> {
        let accepted = r"\frac{d}{dt}(a), \frac{d a}{dt}, \frac{d^2 a}{dt^2}, \frac{\partial L}{\partial x}";
        let wrong = |reader: &Self| reader.refused(start, "this derivative is not read", "here", accepted);
        let Some((own, mut from)) = self.differential(above.start, is_rate).filter(|_| !above.is_empty()) else {
            return Err(wrong(self));
        };
        if own != sign {
            return Err(wrong(self));
        }
        let mut order = 1;
        if from < above.end && self.tokens[from].is_sign('^') {
            let end = argument_end(self.tokens, from + 1).ok_or_else(|| wrong(self))?;
            order = self.whole_of(inside(self.tokens, from + 1..end)).unwrap_or(0);
            from = end;
        }
        let by = spelling(&self.tokens[after..below.end]);
        let is_time = sign == 'd' && (order == 1 && by == "t" || order == 2 && (by == "t^2" || by == "t^{2}"));
        if !is_time && (sign == 'd' || order != 1) {
            return Err(wrong(self));
        }
        let of = match from < above.end {
            true => self.within(from..above.end)?,
            false => self.operand(start)?,
        };
        let form = match sign {
            'd' => Form::Rate(Box::new(of), order as u32),
            _ => Form::Partial(Box::new(of), Box::new(self.within(after..below.end)?)),
        };
        Ok(self.term(start, form))
    }

    /// Reads the operand after a derivative such as `\frac{d}{dt}`: a group, or one factor that no further factor follows.
    fn operand(&mut self, start: usize) -> Read<Term> {
        self.skip_space();
        let is_closed = self.peek().is_some_and(|token| {
            matches!(token.kind, Kind::Sign('(' | '[')) || token.is_command("frac") || token.is_command("{")
        });
        let of = self.factor()?;
        if !is_closed && self.peek().is_some_and(|token| !super::ends_product(token) && token.kind != Kind::Space) {
            let title = "it is not clear where the operand of the derivative ends";
            return Err(self.refused(start, title, "more stands beside it", r"\frac{d}{dt}(a b), \frac{d}{dt} a\,b"));
        }
        Ok(of)
    }

    fn root(&mut self) -> Read<Term> {
        let start = self.at;
        self.at += 1;
        if self.sign() == Some('[') {
            let close = self.partner(self.at);
            if self.whole_of(self.at + 1..close) != Some(2) {
                return Err(self.refused(self.at, "roots other than square roots are not read", "here", r"\sqrt{a}"));
            }
            self.at = close + 1;
        }
        let range = self.argument(start)?;
        let of = self.within(range)?;
        Ok(self.term(start, Form::Root(Box::new(of))))
    }

    /// Reads `\sum_{i=1}^{3} m_i`: the sum of the following product over all values of the index.
    fn indexed_sum(&mut self) -> Read<Term> {
        let start = self.at;
        self.at += 1;
        let accepted = r"\sum_{i=1}^{3} m_i, with whole numbers as limits";
        let wrong = |reader: &Self| reader.refused(start, "this sum has no limits that are read", "here", accepted);
        let (mut below, mut above) = (None, None);
        while let Some(sign @ ('_' | '^')) = self.sign() {
            let range = self.script()?;
            if sign == '_' {
                below = Some(range)
            } else {
                above = Some(range)
            };
        }
        let (Some(below), Some(above)) = (below, above) else { return Err(wrong(self)) };
        let equals = below.clone().find(|at| self.tokens[*at].is_sign('='));
        let Some(equals) = equals.filter(|equals| *equals == below.start + 1) else { return Err(wrong(self)) };
        let index = spelling(&self.tokens[below.start..equals]);
        let (Some(first), Some(last)) = (self.whole_of(equals + 1..below.end), self.whole_of(above)) else {
            return Err(wrong(self));
        };
        if self.known.contains(&index) {
            let title = format!("the index `{index}` is a declared letter too");
            return Err(self.refused(below.start, title, "which one?", "an index of another name"));
        }
        let body = self.at;
        let mut sum: Option<Term> = None;
        for value in first..=last {
            self.terms += 1;
            if self.terms > MOST_TERMS {
                return Err(self.refused(start, format!("sums of more than {MOST_TERMS} terms"), "here", accepted));
            }
            self.at = body;
            self.indices.push((index.clone(), value));
            let term = self.product();
            self.indices.pop();
            let term = term?;
            sum = Some(match sum {
                Some(sum) => self.term(start, Form::Sum(Box::new(sum), Box::new(term))),
                None => term,
            });
        }
        sum.ok_or_else(|| wrong(self))
    }

    fn matrix(&mut self) -> Read<Term> {
        let start = self.at;
        self.at += 1;
        let name = self.argument(start)?;
        let name: String = spelling(&self.tokens[name]);
        if !matches!(name.as_str(), "pmatrix" | "bmatrix" | "matrix" | "Bmatrix" | "smallmatrix") {
            let accepted =
                r"\begin{pmatrix}, \begin{bmatrix}, \begin{matrix}; a formula alone without \begin{equation}";
            return Err(self.refused(start, format!(r"`\begin{{{name}}}` is not read"), "not known here", accepted));
        }
        let mut rows: Vec<Vec<Term>> = vec![Vec::new()];
        let (mut from, mut depth) = (self.at, 0usize);
        let mut at = self.at;
        loop {
            let Some(token) = self.tokens.get(at).filter(|_| at < self.end) else {
                return Err(self.refused(
                    start,
                    r"this matrix has no `\end`",
                    "begins here",
                    format!(r"\end{{{name}}}"),
                ));
            };
            let ends = token.is_command("end") && depth == 0;
            let breaks = token.is_command("\\") && depth == 0;
            if token.is_command("begin") || token.kind == Kind::Open || token.is_sign('(') || token.is_sign('[') {
                depth += 1;
            } else if depth > 0
                && (token.is_command("end") || token.kind == Kind::Close || token.is_sign(')') || token.is_sign(']'))
            {
                depth -= 1;
            } else if ends || breaks || token.is_sign('&') && depth == 0 {
                let blank = self.tokens[from..at].iter().all(|token: &Token| token.kind == Kind::Space);
                let is_last_break = ends && blank && rows.last().is_some_and(Vec::is_empty) && rows.len() > 1;
                if !is_last_break {
                    let entry = self.within(from..at)?;
                    if let Some(row) = rows.last_mut() {
                        row.push(entry);
                    }
                } else {
                    rows.pop();
                }
                if breaks {
                    rows.push(Vec::new());
                }
                from = at + 1;
            }
            at += 1;
            if ends {
                break;
            }
        }
        self.at = at;
        let end = self.argument(start)?;
        if spelling(&self.tokens[end]) != name {
            return Err(self.refused(at - 1, "another matrix ends here", "another name", format!(r"\end{{{name}}}")));
        }
        let columns = rows[0].len();
        if let Some(row) = rows.iter().find(|row| row.len() != columns) {
            let span = row.first().map_or_else(|| self.place(start), |entry| entry.span.clone());
            let title = format!("a row has {} entries and the first one {columns}", row.len());
            return Err(NotFormula::at(span, title, "this row", "rows of one length"));
        }
        Ok(self.term(start, Form::Matrix(rows)))
    }
}
