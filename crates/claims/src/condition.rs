//! Conditions on expressions, and exact points at which they are evaluated.

use field::Rational;
use std::fmt;
use symbolic::{Hypotheses, Sym, normal};

/// A condition on expressions: a sign, a zero, or an equality.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// The expression vanishes.
    Zero(Sym),
    /// The two expressions are equal.
    Equal(Sym, Sym),
    /// The expression does not vanish.
    NonZero(Sym),
    /// The expression is positive.
    Positive(Sym),
    /// The expression is positive or zero.
    NotNegative(Sym),
}

impl Condition {
    /// The expression whose sign decides the condition: of an equality the difference of its sides.
    pub fn expression(self) -> Sym {
        match self {
            Self::Zero(e) | Self::NonZero(e) | Self::Positive(e) | Self::NotNegative(e) => e,
            Self::Equal(a, b) => a - b,
        }
    }

    /// The condition with each expression replaced by its image.
    pub fn mapped(self, of: impl Fn(Sym) -> Sym) -> Self {
        match self {
            Self::Zero(e) => Self::Zero(of(e)),
            Self::Equal(a, b) => Self::Equal(of(a), of(b)),
            Self::NonZero(e) => Self::NonZero(of(e)),
            Self::Positive(e) => Self::Positive(of(e)),
            Self::NotNegative(e) => Self::NotNegative(of(e)),
        }
    }

    /// Whether the condition holds at a point; `None` where the point does not decide it or a denominator vanishes there.
    pub fn holds_at(self, point: &Point) -> Option<bool> {
        let value = point.value(self.expression()).filter(|value| value.is_defined())?;
        Some(self.allows(value.sign()?))
    }

    /// Whether the condition allows this sign of its expression: -1, 0 or 1.
    pub fn allows(self, sign: i32) -> bool {
        match self {
            Self::Zero(_) | Self::Equal(..) => sign == 0,
            Self::NonZero(_) => sign != 0,
            Self::Positive(_) => sign > 0,
            Self::NotNegative(_) => sign >= 0,
        }
    }

    /// A condition that must fail where this one is proved: the expression shifted by one, doubled and shifted, or
    /// with its sign changed.
    pub(crate) fn mutated(self) -> Self {
        let one = <Sym as num_traits::One>::one();
        match self {
            Self::Zero(e) => Self::Zero(e + one),
            Self::Equal(a, b) => Self::Equal(a, b + b + one),
            Self::NonZero(_) => Self::NonZero(Sym::ZERO),
            Self::Positive(e) => Self::Positive(-e),
            // the negation alone could be proved in addition to the condition: both hold where the expression vanishes
            Self::NotNegative(e) => Self::Positive(-e),
        }
    }

    /// The condition as text and as LaTeX for a reader. A long expression is replaced by its normal form where that is short; `None` where no formula
    /// is short enough to read.
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

    /// The condition as LaTeX, without simplification.
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

/// The largest length of an expression that is shown, in characters; a longer expression is not, since the sentence of the claim
/// describes it.
const READABLE: usize = 420;

/// The largest length of an expression, in characters, that is shown without simplification.
const WRITTEN: usize = 64;

/// The largest length of a normal form, in characters, that replaces an expression; it must also be shorter than half of
/// the expression.
const REDUCED: usize = 120;

fn size(expression: Sym) -> usize {
    expression.to_string().chars().count()
}

/// One side of a condition as text and LaTeX.
struct Side {
    text: String,
    latex: String,
    readable: bool,
    /// Whether the text is a normal form instead of the expression itself.
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

/// Exact values of symbols; an angle x is given by the values of `cos x` and `sin x`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Point(Vec<(String, Rational)>);

impl Point {
    /// The point with these values of symbols.
    pub fn of(values: impl IntoIterator<Item = (Sym, Rational)>) -> Self {
        Point(values.into_iter().map(|(symbol, value)| (symbol.to_string(), value)).collect())
    }

    /// The point with these values of names.
    pub fn named(values: impl IntoIterator<Item = (String, Rational)>) -> Self {
        Point(values.into_iter().collect())
    }

    /// The names with their values.
    pub fn values(&self) -> &[(String, Rational)] {
        &self.0
    }

    /// The expression with the values of this point inserted for all symbols except `unknown`.
    pub fn restrict(&self, expression: Sym, unknown: Sym) -> Sym {
        let values: Vec<(Sym, Sym)> = self
            .0
            .iter()
            .map(|(name, value)| (Sym::symbol(name), Sym::constant(*value)))
            .filter(|(symbol, _)| *symbol != unknown)
            .collect();
        expression.substitute(&values)
    }

    /// The exact value of an expression at this point; `None` where a symbol has no value.
    pub fn value(&self, expression: Sym) -> Option<Rational> {
        expression.evaluate(&|name: &str| self.0.iter().find(|(known, _)| known == name).map(|(_, value)| *value)).ok()
    }
}
