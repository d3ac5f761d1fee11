//! Form of expressions for reading: sums of products in which angles stay together, cos(a - b) in place of cos(a) cos(b) + sin(a) sin(b), with
//! common factors of parameters outside.
//!
//! Every expression becomes a sum of monomials times cosines and sines of multiple angles, by the product-to-sum formulas. For each
//! monomial the shorter of two forms is then printed: multiple angles, or powers of cosines and sines.

mod circles;
mod divisors;
mod harmonic;
mod sum;
#[cfg(test)]
mod tests;
mod writing;

use field::Rational;
use harmonic::{Harmonic, Multiple};
use rustc_hash::FxHashMap;
use std::rc::Rc;
use sum::Sum;
use symbolic::{Node, Sym};

/// Longer sums are not converted.
const MOST_TERMS: usize = 4_000;

/// The total number of products of terms for one system, after which expressions are not converted.
const MOST_PRODUCTS: usize = 10_000_000;

/// Converts expressions to the form for reading, over a common list of symbols.
pub(crate) struct Reading {
    /// Symbols and other subexpressions that are no sums or products; parameters come first.
    leaves: Vec<Leaf>,
    places: FxHashMap<Sym, u32>,
    /// The number of parameters in `leaves`.
    parameters: u32,
    /// The terms of angles.
    atoms: Vec<Sym>,
    known: FxHashMap<Sym, Option<Rc<Sum>>>,
    /// The remaining number of products of terms.
    left: usize,
}

/// A subexpression that is no sum or product.
struct Leaf {
    expression: Sym,
    /// Whether it is known to be positive.
    is_positive: bool,
    /// The radicand, for a square root.
    square: Option<Rc<Sum>>,
}

impl Reading {
    /// Creates a converter. Each parameter states whether it is positive; products are printed in the order of parameters and letters.
    pub fn new(parameters: impl IntoIterator<Item = (Sym, bool)>, letters: impl IntoIterator<Item = Sym>) -> Self {
        let (leaves, places, atoms, known) = (Vec::new(), FxHashMap::default(), Vec::new(), FxHashMap::default());
        let mut reading = Reading { leaves, places, parameters: 0, atoms, known, left: MOST_PRODUCTS };
        for (letter, is_positive) in parameters {
            let place = reading.leaf(letter, None);
            reading.leaves[place as usize].is_positive = is_positive;
        }
        reading.parameters = reading.leaves.len() as u32;
        for letter in letters {
            reading.leaf(letter, None);
            reading.atoms.push(letter);
        }
        reading
    }

    /// Replaces expressions by symbols wherever they occur.
    #[must_use]
    pub fn with_letters(mut self, letters: impl IntoIterator<Item = (Sym, Sym)>) -> Self {
        for (expression, letter) in letters {
            let place = self.leaf(letter, None);
            self.known.insert(expression, Some(Rc::new(Sum::letter(place))));
        }
        self
    }

    /// Returns the form for reading; a long expression is unchanged.
    pub fn of(&mut self, expression: Sym) -> Sym {
        match self.sum(expression) {
            Some(sum) => self.written(&sum),
            None => expression,
        }
    }

    fn leaf(&mut self, expression: Sym, square: Option<Rc<Sum>>) -> u32 {
        if let Some(&place) = self.places.get(&expression) {
            return place;
        }
        let place = self.leaves.len() as u32;
        self.leaves.push(Leaf { expression, is_positive: false, square });
        self.places.insert(expression, place);
        place
    }

    /// Returns an expression as a sum; `None` if it is too long.
    fn sum(&mut self, expression: Sym) -> Option<Rc<Sum>> {
        let mut open = vec![(expression, false)];
        while let Some((next, is_ready)) = open.pop() {
            if self.known.contains_key(&next) {
                continue;
            }
            let inside: Vec<Sym> = match next.node() {
                Node::Sum(a, b) | Node::Difference(a, b) | Node::Product(a, b) | Node::Quotient(a, b) => vec![a, b],
                Node::Negation(a) | Node::Power(a, _) | Node::Root(a) => vec![a],
                _ => Vec::new(),
            };
            if is_ready || inside.is_empty() {
                let sum = self.formed(next).filter(|sum| sum.len() <= MOST_TERMS).map(Rc::new);
                self.known.insert(next, sum);
            } else {
                open.push((next, true));
                open.extend(inside.into_iter().rev().map(|part| (part, false)));
            }
        }
        self.known[&expression].clone()
    }

    /// Returns an expression as a sum, from the sums of its operands.
    fn formed(&mut self, expression: Sym) -> Option<Sum> {
        let known = |reading: &Self, part: &Sym| reading.known[part].clone();
        Some(match expression.node() {
            Node::Constant(_) => Sum::constant(expression.as_constant()?),
            Node::Sum(a, b) => known(self, &a)?.plus(&*known(self, &b)?, 1),
            Node::Difference(a, b) => known(self, &a)?.plus(&*known(self, &b)?, -1),
            Node::Negation(a) => Sum::default().plus(&*known(self, &a)?, -1),
            Node::Product(a, b) => {
                let (a, b) = (known(self, &a)?, known(self, &b)?);
                self.product(&a, &b)?
            }
            Node::Power(a, n) => {
                let base = known(self, &a)?;
                let mut power = (*base).clone();
                for _ in 1..n {
                    power = self.product(&power, &base)?;
                }
                power
            }
            Node::Quotient(a, b) => {
                let (above, below) = (known(self, &a)?, known(self, &b)?);
                let reciprocal = self.reciprocal(&below)?;
                self.product(&above, &reciprocal)?
            }
            Node::Root(a) => {
                let square = known(self, &a)?;
                match square.root(|place| self.leaves[place as usize].is_positive) {
                    Some(root) => root,
                    None => {
                        let root = field::Analytic::sqrt(self.written(&square));
                        Sum::letter(self.leaf(root, Some(square)))
                    }
                }
            }
            Node::Cos(angle) => Sum::circle(self.harmonic(angle)?, false),
            Node::Sin(angle) => Sum::circle(self.harmonic(angle)?, true),
            Node::Elementary(function, a, b) => {
                let [a, b] = [a, b].map(|argument| self.of(argument));
                Sum::letter(self.leaf(field::Analytic::elementary(a, function, b), None))
            }
            _ => Sum::letter(self.leaf(expression, None)),
        })
    }

    /// Returns an angle as a linear combination of its terms.
    fn harmonic(&mut self, angle: Sym) -> Option<Harmonic> {
        let mut multiples = Vec::new();
        for (term, coefficient) in angle.linear_terms() {
            let atom = match self.atoms.iter().position(|known| *known == term) {
                Some(atom) => atom,
                None => {
                    self.atoms.push(term);
                    self.atoms.len() - 1
                }
            };
            multiples.push((atom as u32, Multiple::of(coefficient)?));
        }
        Some(Harmonic::of(multiples))
    }

    /// Returns a product, with squares of square roots replaced by their radicands.
    fn product(&mut self, a: &Sum, b: &Sum) -> Option<Sum> {
        self.left = self.left.checked_sub(a.len() * b.len())?;
        let product = a.times(b, MOST_TERMS)?;
        let is_power =
            |&(place, exponent): &(u32, i32)| exponent.abs() >= 2 && self.leaves[place as usize].square.is_some();
        if !product.monomials().any(|monomial| monomial.iter().any(is_power)) {
            return Some(product);
        }
        let mut reduced = Sum::default();
        for mut term in product.terms() {
            let mut factor = Sum::constant(Rational::new(1, 1));
            for power in &mut term.monomial {
                let Some(square) = self.leaves[power.0 as usize].square.clone() else { continue };
                let squares = power.1 / 2;
                power.1 -= 2 * squares;
                let square = if squares < 0 { Rc::new(self.reciprocal(&square)?) } else { square };
                for _ in 0..squares.abs() {
                    factor = self.product(&factor, &square)?;
                }
            }
            term.monomial.retain(|(_, exponent)| *exponent != 0);
            reduced = reduced.plus(&factor.times(&Sum::of(term), MOST_TERMS)?, 1);
        }
        Some(reduced)
    }
}
