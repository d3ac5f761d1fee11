//! Conditions on expressions, and exact points at which they are looked at.

use field::Rational;
use num_traits::Zero;
use std::fmt;
use symbolic::Sym;

/// What an expression is said to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// It vanishes.
    Zero(Sym),
    /// Both are equal.
    Equal(Sym, Sym),
    /// It does not vanish.
    NonZero(Sym),
    /// It is positive.
    Positive(Sym),
}

impl Condition {
    /// The expression that the condition is about: the difference of the sides of an equality.
    pub fn expression(self) -> Sym {
        match self {
            Self::Zero(e) | Self::NonZero(e) | Self::Positive(e) => e,
            Self::Equal(a, b) => a - b,
        }
    }

    /// Whether it holds at a point; `None` where the point leaves it open or a denominator vanishes there.
    pub fn holds_at(self, point: &Point) -> Option<bool> {
        let value = point.value(self.expression()).filter(|value| value.is_defined())?;
        Some(match self {
            Self::Zero(_) | Self::Equal(..) => value.is_zero(),
            Self::NonZero(_) => !value.is_zero(),
            Self::Positive(_) => value.sign() == Some(1),
        })
    }

    /// A condition that should not hold where this one does for a reason: the expression shifted by one, doubled and
    /// shifted, or its sign turned.
    pub(crate) fn mutated(self) -> Self {
        let one = <Sym as num_traits::One>::one();
        match self {
            Self::Zero(e) => Self::Zero(e + one),
            Self::Equal(a, b) => Self::Equal(a, b + b + one),
            Self::NonZero(_) => Self::NonZero(Sym::ZERO),
            Self::Positive(e) => Self::Positive(-e),
        }
    }

    /// Whether its formula tells a reader something: not of one length of derived expressions, not 0 = 0.
    pub(crate) fn tells(self) -> bool {
        match self {
            Self::Zero(e) | Self::NonZero(e) | Self::Positive(e) => readable(e) && e != Sym::ZERO,
            Self::Equal(a, b) => a != b && (readable(a) || readable(b)),
        }
    }

    /// In LaTeX.
    pub fn latex(self) -> String {
        match self {
            Self::Zero(e) => format!("{} = 0", latex(e)),
            Self::Equal(a, b) => format!("{} = {}", latex(a), latex(b)),
            Self::NonZero(e) => format!("{} \\neq 0", latex(e)),
            Self::Positive(e) => format!("{} > 0", latex(e)),
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Zero(e) => write!(f, "{} = 0", text(*e)),
            Self::Equal(a, b) => write!(f, "{} = {}", text(*a), text(*b)),
            Self::NonZero(e) => write!(f, "{} != 0", text(*e)),
            Self::Positive(e) => write!(f, "{} > 0", text(*e)),
        }
    }
}

/// What a reader can take in at once; longer expressions are named, not shown. The sentence of the claim says what
/// they are.
const READABLE: usize = 420;

fn readable(expression: Sym) -> bool {
    expression.to_string().chars().count() <= READABLE
}

fn text(expression: Sym) -> String {
    if readable(expression) { expression.to_string() } else { "[the derived expression]".into() }
}

fn latex(expression: Sym) -> String {
    if readable(expression) { expression.latex() } else { r"[\text{the derived expression}]".into() }
}

/// Exact values of symbols (and of circle coordinates, by the names `cos x` and `sin x`).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point(Vec<(String, Rational)>);

impl Point {
    /// From symbols and their values.
    pub fn of(values: impl IntoIterator<Item = (Sym, Rational)>) -> Self {
        Point(values.into_iter().map(|(symbol, value)| (symbol.to_string(), value)).collect())
    }

    /// From names and values.
    pub fn named(values: impl IntoIterator<Item = (String, Rational)>) -> Self {
        Point(values.into_iter().collect())
    }

    /// The names with their values.
    pub fn values(&self) -> &[(String, Rational)] {
        &self.0
    }

    /// An expression with every symbol but `unknown` at its value here.
    pub fn restrict(&self, expression: Sym, unknown: Sym) -> Sym {
        let values: Vec<(Sym, Sym)> = self
            .0
            .iter()
            .map(|(name, value)| (Sym::symbol(name), Sym::constant(*value)))
            .filter(|(symbol, _)| *symbol != unknown)
            .collect();
        expression.substitute(&values)
    }

    /// The exact value of an expression here, `None` where a symbol has none.
    pub fn value(&self, expression: Sym) -> Option<Rational> {
        expression.evaluate(&|name: &str| self.0.iter().find(|(known, _)| known == name).map(|(_, value)| *value)).ok()
    }
}
