//! Parser of expressions.

mod quantity;

use super::token::{Placed, Token, tokens};
use super::{Argument, Exponent, Expression, Form, NotExpression, Part, Preposition, Reason, Relation};
use std::ops::Range;

/// The largest depth of nested parentheses.
const DEEPEST: usize = 100;
/// The largest absolute value of an exponent.
const LARGEST: i32 = 64;
/// The largest number of decimals in an exponent.
const MOST_DECIMALS: usize = 3;

/// Parses an expression into its syntax tree.
///
/// # Errors
/// [`NotExpression`] contains the first position that cannot be read, and the reason.
pub fn read(text: &str) -> Result<Expression, NotExpression> {
    let mut reader = Reader {
        text,
        tokens: tokens(text)?,
        at: 0,
        depth: 0,
        expression: Expression { parts: Vec::new(), spans: Vec::new() },
    };
    if reader.whole_quantity() {
        return Ok(reader.expression);
    }
    reader.comparison()?;
    match reader.peek() {
        None => Ok(reader.expression),
        Some(Token::Sign(')')) => Err(reader.wrong(Reason::Parenthesis)),
        Some(_) => Err(reader.wrong(reader.unjoined())),
    }
}

struct Reader<'a> {
    text: &'a str,
    tokens: Vec<Placed<'a>>,
    at: usize,
    depth: usize,
    expression: Expression,
}

impl<'a> Reader<'a> {
    fn peek(&self) -> Option<&Token<'a>> {
        self.tokens.get(self.at).map(|(_, token)| token)
    }

    /// Returns the range of bytes of the next token; an empty range at the end of the text.
    fn span(&self) -> Range<usize> {
        let end = self.text.len();
        self.tokens.get(self.at).map_or(end..end, |(span, _)| span.clone())
    }

    /// Returns the end of the last token that was read.
    fn end(&self) -> usize {
        self.at.checked_sub(1).and_then(|last| self.tokens.get(last)).map_or(0, |(span, _)| span.end)
    }

    fn wrong(&self, reason: Reason) -> NotExpression {
        NotExpression { span: self.span(), reason }
    }

    /// Returns the reason why the next token cannot follow an operand.
    fn unjoined(&self) -> Reason {
        match self.peek() {
            Some(Token::Name("and" | "or")) => Reason::Connective,
            Some(Token::Name("in")) => Reason::Seen,
            Some(Token::Name(name)) => match self.at.checked_sub(1).map(|last| &self.tokens[last].1) {
                Some(Token::Number(number)) => {
                    Reason::Beside { number: (*number).to_owned(), name: (*name).to_owned() }
                }
                _ => Reason::Operator,
            },
            _ => Reason::Operator,
        }
    }

    fn takes(&mut self, sign: char) -> bool {
        let found = self.peek() == Some(&Token::Sign(sign));
        self.at += usize::from(found);
        found
    }

    fn push(&mut self, form: Form, from: usize) -> Part {
        let end = self.end();
        self.expression.parts.push(form);
        self.expression.spans.push(from..end);
        self.expression.whole()
    }

    /// Reads a sum, or a comparison of two sums.
    fn comparison(&mut self) -> Result<Part, NotExpression> {
        let from = self.span().start;
        let left = self.sum()?;
        let relation = match self.peek() {
            Some(Token::Sign('<')) => Relation::Less,
            Some(Token::Sign('≤')) => Relation::LessOrEqual,
            Some(Token::Sign('>')) => Relation::Greater,
            Some(Token::Sign('≥')) => Relation::GreaterOrEqual,
            _ => return Ok(left),
        };
        self.at += 1;
        let right = self.sum()?;
        Ok(self.push(Form::Comparison(relation, left, right), from))
    }

    fn sum(&mut self) -> Result<Part, NotExpression> {
        let from = self.span().start;
        let mut sum = self.product()?;
        loop {
            let plus = self.takes('+');
            if !plus && !self.takes('-') {
                return Ok(sum);
            }
            let term = self.product()?;
            sum = self.push(if plus { Form::Sum(sum, term) } else { Form::Difference(sum, term) }, from);
        }
    }

    fn product(&mut self) -> Result<Part, NotExpression> {
        let from = self.span().start;
        let mut product = self.signed()?;
        loop {
            let form: fn(Part, Part) -> Form = match self.peek() {
                Some(Token::Sign('*')) => Form::Product,
                Some(Token::Sign('/')) => Form::Quotient,
                Some(Token::Dot) => Form::Dot,
                _ => return Ok(product),
            };
            self.at += 1;
            let factor = self.signed()?;
            product = self.push(form(product, factor), from);
        }
    }

    /// Reads signs before a power. A minus binds less tightly than a power: -x^2 is -(x^2).
    fn signed(&mut self) -> Result<Part, NotExpression> {
        let from = self.span().start;
        let mut negative = false;
        loop {
            if self.takes('-') {
                negative = !negative;
            } else if !self.takes('+') {
                let power = self.power()?;
                return Ok(if negative { self.push(Form::Negation(power), from) } else { power });
            }
        }
    }

    fn power(&mut self) -> Result<Part, NotExpression> {
        let from = self.span().start;
        let base = self.atom()?;
        if !self.takes('^') {
            return Ok(base);
        }
        let exponent = self.exponent()?;
        Ok(self.push(Form::Power(base, exponent), from))
    }

    /// Reads an exponent: `2`, `-1`, `1.5`, `(-1)`, `(1/2)`.
    fn exponent(&mut self) -> Result<Exponent, NotExpression> {
        let begin = self.span();
        let closed = self.takes('(');
        let negative = self.takes('-');
        let (mut numerator, mut denominator) = self.share()?;
        if closed && self.takes('/') {
            let (below, per) = self.share()?;
            (numerator, denominator) = (numerator * per, denominator * below);
        }
        if denominator == 0 {
            return Err(NotExpression { span: begin.start..self.end(), reason: Reason::Exponent });
        }
        if closed && !self.takes(')') {
            return Err(self.wrong(Reason::Parenthesis));
        }
        let divisor = common_divisor(numerator, denominator);
        (numerator, denominator) = (numerator / divisor, denominator / divisor);
        if numerator > LARGEST * denominator {
            return Err(NotExpression { span: begin.start..self.end(), reason: Reason::Exponent });
        }
        Ok(Exponent { numerator: if negative { -numerator } else { numerator }, denominator })
    }

    /// Reads an integer or decimal number as a fraction (numerator, denominator).
    fn share(&mut self) -> Result<(i32, i32), NotExpression> {
        let Some(Token::Number(digits)) = self.peek() else { return Err(self.wrong(Reason::Exponent)) };
        let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
        let read = || {
            let per = (decimals.len() <= MOST_DECIMALS).then(|| 10_i32.pow(decimals.len() as u32))?;
            let part = if decimals.is_empty() { 0 } else { decimals.parse::<i32>().ok()? };
            let whole = whole.parse::<i32>().ok().filter(|whole| (0..=LARGEST).contains(whole))?;
            Some((whole * per + part, per))
        };
        let share = read().ok_or_else(|| self.wrong(Reason::Exponent))?;
        self.at += 1;
        Ok(share)
    }

    fn atom(&mut self) -> Result<Part, NotExpression> {
        let from = self.span().start;
        let Some(token) = self.peek().cloned() else { return Err(self.wrong(Reason::Operand)) };
        match token {
            Token::Number(text) => {
                self.at += 1;
                Ok(self.push(Form::Number(text.to_owned()), from))
            }
            Token::Quoted(name) => {
                self.at += 1;
                Ok(self.push(Form::Name(name.to_owned()), from))
            }
            Token::Sign('(') => match self.quantity() {
                Some(form) => Ok(self.push(form, from)),
                None => self.inside(),
            },
            Token::Name(name) => {
                self.at += 1;
                match self.peek() {
                    Some(Token::Sign('(')) => self.call(name, from),
                    Some(Token::Part) => {
                        self.at += 1;
                        let Some(Token::Name(part)) = self.peek().cloned() else {
                            return Err(self.wrong(Reason::Operand));
                        };
                        self.at += 1;
                        Ok(self.push(Form::Member { of: name.to_owned(), name: part.to_owned() }, from))
                    }
                    _ => Ok(self.push(Form::Name(name.to_owned()), from)),
                }
            }
            Token::Sign('*') if self.at > 0 && self.tokens[self.at - 1].1 == Token::Sign('*') => {
                Err(self.wrong(Reason::Stars))
            }
            Token::Sign(_) | Token::Dot | Token::Part => Err(self.wrong(Reason::Operand)),
        }
    }

    /// Reads a sum in parentheses.
    fn inside(&mut self) -> Result<Part, NotExpression> {
        let open = self.open()?;
        let sum = self.sum()?;
        self.close(open)?;
        Ok(sum)
    }

    fn open(&mut self) -> Result<Range<usize>, NotExpression> {
        if self.depth >= DEEPEST {
            return Err(self.wrong(Reason::Depth { most: DEEPEST }));
        }
        let open = self.span();
        self.depth += 1;
        self.at += 1;
        Ok(open)
    }

    fn close(&mut self, open: Range<usize>) -> Result<(), NotExpression> {
        if !self.takes(')') {
            let ended = self.at >= self.tokens.len();
            let (span, reason) = if ended { (open, Reason::Parenthesis) } else { (self.span(), self.unjoined()) };
            return Err(NotExpression { span, reason });
        }
        self.depth -= 1;
        Ok(())
    }

    fn call(&mut self, function: &str, from: usize) -> Result<Part, NotExpression> {
        let open = self.open()?;
        let mut arguments = vec![self.argument()?];
        while self.takes(',') {
            arguments.push(self.argument()?);
        }
        if function == "reaction" && matches!(self.peek(), Some(Token::Name(_))) {
            return Err(self.wrong(Reason::Quotes));
        }
        self.close(open)?;
        Ok(self.push(Form::Call { function: function.to_owned(), arguments }, from))
    }

    fn argument(&mut self) -> Result<Argument, NotExpression> {
        let value = self.comparison()?;
        let preposition = match self.peek() {
            Some(Token::Name("at")) => Preposition::At,
            Some(Token::Name("in")) => Preposition::In,
            _ => return Ok(Argument { value, place: None }),
        };
        self.at += 1;
        let span = self.span();
        let Some(Token::Name(name)) = self.peek().cloned() else { return Err(self.wrong(Reason::Preposition)) };
        self.at += 1;
        if !matches!(self.peek(), Some(Token::Sign(',' | ')')) | None) {
            return Err(self.wrong(match preposition {
                Preposition::At => Reason::Place,
                Preposition::In => Reason::Seen,
            }));
        }
        Ok(Argument { value, place: Some((preposition, name.to_owned(), span)) })
    }
}

fn common_divisor(a: i32, b: i32) -> i32 {
    let (mut divisor, mut rest) = (a.abs(), b.abs());
    while rest != 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    divisor.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> String {
        let read = read(text).unwrap_or_else(|wrong| panic!("{text}: {wrong:?}"));
        fn part(e: &Expression, at: Part) -> String {
            let of = |at: &Part| part(e, *at);
            match &e.parts[at] {
                Form::Number(text) | Form::Name(text) => text.clone(),
                Form::Quantity { number, unit } => format!("[{number} {unit}]"),
                Form::Member { of, name } => format!("{of}.{name}"),
                Form::Negation(a) => format!("(-{})", of(a)),
                Form::Sum(a, b) => format!("({} + {})", of(a), of(b)),
                Form::Difference(a, b) => format!("({} - {})", of(a), of(b)),
                Form::Product(a, b) => format!("({} * {})", of(a), of(b)),
                Form::Quotient(a, b) => format!("({} / {})", of(a), of(b)),
                Form::Dot(a, b) => format!("({} . {})", of(a), of(b)),
                Form::Power(a, Exponent { numerator, denominator }) => format!("{}^({numerator}/{denominator})", of(a)),
                Form::Comparison(relation, a, b) => format!("{} {relation:?} {}", of(a), of(b)),
                Form::Call { function, arguments } => {
                    let each = arguments.iter().map(|Argument { value, place }| match place {
                        None => of(value),
                        Some((word, name, _)) => format!("{} {word:?} {name}", of(value)),
                    });
                    format!("{function}({})", each.collect::<Vec<_>>().join(", "))
                }
            }
        }
        part(&read, read.whole())
    }

    #[test]
    fn expressions_are_read_by_the_usual_precedence() {
        assert_eq!(shown("-x^2 + 2*a/b - c"), "(((-x^(2/1)) + ((2 * a) / b)) - c)");
        assert_eq!(
            shown("O + r*(cos(theta)*N.x + sin(theta)*N.y)"),
            "(O + (r * ((cos(theta) * N.x) + (sin(theta) * N.y))))"
        );
        assert_eq!(shown("velocity(disc at P) . N.x"), "(velocity(disc At P) . N.x)");
        assert_eq!(shown("if(t < (2 s), Fmax, 0)"), "if(t Less [2 s], Fmax, 0)");
        assert_eq!(shown("k*(x - (20 mm))*(-9.81 m/s^2)"), "((k * (x - [20 mm])) * [-9.81 m/s^2])");
        assert_eq!(shown("(2 1/s)*x"), "([2 1/s] * x)");
        assert_eq!(shown("(x^2 + y^2)^(2/4)"), "(x^(2/1) + y^(2/1))^(1/2)");
        assert_eq!(shown("x^1.5"), "x^(3/2)");
        assert_eq!(shown("x^(-0.8)"), "x^(-4/5)");
        assert_eq!(shown("x^(1/3)"), "x^(1/3)");
        assert_eq!(shown("rate(velocity(P in B) in N)"), "rate(velocity(P In B) In N)");
    }

    #[test]
    fn a_text_that_is_no_expression_is_refused_at_its_place() {
        let wrong = |text: &str| read(text).map_err(|wrong| (wrong.span, wrong.reason)).expect_err(text);
        assert_eq!(wrong(""), (0..0, Reason::Operand));
        assert_eq!(wrong("2x"), (1..2, Reason::Beside { number: "2".to_owned(), name: "x".to_owned() }));
        assert_eq!(wrong("a b"), (2..3, Reason::Operator));
        let metre = || Reason::Beside { number: "1".to_owned(), name: "m".to_owned() };
        assert_eq!(wrong("(2 m) - (1 m + (1 m/s)*t)"), (11..12, metre()));
        assert_eq!(wrong("x*(1 m + y)"), (5..6, metre()));
        assert_eq!(wrong("a*(b"), (2..3, Reason::Parenthesis));
        assert_eq!(wrong("a)"), (1..2, Reason::Parenthesis));
        assert_eq!(wrong("x^y"), (2..3, Reason::Exponent));
        assert_eq!(wrong("x^(1/0)"), (2..6, Reason::Exponent));
        assert_eq!(wrong("x^1e3"), (2..5, Reason::Exponent));
        assert_eq!(wrong("x^65"), (2..4, Reason::Exponent));
        assert_eq!(wrong("a # b"), (2..3, Reason::Letter('#')));
        assert_eq!(wrong("velocity(P in)"), (13..14, Reason::Preposition));
        assert_eq!(wrong("a = b"), (2..3, Reason::Equation));
        assert_eq!(wrong("a**2"), (2..3, Reason::Stars));
        assert_eq!(wrong("if(a < b and c < d, 1, 0)"), (9..12, Reason::Connective));
        assert_eq!(wrong(&("(".repeat(101) + "x")).1, Reason::Depth { most: 100 });
    }
}
