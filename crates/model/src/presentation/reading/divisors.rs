//! Divisors: the common factors of their terms, and each remaining factor, become powers.

use super::sum::{Monomial, Sum, Term, Wave};
use super::writing::{common, content};
use super::{MOST_TERMS, Reading};
use field::Rational;
use std::collections::BTreeMap;
use symbolic::{Node, Sym};

impl Reading {
    /// Returns the reciprocal of a sum, as a monomial with negative exponents. The factors of the sum become generators if necessary.
    pub(super) fn reciprocal(&mut self, below: &Sum) -> Option<Sum> {
        if let Some(inverse) = below.inverse() {
            return Some(inverse);
        }
        // factors the sum first: 4*cos(f)^2 in place of 2*2*cos(f)*cos(f)
        let terms: Vec<(Monomial, Rational)> = below.terms().map(|term| (term.monomial, term.coefficient)).collect();
        let outside = Term { monomial: common(&terms), wave: Wave::default(), coefficient: content(&terms) };
        let outside = Sum::of(outside).inverse()?;
        let mut divisor = self.written(&below.times(&outside, MOST_TERMS)?);
        if divisor == Sym::ZERO {
            return None;
        }
        let mut number = Rational::new(1, 1);
        if leads_negative(divisor) {
            divisor = self.written(&Sum::default().plus(&below.times(&outside, MOST_TERMS)?, -1));
            number = -number;
        }
        let mut powers = BTreeMap::new();
        for (factor, exponent) in factors(divisor) {
            let Some(constant) = factor.as_constant() else {
                *powers.entry(self.leaf(factor, None)).or_insert(0) -= exponent;
                continue;
            };
            let inverse = if exponent < 0 { constant } else { Rational::new(1, 1) / constant };
            number = (0..exponent.abs()).fold(number, |product, _| product * inverse);
        }
        let monomial = powers.into_iter().filter(|(_, exponent)| *exponent != 0).collect();
        Sum::of(Term { monomial, wave: Wave::default(), coefficient: number }).times(&outside, MOST_TERMS)
    }
}

/// Returns whether the first term of a sum is negative.
fn leads_negative(sum: Sym) -> bool {
    let mut first = sum;
    loop {
        first = match first.node() {
            Node::Sum(a, _) | Node::Difference(a, _) | Node::Product(a, _) | Node::Quotient(a, _) => a,
            Node::Negation(_) => return true,
            _ => return first.as_constant().is_some_and(|constant| constant.sign() == Some(-1)),
        };
    }
}

/// Returns the factors of a product with their exponents, which are negative for divisors.
fn factors(product: Sym) -> Vec<(Sym, i32)> {
    let (mut open, mut factors) = (vec![(product, 1)], Vec::new());
    while let Some((next, exponent)) = open.pop() {
        match next.node() {
            Node::Product(a, b) => open.extend([(b, exponent), (a, exponent)]),
            Node::Quotient(a, b) => open.extend([(b, -exponent), (a, exponent)]),
            Node::Power(a, n) => match i32::try_from(n) {
                Ok(n) => open.push((a, n * exponent)),
                Err(_) => factors.push((next, exponent)),
            },
            Node::Negation(a) => open.extend([(a, exponent), (-Sym::ONE, exponent)]),
            _ => factors.push((next, exponent)),
        }
    }
    factors
}
