//! Parser of expressions in the notation in which they are printed: `-1/2*m*(x^2 + y^2)/sqrt(1 - e^2) + b0*cos(g)`.
//!
//! | | |
//! |---|---|
//! | sums, products | `+ - * /` from the left, `^` with an integer exponent, parentheses |
//! | numbers | `3`, `0.25`, `1e-4`: exact decimals |
//! | functions | `sqrt`, `cos`, `sin` |
//! | names | letters of any script, digits, `_`, primes, stars and combining marks |
//!
//! A product needs its sign `*`: `2x` and `a b` are errors, since a name may contain digits.

mod token;

use crate::Sym;
use field::Analytic;
use std::fmt;
use std::ops::Range;
use token::{Token, tokens};

/// The largest depth of nested parentheses.
const DEEPEST: usize = 100;
/// The largest exponent of `^`.
const LARGEST: i32 = 64;
/// The largest number of digits of a power of a number.
const DIGITS: usize = 1000;

/// The reason why a text is not an expression, with the position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotExpression {
    /// The range of bytes that cannot be read.
    pub span: Range<usize>,
    pub reason: Reason,
}

/// The kinds of errors in an expression.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The text ends, or an operator occurs, where an operand is required.
    Operand,
    /// Two operands have no operator between them.
    Operator,
    /// A character that does not occur in expressions.
    Letter(char),
    /// An invalid number: malformed, longer than 60 digits, or with an exponent beyond 60; or a power of a number with more than 1000 digits.
    Number,
    /// A name that the caller does not know.
    Name(String),
    /// A name before parentheses that is not a function.
    Function(String),
    /// A parenthesis without its partner.
    Parenthesis,
    /// An exponent that is not an integer from -64 to 64.
    Exponent,
    /// A division by zero.
    Zero,
    /// Parentheses nested deeper than 100 levels.
    Depth,
    /// The [`Vocabulary`] rejects this part; the text gives the reason.
    Refused(String),
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Operand => write!(f, "a number, a name, a function or a parenthesis is expected here"),
            Self::Operator => write!(f, "one of + - * / ^ is expected here; products are written with *"),
            Self::Letter(letter) => write!(f, "{letter:?} has no meaning here"),
            Self::Number => write!(f, "no number of at most 60 digits and 1e60"),
            Self::Name(name) => write!(f, "`{name}` is not known here"),
            Self::Function(name) => write!(f, "`{name}` is no function: sqrt, cos and sin are"),
            Self::Parenthesis => write!(f, "this parenthesis is not closed"),
            Self::Exponent => write!(f, "an exponent is an integer from -{LARGEST} to {LARGEST}"),
            Self::Zero => write!(f, "a division by zero"),
            Self::Depth => write!(f, "parentheses deeper than {DEEPEST}"),
            Self::Refused(why) => write!(f, "{why}"),
        }
    }
}

impl fmt::Display for NotExpression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} (byte {})", self.reason, self.span.start)
    }
}

impl std::error::Error for NotExpression {}

/// The names and subexpressions that a caller accepts.
pub trait Vocabulary {
    /// Returns the expression that a name stands for. `in_angle` is true inside the argument of a cosine or sine.
    ///
    /// # Errors
    /// The reason why the name is not accepted here.
    fn name(&self, name: &str, in_angle: bool) -> Result<Sym, Reason>;

    /// Checks a subexpression; its operands were checked before.
    ///
    /// # Errors
    /// The reason why the subexpression is not accepted. It is reported at the position of the subexpression, for a sum at that of the last term.
    fn judge(&self, _part: Sym) -> Result<(), Reason> {
        Ok(())
    }
}

/// A vocabulary of names without further rules.
struct Names<'a>(&'a dyn Fn(&str) -> Option<Sym>);

impl Vocabulary for Names<'_> {
    fn name(&self, name: &str, _in_angle: bool) -> Result<Sym, Reason> {
        (self.0)(name).ok_or_else(|| Reason::Name(name.to_owned()))
    }
}

/// Parses an expression; `known` gives the expression that each name stands for.
///
/// # Errors
/// [`NotExpression`] contains the first position that cannot be read, and the reason.
pub fn parse(text: &str, known: &dyn Fn(&str) -> Option<Sym>) -> Result<Sym, NotExpression> {
    parse_in(text, &Names(known))
}

/// Parses an expression whose names and subexpressions are checked by a vocabulary.
///
/// # Errors
/// [`NotExpression`] contains the first position that cannot be read or is not accepted, and the reason.
pub fn parse_in(text: &str, vocabulary: &dyn Vocabulary) -> Result<Sym, NotExpression> {
    let mut reader = Reader { tokens: tokens(text)?, at: 0, end: text.len(), depth: 0, angles: 0, vocabulary };
    let expression = reader.sum()?;
    match reader.peek() {
        None => Ok(expression),
        Some(Token::Sign(')')) => Err(reader.wrong(Reason::Parenthesis)),
        Some(_) => Err(reader.wrong(Reason::Operator)),
    }
}

struct Reader<'a> {
    tokens: Vec<(Range<usize>, Token<'a>)>,
    at: usize,
    end: usize,
    depth: usize,
    /// The number of enclosing cosines and sines.
    angles: usize,
    vocabulary: &'a dyn Vocabulary,
}

impl<'a> Reader<'a> {
    fn peek(&self) -> Option<&Token<'a>> {
        self.tokens.get(self.at).map(|(_, token)| token)
    }

    /// Returns the range of bytes of the next token; an empty range at the end of the text.
    fn span(&self) -> Range<usize> {
        self.tokens.get(self.at).map_or(self.end..self.end, |(span, _)| span.clone())
    }

    fn wrong(&self, reason: Reason) -> NotExpression {
        NotExpression { span: self.span(), reason }
    }

    fn takes(&mut self, sign: char) -> bool {
        let found = self.peek() == Some(&Token::Sign(sign));
        self.at += usize::from(found);
        found
    }

    /// Passes a subexpression that begins at the byte `from` to the vocabulary, and returns it if it is accepted.
    fn judged(&self, part: Sym, from: usize) -> Result<Sym, NotExpression> {
        let end = self.at.checked_sub(1).and_then(|last| self.tokens.get(last)).map_or(self.end, |(span, _)| span.end);
        let refused = |reason| NotExpression { span: from..end, reason };
        self.vocabulary.judge(part).map(|()| part).map_err(refused)
    }

    fn sum(&mut self) -> Result<Sym, NotExpression> {
        let mut sum = self.product()?;
        loop {
            let plus = self.takes('+');
            if !plus && !self.takes('-') {
                return Ok(sum);
            }
            let from = self.span().start;
            let term = self.product()?;
            sum = self.judged(if plus { sum + term } else { sum - term }, from)?;
        }
    }

    fn product(&mut self) -> Result<Sym, NotExpression> {
        let from = self.span().start;
        let mut product = self.signed()?;
        loop {
            if self.takes('*') {
                let factor = self.signed()?;
                product = self.judged(product * factor, from)?;
            } else if self.takes('/') {
                let span = self.span();
                let divisor = self.signed()?;
                if divisor == Sym::ZERO {
                    return Err(NotExpression { span, reason: Reason::Zero });
                }
                product = self.judged(product / divisor, from)?;
            } else {
                return Ok(product);
            }
        }
    }

    /// Reads signs before a power. A minus binds less tightly than a power: -x^2 is -(x^2).
    fn signed(&mut self) -> Result<Sym, NotExpression> {
        let mut negative = false;
        loop {
            if self.takes('-') {
                negative = !negative;
            } else if !self.takes('+') {
                let power = self.power()?;
                return Ok(if negative { -power } else { power });
            }
        }
    }

    fn power(&mut self) -> Result<Sym, NotExpression> {
        let from = self.span().start;
        let base = self.atom()?;
        if !self.takes('^') {
            return Ok(base);
        }
        let span = self.span();
        let bad = NotExpression { span: span.clone(), reason: Reason::Exponent };
        let closed = self.takes('(');
        let negative = self.takes('-');
        let Some(Token::Number(digits)) = self.peek() else { return Err(bad) };
        let size: i32 = digits.parse().ok().filter(|size| *size <= LARGEST).ok_or(bad)?;
        self.at += 1;
        if closed && !self.takes(')') {
            return Err(self.wrong(Reason::Parenthesis));
        }
        let digits = base.as_constant().map_or(0, |value| value.to_string().len());
        if digits * size as usize > DIGITS {
            return Err(NotExpression { span, reason: Reason::Number });
        }
        if negative && base == Sym::ZERO {
            return Err(NotExpression { span, reason: Reason::Zero });
        }
        self.judged(base.powi(if negative { -size } else { size }), from)
    }

    fn atom(&mut self) -> Result<Sym, NotExpression> {
        let span = self.span();
        let Some(token) = self.peek().cloned() else { return Err(self.wrong(Reason::Operand)) };
        match token {
            Token::Number(text) => {
                let value = token::number(text).ok_or_else(|| self.wrong(Reason::Number))?;
                self.at += 1;
                self.judged(Sym::constant(value), span.start)
            }
            Token::Sign('(') => self.inside(),
            Token::Name(name) => {
                self.at += 1;
                if self.peek() == Some(&Token::Sign('(')) {
                    return self.function(name, span);
                }
                self.vocabulary.name(name, self.angles > 0).map_err(|reason| NotExpression { span, reason })
            }
            Token::Sign(_) => Err(self.wrong(Reason::Operand)),
        }
    }

    fn function(&mut self, name: &str, span: Range<usize>) -> Result<Sym, NotExpression> {
        let meaning: fn(Sym) -> Sym = match name {
            "sqrt" => Sym::sqrt,
            "cos" => |angle| angle.circle().cos,
            "sin" => |angle| angle.circle().sin,
            _ => return Err(NotExpression { span, reason: Reason::Function(name.to_owned()) }),
        };
        let angle = usize::from(name != "sqrt");
        self.angles += angle;
        let argument = self.inside()?;
        self.angles -= angle;
        self.judged(meaning(argument), span.start)
    }

    /// Reads a sum in parentheses.
    fn inside(&mut self) -> Result<Sym, NotExpression> {
        let open = self.span();
        if self.depth >= DEEPEST {
            return Err(self.wrong(Reason::Depth));
        }
        self.depth += 1;
        self.at += 1;
        let sum = self.sum()?;
        if !self.takes(')') {
            let reason = if self.at < self.tokens.len() { Reason::Operator } else { Reason::Parenthesis };
            let span = if self.at < self.tokens.len() { self.span() } else { open };
            return Err(NotExpression { span, reason });
        }
        self.depth -= 1;
        Ok(sum)
    }
}
