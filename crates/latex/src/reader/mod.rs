//! Parser of formulas: statements, chains of relations, sums and products.

mod factor;
mod function;
mod letter;
mod numbers;
mod special;

use crate::NotFormula;
use crate::form::{Chain, Form, Relation, Statement, Term};
use crate::token::{Kind, Token, tokens};
use std::ops::Range;

/// The largest allowed depth of nested groups.
const MOST_DEEP: usize = 60;

/// The largest total number of terms of all sums with an index (`\sum`) in a formula.
const MOST_TERMS: usize = 1_000;

/// Reads a formula. `known` lists the declared letters by their normalised names (see [`crate::letter_name`]).
///
/// # Errors
/// The text is not a formula, uses a letter that is not declared, or can be read in more than one way. The error states the first such position and the accepted spellings.
pub fn read(text: &str, known: &[String]) -> Result<Statement, NotFormula> {
    let tokens = tokens(text)?;
    let mut reader =
        Reader { text, tokens: &tokens, at: 0, end: tokens.len(), known, indices: Vec::new(), depth: 0, terms: 0 };
    reader.statement()
}

/// The state of the parser: a position within a range of tokens.
struct Reader<'a> {
    text: &'a str,
    tokens: &'a [Token],
    at: usize,
    end: usize,
    known: &'a [String],
    /// The indices of the enclosing sums, with their current values.
    indices: Vec<(String, i64)>,
    depth: usize,
    terms: usize,
}

type Read<T> = Result<T, NotFormula>;

impl<'a> Reader<'a> {
    fn statement(&mut self) -> Read<Statement> {
        let mut chains = vec![self.chain()?];
        while self.peek().is_some_and(is_equivalence) {
            self.at += 1;
            chains.push(self.chain()?);
        }
        match self.peek() {
            None => Ok(Statement { chains }),
            Some(token) => Err(self.unexpected(token)),
        }
    }

    fn chain(&mut self) -> Read<Chain> {
        let (mut sides, mut relations) = (vec![self.sum()?], Vec::new());
        loop {
            self.skip_space();
            // an alignment mark before a relation
            if self.peek().is_some_and(|token| token.is_sign('&'))
                && self.peek_at(1).is_some_and(|next| relation(next).is_some())
            {
                self.at += 1;
            }
            let Some(found) = self.peek().and_then(relation) else { break };
            self.at += 1;
            relations.push(found);
            sides.push(self.sum()?);
        }
        Ok(Chain { sides, relations })
    }

    /// Reads a sum of terms with signs.
    fn sum(&mut self) -> Read<Term> {
        self.skip_space();
        let start = self.at;
        let mut left = match self.sign() {
            Some('-') => {
                self.at += 1;
                let term = self.product()?;
                self.term(start, Form::Negation(Box::new(term)))
            }
            Some('+') => {
                self.at += 1;
                self.product()?
            }
            _ => self.product()?,
        };
        loop {
            self.skip_space();
            let Some(sign @ ('+' | '-')) = self.sign() else { return Ok(left) };
            self.at += 1;
            let right = Box::new(self.product()?);
            left = self.term(
                start,
                match sign {
                    '+' => Form::Sum(Box::new(left), right),
                    _ => Form::Difference(Box::new(left), right),
                },
            );
        }
    }

    /// Reads a product: factors without signs, with `\cdot` or `\times`, and at most one slash.
    fn product(&mut self) -> Read<Term> {
        self.skip_space();
        let start = self.at;
        let mut left = self.factor()?;
        let mut slash: Option<usize> = None;
        loop {
            let before = self.at;
            self.skip_space();
            let is_apart = self.at > before;
            let Some(token) = self.peek() else { return Ok(left) };
            let sign = match &token.kind {
                Kind::Sign('/') => '/',
                Kind::Command(name) if name == "cdot" => '.',
                Kind::Command(name) if name == "times" => 'x',
                Kind::Command(name) if name == "div" => {
                    return Err(self.refused(self.at, "`\\div` is not read", "a sign of division", r"\frac{a}{b}"));
                }
                Kind::Sign('*') => {
                    return Err(self.refused(self.at, "`*` is not printed as a product", "a star", r"a b, a\cdot b"));
                }
                _ if ends_product(token) => return Ok(left),
                _ => ' ',
            };
            if let Some(slash) = slash {
                let title = "it is not clear what is divided by what";
                let accepted = r"\frac{a}{b c}, \frac{a}{b} c, a/(b c) or (a/b) c";
                return Err(self.refused(slash, title, "factors follow the quotient", accepted));
            }
            if sign == ' ' {
                if !is_apart {
                    self.no_application(&left)?;
                }
                let right = self.factor()?;
                if let (Form::Number(_), Form::Number(_)) = (&left.form, &right.form) {
                    let title = "two numbers stand side by side";
                    return Err(NotFormula::at(right.span, title, "the second one", r"12, or 1\cdot 2"));
                }
                if matches!(left.form, Form::Number(_)) && is_fraction_of_numbers(&right.form) {
                    let title = "a number before a fraction of numbers is their product or their sum";
                    let accepted = r"3\cdot\frac12 for the product, \frac72 or 3 + \frac12 for the sum";
                    return Err(NotFormula::at(right.span, title, "the fraction", accepted));
                }
                left = self.term(start, Form::Product(Box::new(left), Box::new(right)));
                continue;
            }
            let place = self.at;
            self.at += 1;
            self.skip_space();
            let right = Box::new(self.factor()?);
            let left_side = Box::new(left);
            left = self.term(
                start,
                match sign {
                    '/' => Form::Quotient(left_side, right),
                    '.' => Form::Dot(left_side, right),
                    _ => Form::Cross(left_side, right),
                },
            );
            if sign == '/' {
                slash = Some(place);
            }
        }
    }

    /// Returns an error if a letter precedes parentheses that contain only letters: the text reads as a product and as a function.
    fn no_application(&self, left: &Term) -> Read<()> {
        let opens = self.peek().is_some_and(|token| token.is_sign('(') || token.is_sign('['));
        if !opens || !is_letter(left) {
            return Ok(());
        }
        let close = self.partner(self.at);
        let held = &self.tokens[self.at + 1..close];
        let is_argument = |token: &Token| match &token.kind {
            Kind::Letter(_) | Kind::Digit(_) | Kind::Open | Kind::Close | Kind::Space => true,
            Kind::Sign(sign) => matches!(sign, ',' | '_' | '^' | '*' | '\'' | '.'),
            Kind::Command(name) => {
                crate::name::is_letter_command(name)
                    || crate::name::is_face(name)
                    || matches!(name.as_str(), "dot" | "ddot" | "prime")
            }
        };
        if !held.iter().all(is_argument) {
            return Ok(());
        }
        let (letter, inside) = (&self.text[left.span.clone()], self.text_of(self.at + 1..close));
        let title = format!("`{letter}` before parentheses reads as a function of `{inside}`, and as a product");
        let span = left.span.start..self.tokens[close].span.end;
        let accepted = format!(
            r"{letter}\cdot({inside}) for the product; a function is declared by its value, as a letter without arguments"
        );
        Err(NotFormula::at(span, title, "a function or a product?", accepted))
    }

    fn term(&self, start: usize, form: Form) -> Term {
        let from = self.tokens.get(start).map_or(self.text.len(), |token| token.span.start);
        let to = self.at.checked_sub(1).and_then(|last| self.tokens.get(last)).map_or(from, |token| token.span.end);
        Term { span: from..to.max(from), form }
    }

    /// Reads a range of tokens as one complete sum.
    fn within(&mut self, range: Range<usize>) -> Read<Term> {
        if self.depth >= MOST_DEEP {
            let title = format!("groups deeper than {MOST_DEEP}");
            return Err(self.refused(range.start, title, "here", "fewer groups within each other"));
        }
        if range.is_empty() {
            let title = "an empty group";
            return Err(self.refused(range.start.saturating_sub(1), title, "nothing stands in it", "an expression"));
        }
        let outer = (self.at, self.end);
        (self.at, self.end) = (range.start, range.end);
        self.depth += 1;
        let found = self.sum();
        self.skip_space();
        let rest = self.peek().cloned();
        self.depth -= 1;
        (self.at, self.end) = outer;
        let found = found?;
        match rest {
            None => Ok(found),
            Some(token) => Err(self.unexpected(&token)),
        }
    }

    fn peek(&self) -> Option<&'a Token> {
        self.peek_at(0)
    }

    fn peek_at(&self, ahead: usize) -> Option<&'a Token> {
        let place = self.at + ahead;
        if place < self.end { self.tokens.get(place) } else { None }
    }

    fn sign(&self) -> Option<char> {
        match self.peek()?.kind {
            Kind::Sign(sign) => Some(sign),
            _ => None,
        }
    }

    fn skip_space(&mut self) {
        while self.peek().is_some_and(|token| token.kind == Kind::Space) {
            self.at += 1;
        }
    }

    /// Returns the index of the bracket that closes the bracket at `open`.
    fn partner(&self, open: usize) -> usize {
        let mut depth = 0usize;
        for (place, token) in self.tokens.iter().enumerate().skip(open) {
            match &token.kind {
                Kind::Open | Kind::Sign('(' | '[') => depth += 1,
                Kind::Close | Kind::Sign(')' | ']') => depth -= 1,
                Kind::Command(name) if name == "{" => depth += 1,
                Kind::Command(name) if name == "}" => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                return place;
            }
        }
        self.tokens.len() - 1
    }

    fn text_of(&self, range: Range<usize>) -> &'a str {
        match (self.tokens.get(range.start), range.end.checked_sub(1).and_then(|last| self.tokens.get(last))) {
            (Some(first), Some(last)) if first.span.start <= last.span.end => {
                &self.text[first.span.start..last.span.end]
            }
            _ => "",
        }
    }

    /// Returns the bytes of a token; those of the last token if `at` is beyond the end.
    fn place(&self, at: usize) -> Range<usize> {
        let found = self.tokens.get(at.min(self.tokens.len().saturating_sub(1)));
        found.map_or(0..self.text.len().min(1), |token| token.span.clone())
    }

    fn refused(&self, at: usize, title: impl Into<String>, label: &str, accepted: impl Into<String>) -> NotFormula {
        NotFormula::at(self.place(at), title, label, accepted)
    }

    fn unexpected(&self, token: &Token) -> NotFormula {
        let written = &self.text[token.span.clone()];
        let (title, accepted) = match &token.kind {
            Kind::Sign(',' | ';') => {
                ("a comma separates two formulas".to_owned(), "one formula in a claim, numbers with a point: 1.5")
            }
            Kind::Sign('&') => ("`&` stands outside of a matrix".to_owned(), "one formula in a claim"),
            Kind::Command(name) if name == "\\" => {
                ("a line ends here".to_owned(), "one formula in a claim, on one line")
            }
            Kind::Command(name) if name == "pm" || name == "mp" => {
                (format!("`{written}` states two formulas"), "a claim for each sign")
            }
            Kind::Command(name) if name == "approx" || name == "sim" || name == "simeq" => {
                (format!("`{written}` states nothing exact"), "=, <, >, \\leq, \\geq, \\neq, \\iff")
            }
            _ => (format!("`{written}` has no meaning here"), "an operator, a relation or the end of the formula"),
        };
        NotFormula::at(token.span.clone(), title, "not expected here", accepted)
    }
}

fn relation(token: &Token) -> Option<Relation> {
    match &token.kind {
        Kind::Sign('=') => Some(Relation::Equal),
        Kind::Sign('<') => Some(Relation::Less),
        Kind::Sign('>') => Some(Relation::Greater),
        Kind::Command(name) => match name.as_str() {
            "equiv" => Some(Relation::Equal),
            "lt" => Some(Relation::Less),
            "gt" => Some(Relation::Greater),
            "le" | "leq" | "leqslant" => Some(Relation::LessOrEqual),
            "ge" | "geq" | "geqslant" => Some(Relation::GreaterOrEqual),
            "ne" | "neq" => Some(Relation::NotEqual),
            _ => None,
        },
        _ => None,
    }
}

/// Returns whether a token separates two sides of a statement.
pub(crate) fn is_relation(token: &Token) -> bool {
    relation(token).is_some() || is_equivalence(token)
}

fn is_equivalence(token: &Token) -> bool {
    ["iff", "Leftrightarrow", "Longleftrightarrow"].into_iter().any(|name| token.is_command(name))
}

/// Returns whether a token cannot begin a factor.
fn ends_product(token: &Token) -> bool {
    let is_end = |name: &str| {
        matches!(
            name,
            "\\" | "pm" | "mp" | "approx" | "sim" | "simeq" | "}" | "end" | "to" | "rightarrow" | "Rightarrow"
        )
    };
    match &token.kind {
        Kind::Sign(sign) => matches!(sign, '+' | '-' | ')' | ']' | ',' | ';' | '&' | '=' | '<' | '>'),
        Kind::Close => true,
        Kind::Command(name) => relation(token).is_some() || is_equivalence(token) || is_end(name),
        _ => false,
    }
}

fn is_letter(term: &Term) -> bool {
    match &term.form {
        Form::Letter(_) => true,
        Form::Rate(of, _) | Form::Power(of, _) => is_letter(of),
        Form::Product(_, last) => is_letter(last),
        _ => false,
    }
}

fn is_fraction_of_numbers(form: &Form) -> bool {
    let is_number = |term: &Term| matches!(term.form, Form::Number(_));
    matches!(form, Form::Quotient(above, below) if is_number(above) && is_number(below))
}
