//! Conditions on expressions, and exact points at which they are evaluated.

use field::Rational;
use std::fmt;
use symbolic::{Hypotheses, Sym, normal};

/// A condition on an expression: its sign, that it vanishes, or equality with another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// The expression vanishes.
    Zero(Sym),
    /// Both are equal.
    Equal(Sym, Sym),
    /// The expression does not vanish.
    NonZero(Sym),
    /// The expression is positive.
    Positive(Sym),
    /// The expression is positive or zero.
    NotNegative(Sym),
}

impl Condition {
    /// The expression that the condition is about: the difference of the sides of an equality.
    pub fn expression(self) -> Sym {
        match self {
            Self::Zero(e) | Self::NonZero(e) | Self::Positive(e) | Self::NotNegative(e) => e,
            Self::Equal(a, b) => a - b,
        }
    }

    /// The same condition on other expressions.
    pub fn mapped(self, of: impl Fn(Sym) -> Sym) -> Self {
        match self {
            Self::Zero(e) => Self::Zero(of(e)),
            Self::Equal(a, b) => Self::Equal(of(a), of(b)),
            Self::NonZero(e) => Self::NonZero(of(e)),
            Self::Positive(e) => Self::Positive(of(e)),
            Self::NotNegative(e) => Self::NotNegative(of(e)),
        }
    }

    /// Whether it holds at a point; `None` where the point leaves it open or a denominator vanishes there.
    pub fn holds_at(self, point: &Point) -> Option<bool> {
        let value = point.value(self.expression()).filter(|value| value.is_defined())?;
        Some(self.allows(value.sign()?))
    }

    /// Whether its expression may have this sign: -1, 0 or 1.
    pub fn allows(self, sign: i32) -> bool {
        match self {
            Self::Zero(_) | Self::Equal(..) => sign == 0,
            Self::NonZero(_) => sign != 0,
            Self::Positive(_) => sign > 0,
            Self::NotNegative(_) => sign >= 0,
        }
    }

    /// A condition that must not hold where this one is proved: the expression shifted by one, doubled and shifted, or
    /// with its sign turned.
    pub(crate) fn mutated(self) -> Self {
        let one = <Sym as num_traits::One>::one();
        match self {
            Self::Zero(e) => Self::Zero(e + one),
            Self::Equal(a, b) => Self::Equal(a, b + b + one),
            Self::NonZero(_) => Self::NonZero(Sym::ZERO),
            Self::Positive(e) => Self::Positive(-e),
            // it can be shown beside its opposite: where both hold it vanishes
            Self::NotNegative(e) => Self::Positive(-e),
        }
    }

    /// Text and LaTeX for a reader: a long expression in normal form, where that is short; `None` where no formula
    /// tells a reader anything.
    pub(crate) fn shown(self, rules: &Hypotheses) -> Option<(String, String)> {
        let one = |e: Sym, relation: &str, latex: &str| {
            let side = Side::of(e, rules);
            let tells = side.readable && e != Sym::ZERO;
            tells.then(|| (format!("{} {relation} 0", side.text), format!("{} {latex} 0", side.latex)))
        };
        match self {
            Self::Zero(e) => one(e, "=", "="),
            Self::NonZero(e) => one(e, "!=", "\\neq"),
            Self::Positive(e) => one(e, ">", ">"),
            Self::NotNegative(e) => one(e, ">=", "\\geq"),
            Self::Equal(a, b) => {
                let (left, right) = (Side::of(a, rules), Side::of(b, rules));
                let differ = left.text != right.text;
                let one = size(a) <= READABLE || size(b) <= READABLE;
                let both = left.readable && right.readable;
                let repeated = !differ && left.reduced && right.reduced;
                let tells = a != b && !repeated && (one || both && differ);
                tells.then(|| (format!("{} = {}", left.text, right.text), format!("{} = {}", left.latex, right.latex)))
            }
        }
    }

    /// In LaTeX, as written.
    pub fn latex(self) -> String {
        match self {
            Self::Zero(e) => format!("{} = 0", e.latex()),
            Self::Equal(a, b) => format!("{} = {}", a.latex(), b.latex()),
            Self::NonZero(e) => format!("{} \\neq 0", e.latex()),
            Self::Positive(e) => format!("{} > 0", e.latex()),
            Self::NotNegative(e) => format!("{} \\geq 0", e.latex()),
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Zero(e) => write!(f, "{e} = 0"),
            Self::Equal(a, b) => write!(f, "{a} = {b}"),
            Self::NonZero(e) => write!(f, "{e} != 0"),
            Self::Positive(e) => write!(f, "{e} > 0"),
            Self::NotNegative(e) => write!(f, "{e} >= 0"),
        }
    }
}

/// The longest expression, in characters, that is shown; a longer one is named, and the sentence of the claim says what
/// it is.
const READABLE: usize = 420;

/// An expression of at most so many characters is shown as it was written, not in normal form.
const WRITTEN: usize = 64;

/// A normal form replaces an expression only if it has at most so many characters and fewer than half of those that it
/// replaces.
const REDUCED: usize = 120;

fn size(expression: Sym) -> usize {
    expression.to_string().chars().count()
}

/// One side of a condition.
struct Side {
    text: String,
    latex: String,
    readable: bool,
    /// Whether this is a normal form in place of the expression as written.
    reduced: bool,
}

impl Side {
    fn of(expression: Sym, rules: &Hypotheses) -> Self {
        let written = size(expression);
        let form = if written > WRITTEN { normal(expression, rules).ok() } else { None };
        let form = form.filter(|form| !form.is_zero()).map(|form| form.to_sym());
        let form = form.filter(|form| size(*form) <= REDUCED && 2 * size(*form) < written);
        let reduced = form.is_some();
        Side { reduced, ..Self::written(form.unwrap_or(expression)) }
    }

    fn written(expression: Sym) -> Self {
        if size(expression) <= READABLE {
            return Side { text: expression.to_string(), latex: expression.latex(), readable: true, reduced: false };
        }
        let (text, latex) = ("[the derived expression]".into(), r"[\text{the derived expression}]".into());
        Side { text, latex, readable: false, reduced: false }
    }
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
