//! Physical dimensions of expressions.

use crate::Sym;
use crate::graph::Node;
use field::{Elementary, Rational};
use num_traits::{One, Zero};
use rustc_hash::FxHashMap;
use std::fmt;
use std::ops::{Div, Mul};

/// A physical dimension: rational exponents of kilogram, metre, second and ampere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dimension {
    exponents: [Rational; 4],
}

const UNITS: [&str; 4] = ["kg", "m", "s", "A"];

impl Dimension {
    /// Creates a dimension from integer exponents of kg, m, s and A.
    pub fn of(kg: i64, m: i64, s: i64, a: i64) -> Self {
        Dimension { exponents: [kg, m, s, a].map(|exponent| Rational::new(exponent, 1)) }
    }

    /// Returns the dimension of pure numbers and angles.
    pub fn none() -> Self {
        Self::of(0, 0, 0, 0)
    }

    /// Returns the dimension of a mass (kg).
    pub fn mass() -> Self {
        Self::of(1, 0, 0, 0)
    }

    /// Returns the dimension of a length (m).
    pub fn length() -> Self {
        Self::of(0, 1, 0, 0)
    }

    /// Returns the dimension of a time (s).
    pub fn time() -> Self {
        Self::of(0, 0, 1, 0)
    }

    /// Returns the dimension of an electric current (A).
    pub fn current() -> Self {
        Self::of(0, 0, 0, 1)
    }

    /// Returns the exponents of kg, m, s and A.
    pub fn exponents(self) -> [Rational; 4] {
        self.exponents
    }

    /// Returns this dimension raised to a rational power.
    pub fn power(self, exponent: Rational) -> Self {
        Dimension { exponents: self.exponents.map(|own| own * exponent) }
    }
}

impl Mul for Dimension {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Dimension { exponents: std::array::from_fn(|i| self.exponents[i] + other.exponents[i]) }
    }
}

impl Div for Dimension {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Dimension { exponents: std::array::from_fn(|i| self.exponents[i] - other.exponents[i]) }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let powers = UNITS.iter().zip(self.exponents).filter(|(_, exponent)| !exponent.is_zero());
        let named: Vec<String> = powers
            .map(|(unit, exponent)| match exponent.to_string() {
                _ if exponent.is_one() => unit.to_string(),
                fraction if fraction.contains('/') => format!("{unit}^({fraction})"),
                whole => format!("{unit}^{whole}"),
            })
            .collect();
        if named.is_empty() { write!(f, "1") } else { write!(f, "{}", named.join(" ")) }
    }
}

/// The reason why an expression has no dimension.
#[derive(Clone, Debug, PartialEq)]
pub enum Mismatch {
    /// Two added or subtracted terms of different dimensions.
    Sum(Box<[(Sym, Dimension); 2]>),
    /// The argument of a function, such as a cosine or a logarithm, is not a pure number.
    Argument { function: &'static str, argument: Sym, dimension: Dimension },
    /// The dimension of this symbol or function is not known.
    Unknown(Sym),
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Mismatch::Sum(terms) => {
                let [(left, first), (right, second)] = **terms;
                write!(f, "`{left}` has the dimension {first} and `{right}` has {second}")
            }
            Mismatch::Argument { function, argument, dimension } => {
                write!(
                    f,
                    "the argument `{argument}` of `{function}` has the dimension {dimension} and should have none"
                )
            }
            Mismatch::Unknown(symbol) => write!(f, "the dimension of `{symbol}` is not known"),
        }
    }
}

impl std::error::Error for Mismatch {}

/// Returns the dimension of an expression from the dimensions of its symbols. `lookup` gives the dimension of a symbol, or of the values of a function, by name;
/// derivatives of functions follow from these. `None` means zero, which has every dimension.
///
/// # Errors
/// [`Mismatch`] contains the first sum, argument or symbol without a consistent dimension.
pub fn dimension(expression: Sym, lookup: &impl Fn(&str) -> Option<Dimension>) -> Result<Option<Dimension>, Mismatch> {
    let mut known: FxHashMap<Sym, Option<Dimension>> = FxHashMap::default();
    for each in Sym::ascending(&[expression]) {
        let of = |a: Sym| known[&a];
        let both = |a, b| Some((of(a)?, of(b)?));
        let value = match each.node() {
            Node::Constant(_) => (!each.is_zero()).then(Dimension::none),
            Node::Symbol(name) => Some(lookup(&name.text()).ok_or(Mismatch::Unknown(each))?),
            Node::Sum(left, right) | Node::Difference(left, right) => match (of(left), of(right)) {
                (Some(first), Some(second)) if first != second => {
                    return Err(Mismatch::Sum(Box::new([(left, first), (right, second)])));
                }
                (a, b) => a.or(b),
            },
            Node::Product(a, b) => both(a, b).map(|(a, b)| a * b),
            Node::Quotient(a, b) => both(a, b).map(|(a, b)| a / b),
            Node::Negation(a) => of(a),
            Node::Power(a, n) => of(a).map(|a| a.power(Rational::new(n.into(), 1))),
            Node::Root(a) => of(a).map(|a| a.power(Rational::new(1, 2))),
            Node::Cos(argument) => number("cos", argument, of(argument))?,
            Node::Sin(argument) => number("sin", argument, of(argument))?,
            Node::Elementary(Elementary::Atan2, a, b) => match (of(a), of(b)) {
                (Some(first), Some(second)) if first != second => {
                    return Err(Mismatch::Sum(Box::new([(a, first), (b, second)])));
                }
                _ => Some(Dimension::none()),
            },
            Node::Elementary(function, argument, _) => number(function.name(), argument, of(argument))?,
            Node::Function(name, order, argument) => {
                let own = lookup(&name.text()).ok_or(Mismatch::Unknown(each))?;
                let below = of(argument).unwrap_or(Dimension::none());
                Some(own / below.power(Rational::new(order.into(), 1)))
            }
        };
        known.insert(each, value);
    }
    Ok(known[&expression])
}

/// Returns the dimension of a function value, a pure number.
///
/// # Errors
/// The argument, whose dimension is `own`, is not a pure number.
fn number(function: &'static str, argument: Sym, own: Option<Dimension>) -> Result<Option<Dimension>, Mismatch> {
    match own.filter(|dimension| *dimension != Dimension::none()) {
        Some(dimension) => Err(Mismatch::Argument { function, argument, dimension }),
        None => Ok(Some(Dimension::none())),
    }
}
