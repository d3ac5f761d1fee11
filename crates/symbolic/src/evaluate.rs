//! Evaluation of an expression in any field.

use crate::Sym;
use crate::graph::Node;
use dashu_int::ops::UnsignedAbs;
use field::{Analytic, Rational, Scalar};
use rustc_hash::FxHashMap;
use std::fmt;

/// The name of a quantity for which no value was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unbound(pub String);

impl fmt::Display for Unbound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no value is given for `{}`", self.0)
    }
}

impl std::error::Error for Unbound {}

impl Sym {
    /// Returns the value in a field from the values of the generators by name: a symbol by its name, cosine and sine of a symbol x as `cos x` and
    /// `sin x`, other generators by their text, such as `sqrt(a + b)` or `M2(s)`.
    ///
    /// # Errors
    /// [`Unbound`] contains the first generator without a value.
    pub fn evaluate<S: Scalar>(self, value: &impl Fn(&str) -> Option<S>) -> Result<S, Unbound> {
        self.evaluate_leaves(|leaf, _| value(&leaf.text_of_leaf()))
    }

    /// Returns the value in a field that has its own sines, cosines and roots, from the values of the symbols by name. Values of
    /// functions are looked up by their text.
    ///
    /// # Errors
    /// [`Unbound`] contains the first symbol or function without a value.
    pub fn evaluate_analytic<S: Analytic>(self, value: &impl Fn(&str) -> Option<S>) -> Result<S, Unbound> {
        self.evaluate_leaves(|leaf, [argument, other]: [Option<S>; 2]| match (leaf.node(), argument) {
            (Node::Cos(_), Some(angle)) => Some(angle.circle().cos),
            (Node::Sin(_), Some(angle)) => Some(angle.circle().sin),
            (Node::Root(_), Some(square)) => Some(square.sqrt()),
            (Node::Elementary(function, ..), Some(first)) => Some(first.elementary(function, other?)),
            _ => value(&leaf.text_of_leaf()),
        })
    }

    /// Evaluates the expression. `leaf` gives the value of a symbol, cosine, sine, root or function from the values of its arguments, as far as they are known.
    pub(crate) fn evaluate_leaves<S: Scalar>(
        self,
        mut leaf: impl FnMut(Sym, [Option<S>; 2]) -> Option<S>,
    ) -> Result<S, Unbound> {
        let mut values: FxHashMap<Sym, S> = FxHashMap::default();
        let mut missing = None;
        for each in Sym::ascending(&[self]) {
            let of = |a| values.get(&a).copied();
            let both = |a, b| Some((of(a)?, of(b)?));
            let value = match each.node() {
                Node::Constant(_) => each.as_constant().map(constant),
                Node::Sum(a, b) => both(a, b).map(|(a, b)| a + b),
                Node::Difference(a, b) => both(a, b).map(|(a, b)| a - b),
                Node::Product(a, b) => both(a, b).map(|(a, b)| a * b),
                Node::Quotient(a, b) => both(a, b).map(|(a, b)| a / b),
                Node::Negation(a) => of(a).map(|a| -a),
                Node::Power(a, n) => of(a).map(|a| num_traits::pow(a, n as usize)),
                Node::Symbol(_) => leaf(each, [None; 2]),
                Node::Cos(a) | Node::Sin(a) | Node::Root(a) | Node::Function(_, _, a) => leaf(each, [of(a), None]),
                Node::Elementary(_, a, b) => leaf(each, [of(a), of(b)]),
            };
            match value {
                Some(value) => drop(values.insert(each, value)),
                None => missing = missing.or(Some(each)),
            }
        }
        // missing values are recorded in ascending order, hence the first is a generator
        values.get(&self).copied().ok_or_else(|| Unbound(missing.unwrap_or(self).text_of_leaf()))
    }

    /// Returns the name under which the value of a generator is looked up.
    pub(crate) fn text_of_leaf(self) -> String {
        match self.node() {
            Node::Cos(a) if matches!(a.node(), Node::Symbol(_)) => format!("cos {a}"),
            Node::Sin(a) if matches!(a.node(), Node::Symbol(_)) => format!("sin {a}"),
            _ => self.to_string(),
        }
    }
}

/// Converts an exact constant to any field. Integers beyond 64 bits are converted byte by byte.
pub(crate) fn constant<S: Scalar>(value: Rational) -> S {
    let Some(big) = value.to_big() else {
        return S::one() / S::zero();
    };
    let (numerator, denominator) = (big.numerator(), big.denominator());
    match (i64::try_from(numerator), i64::try_from(denominator)) {
        (Ok(n), Ok(d)) => S::ratio(n, d),
        _ => {
            let [n, d] = [numerator.clone().unsigned_abs(), denominator.clone()].map(|n| n.to_le_bytes());
            let aside = n.len().max(d.len()).saturating_sub(MOST_BYTES);
            let size = scaled::<S>(&n, aside) / scaled::<S>(&d, aside);
            if value.sign() == Some(-1) { -size } else { size }
        }
    }
}

/// The largest number of bytes of an integer that converts to every field without overflow.
const MOST_BYTES: usize = 100;

/// Converts an integer, given by its bytes from the lowest, and divided by 256^aside. In a field that rounds, the lowest bytes are then
/// negligible.
fn scaled<S: Scalar>(digits: &[u8], aside: usize) -> S {
    let base = S::int(256);
    let (low, high) = digits.split_at(aside.min(digits.len()));
    let fraction = low.iter().fold(S::zero(), |sum, &byte| (sum + S::int(byte.into())) / base);
    // integers with fewer than `aside` bytes need further divisions
    let fraction = (digits.len()..aside).fold(fraction, |fraction, _| fraction / base);
    high.iter().rev().fold(S::zero(), |sum, &byte| sum * base + S::int(byte.into())) + fraction
}
