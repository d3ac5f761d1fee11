//! The normal form of an expression.

use super::convert::{Converter, expression_of, integer};
use super::fraction::{Arithmetic, Fraction};
use super::generators::Generators;
use super::hypotheses::Hypotheses;
use super::kernel::{Computation, compute};
use crate::Sym;
use crate::poly::{Coefficient, Failure, Poly};
use dashu_ratio::RBig;
use field::Rational;
use num_traits::Zero;
use std::fmt;

/// An expression as one fraction of polynomials in lowest terms: terms by falling powers of the generators, which are
/// in natural order of their names, over a denominator whose first coefficient is positive.
///
/// Equal rational functions have the same normal form. With circle points or roots in a denominator that is no longer
/// so, while a normal form is zero exactly where the expression is.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalForm {
    /// What the coefficients above and below have in common, positive.
    content: Rational,
    primitive: Sym,
    numerator: Sym,
    denominator: Sym,
    factors: Vec<(Sym, u32)>,
    requires: Vec<Sym>,
}

/// The normal form under the hypotheses.
///
/// # Errors
/// The reason where the expression is undefined, the hypotheses are refused, or a limit was reached.
pub fn normal(expression: Sym, hypotheses: &Hypotheses) -> Result<NormalForm, String> {
    normal_form(expression, hypotheses).map_err(|failure| failure.to_string())
}

pub(super) fn normal_form(expression: Sym, hypotheses: &Hypotheses) -> Result<NormalForm, Failure> {
    let expression = if hypotheses.given.is_empty() { expression } else { expression.substitute(&hypotheses.given) };
    let generators = Generators::of(&[expression], hypotheses)?;
    compute(&Normalising { expression, generators: &generators }, generators.leaves.len())
}

impl NormalForm {
    /// Whether the expression vanishes.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// The numerator, written out, with integer coefficients.
    pub fn numerator(&self) -> Sym {
        self.numerator
    }

    /// The denominator: an integer times the generators that divide it times the rest, written out.
    pub fn denominator(&self) -> Sym {
        let (_, below) = parts(self.content);
        below * self.denominator
    }

    /// The factors of the denominator that are known, with their exponents; constants left out.
    pub fn factors(&self) -> &[(Sym, u32)] {
        &self.factors
    }

    /// The denominators met in the expression, none of which may vanish, also where they cancelled in the end.
    pub fn requires(&self) -> &[Sym] {
        &self.requires
    }

    /// The normal form as an expression.
    pub fn to_sym(&self) -> Sym {
        self.numerator / self.denominator()
    }

    /// The value of a constant.
    pub fn as_constant(&self) -> Option<Rational> {
        self.to_sym().as_constant()
    }

    pub(super) fn content(&self) -> Rational {
        self.content
    }

    pub(super) fn primitive_numerator(&self) -> Sym {
        self.primitive
    }

    pub(super) fn primitive_denominator(&self) -> Sym {
        self.denominator
    }
}

impl fmt::Display for NormalForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.to_sym())
    }
}

/// Numerator and denominator of a number.
fn parts(value: Rational) -> (Sym, Sym) {
    let (above, below) = value.to_big().unwrap_or_default().into_parts();
    (integer(above), integer(below.into()))
}

struct Normalising<'a> {
    expression: Sym,
    generators: &'a Generators,
}

impl Computation for Normalising<'_> {
    type Output = NormalForm;

    fn run<C: Coefficient, const W: usize>(&self) -> Result<NormalForm, Failure> {
        let mut converter = Converter::<C, W>::new(self.generators)?;
        let fraction = (*converter.fraction(self.expression)?).clone();
        let requires = converter.requirements();
        let lowest = lowest_terms(fraction, &mut converter.arithmetic)?;
        let leaves = &self.generators.leaves;
        let mut below = lowest.numerator.content();
        if below.is_negative() {
            below = below.negated();
        }
        if below.is_zero() {
            below = C::of(1);
        }
        let primitive = lowest.numerator.over_constant(&below).ok_or(Failure::Overflow)?;
        let content = Rational::from(RBig::from_parts_signed(below.to_big(), lowest.constant.to_big()));
        let factors: Vec<(Sym, u32)> =
            lowest.factors.iter().map(|(factor, exponent)| (expression_of(factor, leaves), *exponent)).collect();
        Ok(NormalForm {
            content,
            primitive: expression_of(&primitive, leaves),
            numerator: expression_of(&lowest.numerator, leaves),
            denominator: denominator(&lowest.factors, leaves, &converter.arithmetic)?,
            factors,
            requires,
        })
    }
}

/// numerator / (constant * product of factors^exponents) with nothing in common.
struct LowestTerms<C, const W: usize> {
    numerator: Poly<C, W>,
    constant: C,
    factors: Vec<(Poly<C, W>, u32)>,
}

fn lowest_terms<C: Coefficient, const W: usize>(
    fraction: Fraction<C, W>,
    arithmetic: &mut Arithmetic<C, W>,
) -> Result<LowestTerms<C, W>, Failure> {
    let Fraction { mut numerator, constant, powers } = fraction.without_content();
    let budget = &arithmetic.budget;
    let mut factors: Vec<(Poly<C, W>, u32)> = Vec::new();
    for (number, exponent) in powers {
        for copy in 0..exponent {
            let mut rest = arithmetic.factors[number].clone();
            loop {
                let common = numerator.common_divisor(&rest, budget)?;
                if common.is_one() {
                    break;
                }
                numerator = numerator.exact_quotient(&common, budget)?.ok_or(Failure::Overflow)?;
                rest = rest.exact_quotient(&common, budget)?.ok_or(Failure::Overflow)?;
            }
            // A copy that keeps all of itself speaks for the copies after it.
            let whole = rest == arithmetic.factors[number];
            count(&mut factors, rest, if whole { exponent - copy } else { 1 });
            if whole {
                break;
            }
        }
    }
    factors.sort_by(|a, b| {
        a.0.terms().len().cmp(&b.0.terms().len()).then_with(|| b.0.terms()[0].0.cmp(&a.0.terms()[0].0))
    });
    Ok(LowestTerms { numerator, constant, factors })
}

fn count<C: Coefficient, const W: usize>(factors: &mut Vec<(Poly<C, W>, u32)>, factor: Poly<C, W>, times: u32) {
    match factors.iter_mut().find(|(known, _)| *known == factor) {
        Some((_, exponent)) => *exponent += times,
        None if factor.is_one() => {}
        None => factors.push((factor, times)),
    }
}

/// Generators first, then everything else multiplied out: how the denominator was found does not show.
fn denominator<C: Coefficient, const W: usize>(
    factors: &[(Poly<C, W>, u32)],
    leaves: &[Sym],
    arithmetic: &Arithmetic<C, W>,
) -> Result<Sym, Failure> {
    let mut product = Poly::one();
    for (factor, exponent) in factors {
        product = product.times(&factor.power(*exponent, &arithmetic.budget)?, &arithmetic.budget)?;
    }
    let common = product.common_monomial();
    let rest = product.over_monomial(&common).ok_or(Failure::Degree)?;
    let front = expression_of(&Poly::term(common, C::of(1)), leaves);
    Ok(front * expression_of(&rest, leaves))
}
