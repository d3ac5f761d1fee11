//! Conversion of expressions to quotients of polynomials, and back.

use super::failure::Failure;
use super::fraction::{Arithmetic, Fraction};
use super::generators::Generators;
use super::reduce::PolyRule;
use crate::Sym;
use crate::graph::Node;
use algebra::multivariate::{Coefficient, Poly, monomial};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use field::Rational;
use num_traits::One;
use rustc_hash::FxHashMap;
use std::rc::Rc;

type Shared<C, const W: usize> = Rc<Fraction<C, W>>;

/// Converts expressions over a common list of generators. Equal subexpressions are converted once.
pub(super) struct Converter<'a, C, const W: usize> {
    pub generators: &'a Generators,
    pub arithmetic: Arithmetic<C, W>,
    done: FxHashMap<Sym, Shared<C, W>>,
}

impl<'a, C: Coefficient, const W: usize> Converter<'a, C, W> {
    pub fn new(generators: &'a Generators) -> Result<Self, Failure> {
        let mut converter = Converter { generators, arithmetic: Arithmetic::new(), done: FxHashMap::default() };
        // The last rules first: the tail of a rule is reduced by the rules that follow it.
        for rule in generators.rules.iter().rev() {
            let tail = converter.fraction(rule.tail)?;
            let generator = generators.index[&rule.lead];
            let degree = monomial::exponent(&tail.numerator.degrees(), generator);
            if !tail.powers.is_empty() || degree >= rule.power {
                let lead = rule.lead.powi(rule.power as i32);
                let tail = rule.tail;
                return Err(Failure::Hypotheses(format!(
                    "the right side of `{lead} = {tail}` must be a polynomial of lower degree in `{}`",
                    rule.lead
                )));
            }
            let Fraction { numerator: tail, constant: scale, .. } = (*tail).clone();
            converter.arithmetic.rules.insert(0, PolyRule { generator, power: rule.power, scale, tail });
            converter.done.clear();
        }
        Ok(converter)
    }

    /// Converts an expression to a quotient in normal form under the rules.
    ///
    /// The conversion proceeds from the generators upwards, without recursion. A sum that occurs only once, in another sum, is not formed separately:
    /// its terms are added together with those of the outermost sum.
    pub fn fraction(&mut self, expression: Sym) -> Result<Shared<C, W>, Failure> {
        let expression = self.generators.rewrite(expression);
        let order = self.generators.inside(expression);
        self.done.reserve(order.len());
        let inner = inner_sums(&order, expression, self.generators);
        for each in order {
            if self.done.contains_key(&each) || inner.contains_key(&each) {
                continue;
            }
            let value = match self.generators.index.get(&each) {
                Some(&generator) => Fraction::whole(Poly::term(monomial::power(generator, 1)?, C::of(1))),
                None => self.node(each, &inner)?,
            };
            self.done.insert(each, Rc::new(value));
        }
        Ok(self.done[&expression].clone())
    }

    fn node(&mut self, each: Sym, inner: &FxHashMap<Sym, ()>) -> Result<Fraction<C, W>, Failure> {
        match each.node() {
            Node::Constant(_) => constant(each),
            Node::Sum(..) | Node::Difference(..) | Node::Negation(_) => {
                let mut summands: Vec<(Shared<C, W>, bool)> = Vec::new();
                let mut open = vec![(each, false)];
                while let Some((next, negative)) = open.pop() {
                    if next != each && !inner.contains_key(&next) {
                        summands.push((self.done[&next].clone(), negative));
                        continue;
                    }
                    match next.node() {
                        Node::Sum(a, b) => open.extend([(b, negative), (a, negative)]),
                        Node::Difference(a, b) => open.extend([(b, !negative), (a, negative)]),
                        Node::Negation(a) => open.push((a, !negative)),
                        _ => {}
                    }
                }
                Ok(self.arithmetic.sum(summands)?)
            }
            Node::Product(a, b) => {
                let (a, b) = (self.done[&a].clone(), self.done[&b].clone());
                Ok(self.arithmetic.product(&a, &b)?)
            }
            Node::Power(a, n) => {
                let base = self.done[&a].clone();
                self.power(&base, n)
            }
            Node::Quotient(a, b) => {
                let numerator = (*self.done[&a].clone()).clone();
                self.divide(numerator, b)
            }
            Node::Symbol(_)
            | Node::Cos(_)
            | Node::Sin(_)
            | Node::Root(_)
            | Node::Elementary(..)
            | Node::Function(..) => Err(Failure::Hypotheses(format!("`{each}` is not among the generators"))),
        }
    }

    fn power(&mut self, base: &Fraction<C, W>, exponent: u32) -> Result<Fraction<C, W>, Failure> {
        if self.arithmetic.rules.is_empty() {
            let numerator = base.numerator.power(exponent, &self.arithmetic.budget)?;
            let powers = base.powers.iter().map(|&(factor, e)| (factor, e * exponent)).collect();
            return Ok(Fraction { numerator, constant: base.constant.power(exponent)?, powers });
        }
        Ok((1..exponent).try_fold(base.clone(), |product, _| self.arithmetic.product(&product, base))?)
    }

    /// Divides by the factors of a denominator one after another, in the given factorisation.
    fn divide(&mut self, numerator: Fraction<C, W>, denominator: Sym) -> Result<Fraction<C, W>, Failure> {
        let mut quotient = numerator;
        let mut open = vec![(denominator, 1)];
        while let Some((next, exponent)) = open.pop() {
            match next.node() {
                Node::Product(a, b) if !self.generators.index.contains_key(&next) => {
                    open.extend([(b, exponent), (a, exponent)]);
                }
                Node::Power(a, n) => open.push((a, exponent * n)),
                _ => {
                    let divisor = self.done[&next].clone();
                    if divisor.numerator.is_zero() {
                        return Err(Failure::Undefined(next));
                    }
                    for _ in 0..exponent {
                        quotient = self.arithmetic.quotient(&quotient, &divisor)?;
                    }
                }
            }
        }
        Ok(quotient)
    }

    /// Returns the factors of all denominators that occurred so far, as expressions.
    pub fn requirements(&self) -> Vec<Sym> {
        self.arithmetic.factors.iter().map(|factor| expression_of(factor, &self.generators.leaves)).collect()
    }
}

/// Returns the sums, differences and negations that occur exactly once, as a term of another one.
fn inner_sums(order: &[Sym], root: Sym, generators: &Generators) -> FxHashMap<Sym, ()> {
    let additive = |node: Node| matches!(node, Node::Sum(..) | Node::Difference(..) | Node::Negation(_));
    let mut uses: FxHashMap<Sym, (u32, bool)> = FxHashMap::default();
    uses.reserve(order.len());
    for &each in order.iter().filter(|each| !generators.index.contains_key(each)) {
        let node = each.node();
        if node.is_leaf() {
            continue;
        }
        for child in node.children() {
            let entry = uses.entry(child).or_insert((0, true));
            *entry = (entry.0 + 1, entry.1 && additive(node));
        }
    }
    let inner = |each: &&Sym| **each != root && additive(each.node()) && uses.get(each) == Some(&(1, true));
    order.iter().filter(inner).map(|&each| (each, ())).collect()
}

fn constant<C: Coefficient, const W: usize>(each: Sym) -> Result<Fraction<C, W>, Failure> {
    let big = each.as_constant().and_then(Rational::to_big).ok_or(Failure::Undefined(each))?;
    let (numerator, denominator) = big.into_parts();
    Ok(Fraction {
        numerator: Poly::constant(C::from_big(&numerator)?),
        constant: C::from_big(&IBig::from(denominator))?,
        powers: Vec::new(),
    })
}

/// Converts an integer to an expression.
pub(super) fn integer(value: IBig) -> Sym {
    Sym::constant(Rational::from(RBig::from_parts(value, UBig::ONE)))
}

/// Converts a polynomial to an expression, with terms in descending powers of the generators.
pub(super) fn expression_of<C: Coefficient, const W: usize>(poly: &Poly<C, W>, leaves: &[Sym]) -> Sym {
    poly.terms().iter().fold(integer(IBig::ZERO), |sum, (m, c)| {
        let (negative, size) = if c.is_negative() { (true, c.negated()) } else { (false, c.clone()) };
        let powers = monomial::support(m).map(|(generator, exponent)| leaves[generator].powi(exponent as i32));
        // the coefficient is one factor, by which multiples of angles are recognised
        let product = integer(size.to_big()) * powers.fold(Sym::one(), |product, power| product * power);
        if negative { sum - product } else { sum + product }
    })
}
