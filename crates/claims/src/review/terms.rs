//! The comparison of two equations, monomial by monomial.

use super::meaning;
use field::{Rational, Scalar};
use num_traits::Zero;
use std::collections::BTreeMap;
use std::fmt;
use symbolic::{Dimension, Hypotheses, Node, NormalForm, Sym, normal, parse};

/// The kind of change of a term.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edit {
    Gone,
    New,
    /// The sign changed.
    Sign,
    /// The new term is this factor times the old one.
    Factor(Rational),
}

/// A changed term.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    pub edit: Edit,
    /// The new term, or the old one if it was removed, in left side minus right side.
    pub term: String,
    /// The physical meaning of the term.
    pub meaning: &'static str,
}

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.edit {
            Edit::Gone => write!(f, "lost: {}", self.term)?,
            Edit::New => write!(f, "new: {}", self.term)?,
            Edit::Sign => write!(f, "sign turned: {}", self.term)?,
            Edit::Factor(factor) => write!(f, "{factor} times what it was: {}", self.term)?,
        }
        write!(f, "  ({})", self.meaning)
    }
}

/// The factors of a monomial except its number, with their powers, ordered by name.
type Key = Vec<(String, u32)>;

/// Monomials by their factors: the numerical coefficient, and the monomial without it.
type Monomials = BTreeMap<Key, (Rational, Sym)>;

/// The terms that differ between two equations `left = right`; `None` where one cannot be parsed. A common factor is not a difference.
///
/// ```
/// use dalembert_claims::review::{Edit, compare};
/// let terms = compare("m*x'' = -k*x", "m*x'' = k*x", &|_| None).expect("both are read");
/// assert_eq!((terms.len(), terms[0].edit, terms[0].term.as_str()), (1, Edit::Sign, "-k*x"));
/// ```
pub fn compare(old: &str, new: &str, dimension: &dyn Fn(&str) -> Option<Dimension>) -> Option<Vec<Term>> {
    let (old, new) = (residual(old)?, residual(new)?);
    let denominators = (old.denominator(), new.denominator());
    // both sums are brought to a common denominator
    let (old, new) = match Hypotheses::none().equal(denominators.0, denominators.1).is_zero() {
        true => (monomials(old.numerator())?, monomials(new.numerator())?),
        false => {
            let over = |above: Sym, below: Sym| normal(above * below, &Hypotheses::none()).ok();
            let crossed = [over(old.numerator(), denominators.1)?, over(new.numerator(), denominators.0)?];
            (monomials(crossed[0].numerator())?, monomials(crossed[1].numerator())?)
        }
    };
    if scaled(&old, &new) {
        return Some(Vec::new());
    }
    let mut terms = Vec::new();
    let mut push = |edit, (coefficient, monomial): (Rational, Sym)| {
        let term = (Sym::constant(coefficient) * monomial).to_string();
        terms.push(Term { edit, term, meaning: meaning(monomial, dimension) });
    };
    for (key, &(before, monomial)) in &old {
        match new.get(key) {
            None => push(Edit::Gone, (before, monomial)),
            Some(&(now, _)) if now == before => {}
            Some(&(now, _)) if now == -before => push(Edit::Sign, (now, monomial)),
            Some(&(now, _)) => push(Edit::Factor(now / before), (now, monomial)),
        }
    }
    for (_, &now) in new.iter().filter(|(key, _)| !old.contains_key(*key)) {
        push(Edit::New, now);
    }
    Some(terms)
}

/// Left side minus right side of an equation `left = right`.
fn residual(equation: &str) -> Option<NormalForm> {
    let (left, right) = equation.split_once(" = ")?;
    let read = |text: &str| parse(text, &|name| Some(Sym::symbol(name))).ok();
    normal(read(left)? - read(right)?, &Hypotheses::none()).ok()
}

/// Whether all monomials of one sum are the same multiple of those of the other, so that the equations are equivalent.
fn scaled(old: &Monomials, new: &Monomials) -> bool {
    let mut factors = old.iter().map(|(key, (before, _))| new.get(key).map(|(now, _)| *now / *before));
    let first = factors.next();
    old.len() == new.len() && first.is_none_or(|first| first.is_some() && factors.all(|factor| factor == first))
}

/// The monomials of a sum that is written out; `None` where it is not expanded.
fn monomials(sum: Sym) -> Option<Monomials> {
    let mut monomials = Monomials::new();
    let mut open = vec![(sum, Rational::int(1))];
    while let Some((next, sign)) = open.pop() {
        match next.node() {
            Node::Sum(a, b) => open.extend([(a, sign), (b, sign)]),
            Node::Difference(a, b) => open.extend([(a, sign), (b, -sign)]),
            Node::Negation(a) => open.push((a, -sign)),
            _ => {
                let (coefficient, factors) = factors(next)?;
                let key: Key = factors.iter().map(|(factor, power)| (factor.to_string(), *power)).collect();
                let monomial =
                    factors.iter().fold(Sym::int(1), |product, (factor, power)| product * factor.powi(*power as i32));
                let entry = monomials.entry(key).or_insert((Rational::int(0), monomial));
                entry.0 += sign * coefficient;
            }
        }
    }
    monomials.retain(|_, (coefficient, _)| !coefficient.is_zero());
    Some(monomials)
}

/// The numerical coefficient of a product, and its other factors with their powers, ordered by name.
fn factors(product: Sym) -> Option<(Rational, Vec<(Sym, u32)>)> {
    let mut coefficient = Rational::int(1);
    let mut factors: BTreeMap<String, (Sym, u32)> = BTreeMap::new();
    let mut open = vec![(product, 1)];
    while let Some((next, power)) = open.pop() {
        match next.node() {
            Node::Product(a, b) => open.extend([(a, power), (b, power)]),
            Node::Power(a, n) => open.push((a, power * n)),
            Node::Negation(a) => {
                coefficient = if power % 2 == 1 { -coefficient } else { coefficient };
                open.push((a, power));
            }
            Node::Constant(_) => {
                let value = next.as_constant()?;
                coefficient = (0..power).fold(coefficient, |product, _| product * value);
            }
            _ => factors.entry(next.to_string()).or_insert((next, 0)).1 += power,
        }
    }
    Some((coefficient, factors.into_values().collect()))
}
