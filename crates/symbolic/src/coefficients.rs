//! Expressions as polynomials in some of their symbols: coefficients and degrees.

use crate::graph::Node;
use crate::{Decision, Hypotheses, Sym, decide};
use field::Rational;
use num_traits::{One, Zero};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::fmt;

/// The subexpression that is not a polynomial in the given symbols.
#[derive(Clone, Debug, PartialEq)]
pub struct NotPolynomial(pub Sym);

impl fmt::Display for NotPolynomial {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "not a polynomial in the given symbols: {}", self.0)
    }
}

impl std::error::Error for NotPolynomial {}

/// Coefficients by exponents, in descending order of the exponents.
type Terms = BTreeMap<Reverse<Vec<u32>>, Sym>;

/// Returns (exponents, coefficient) of each monomial in the given symbols, in descending lexicographic order. The terms are expanded but not
/// simplified: a coefficient that is the constant 0 is omitted, one that only equals 0 after simplification is not. If `symbols` contains
/// the reciprocal 1/b, a quotient by b counts as a product with this symbol.
///
/// # Errors
/// [`NotPolynomial`] contains the subexpression in which a symbol occurs in a denominator, an angle, a root or a function.
pub fn coefficients(expression: Sym, symbols: &[Sym]) -> Result<Vec<(Vec<u32>, Sym)>, NotPolynomial> {
    let unit = Reverse(vec![0; symbols.len()]);
    let fixed = |value: Sym| Terms::from([(unit.clone(), value)]);
    let single = |place: usize| {
        let mut exponents = unit.clone();
        exponents.0[place] = 1;
        Terms::from([(exponents, Sym::one())])
    };
    let mut all: FxHashMap<Sym, Terms> = FxHashMap::default();
    for each in Sym::ascending(&[expression]) {
        let of = |a: &Sym| &all[a];
        let is_fixed = |a: &Sym| of(a).keys().all(|exponents| *exponents == unit);
        let terms = match (symbols.iter().position(|symbol| *symbol == each), each.node()) {
            (Some(place), _) => single(place),
            (None, node) if node.children().all(|child| is_fixed(&child)) => fixed(each),
            (None, Node::Sum(a, b)) => sum(of(&a), of(&b), |a, b| a + b),
            (None, Node::Difference(a, b)) => sum(of(&a), of(&b), |a, b| a - b),
            (None, Node::Negation(a)) => sum(&Terms::new(), of(&a), |a, b| a - b),
            (None, Node::Product(a, b)) => product(of(&a), of(&b)),
            (None, Node::Power(a, n)) => (1..n).fold(of(&a).clone(), |power, _| product(&power, of(&a))),
            (None, Node::Quotient(a, b)) if is_fixed(&b) => {
                of(&a).iter().map(|(exponents, value)| (exponents.clone(), *value / b)).collect()
            }
            (None, Node::Quotient(a, b)) if symbols.contains(&(Sym::ONE / b)) => {
                let place = symbols.iter().position(|symbol| *symbol == Sym::ONE / b);
                product(of(&a), &place.map_or_else(Terms::new, single))
            }
            _ => return Err(NotPolynomial(each)),
        };
        all.insert(each, terms);
    }
    let terms = all.remove(&expression).unwrap_or_default();
    Ok(terms.into_iter().filter(|(_, value)| !value.is_zero()).map(|(exponents, value)| (exponents.0, value)).collect())
}

/// Returns the coefficients of a polynomial in one unknown, from the constant upwards. They must be rational numbers. Bring the expression to
/// normal form first ([`normal`](crate::normal)), since terms that cancel are not recognised here.
///
/// # Errors
/// [`NotPolynomial`] contains a subexpression that is not a polynomial, or a coefficient that is not a rational number.
pub fn univariate(expression: Sym, unknown: Sym) -> Result<Vec<Rational>, NotPolynomial> {
    let mut dense = Vec::new();
    for (exponents, c) in coefficients(expression, &[unknown])? {
        let power = exponents.first().map_or(0, |&power| power as usize);
        dense.resize(dense.len().max(power + 1), Rational::zero());
        dense[power] = c.as_constant().ok_or(NotPolynomial(c))?;
    }
    Ok(dense)
}

/// Returns the total degree in the symbols; `None` for zero. Coefficients that vanish under the hypotheses do not count.
///
/// # Errors
/// [`NotPolynomial`], as for [`coefficients`].
pub fn degree(expression: Sym, symbols: &[Sym], hypotheses: &Hypotheses) -> Result<Option<u32>, NotPolynomial> {
    let present = |coefficient: Sym| !matches!(decide(coefficient, hypotheses), Decision::Zero(_));
    let mut terms = coefficients(expression, symbols)?;
    terms.sort_by_key(|(exponents, _)| Reverse(exponents.iter().sum::<u32>()));
    Ok(terms.into_iter().find(|(_, coefficient)| present(*coefficient)).map(|(exponents, _)| exponents.iter().sum()))
}

fn sum(a: &Terms, b: &Terms, combine: fn(Sym, Sym) -> Sym) -> Terms {
    let mut sum = a.clone();
    for (exponents, &value) in b {
        let entry = sum.entry(exponents.clone()).or_insert(Sym::zero());
        *entry = combine(*entry, value);
    }
    sum
}

fn product(a: &Terms, b: &Terms) -> Terms {
    let mut product = Terms::new();
    for (Reverse(p), &x) in a {
        for (Reverse(q), &y) in b {
            let exponents = p.iter().zip(q).map(|(p, q)| p + q).collect();
            *product.entry(Reverse(exponents)).or_insert(Sym::zero()) += x * y;
        }
    }
    product
}
