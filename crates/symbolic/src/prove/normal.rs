//! The normal form of an expression.

use super::convert::{Converter, expression_of, integer};
use super::failure::Failure;
use super::generators::Generators;
use super::hypotheses::Hypotheses;
use super::kernel::{Computation, compute};
use super::lowest::{LowestTerms, lowest_terms};
use crate::Sym;
use algebra::multivariate::{Coefficient, Limit, Poly};
use dashu_ratio::RBig;
use field::Rational;
use num_traits::Zero;
use std::fmt;

/// An expression as a quotient of polynomials in lowest terms. Terms are sorted by descending powers of the generators, which are
/// sorted by name in natural order. The leading coefficient of the denominator is positive.
///
/// The normal form is zero exactly if the expression vanishes, and equal expressions have equal normal forms. The exception is a
/// denominator with so many angles and roots that its rationalisation exceeds a limit: it is left unchanged, and equal expressions may then differ.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalForm {
    /// The positive rational common factor of the coefficients.
    content: Rational,
    primitive: Sym,
    numerator: Sym,
    denominator: Sym,
    requires: Vec<Sym>,
}

/// The reason why an expression has no normal form.
#[derive(Clone, Debug, PartialEq)]
pub enum NotNormal {
    /// This denominator vanishes identically.
    Undefined(Sym),
    /// The hypotheses were rejected or a limit was exceeded; the text gives the reason.
    GaveUp(String),
}

impl fmt::Display for NotNormal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotNormal::Undefined(denominator) => write!(f, "undefined: the denominator {denominator} vanishes"),
            NotNormal::GaveUp(reason) => write!(f, "gave up: {reason}"),
        }
    }
}

impl std::error::Error for NotNormal {}

/// Computes the normal form under the hypotheses.
///
/// # Errors
/// [`NotNormal`] if the expression is undefined, the hypotheses are rejected, or a limit was exceeded.
pub fn normal(expression: Sym, hypotheses: &Hypotheses) -> Result<NormalForm, NotNormal> {
    normal_form(expression, hypotheses).map_err(|failure| match failure {
        Failure::Undefined(denominator) => NotNormal::Undefined(denominator),
        failure => NotNormal::GaveUp(failure.to_string()),
    })
}

pub(super) fn normal_form(expression: Sym, hypotheses: &Hypotheses) -> Result<NormalForm, Failure> {
    let expression = if hypotheses.given.is_empty() { expression } else { expression.substitute(&hypotheses.given) };
    let generators = Generators::of(&[expression], hypotheses)?;
    compute(&Normalising { expression, generators: &generators }, generators.leaves.len())
}

impl NormalForm {
    /// Returns whether the expression vanishes.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Returns the expanded numerator, with integer coefficients.
    pub fn numerator(&self) -> Sym {
        self.numerator
    }

    /// Returns the denominator: an integer, times the generators that divide the denominator, times the expanded rest.
    pub fn denominator(&self) -> Sym {
        let (_, below) = parts(self.content);
        below * self.denominator
    }

    /// Returns all denominators of the expression, including those that cancelled. The normal form is valid where none of them vanishes.
    pub fn requires(&self) -> &[Sym] {
        &self.requires
    }

    /// Returns the normal form as an expression.
    pub fn to_sym(&self) -> Sym {
        self.numerator / self.denominator()
    }

    /// Returns the value if the expression is constant.
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

/// Splits a rational number into numerator and denominator.
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
        let LowestTerms { numerator, constant, denominator } = lowest_terms(fraction, &mut converter.arithmetic)?;
        let leaves = &self.generators.leaves;
        let above = match numerator.content() {
            zero if zero.is_zero() => C::of(1),
            negative if negative.is_negative() => negative.negated(),
            positive => positive,
        };
        let primitive = numerator.over_constant(&above).ok_or(Limit::Overflow)?;
        let common = denominator.common_monomial();
        let rest = denominator.over_monomial(&common).ok_or(Limit::Degree)?;
        Ok(NormalForm {
            content: Rational::from(RBig::from_parts_signed(above.to_big(), constant.to_big())),
            primitive: expression_of(&primitive, leaves),
            numerator: expression_of(&numerator, leaves),
            denominator: expression_of(&Poly::term(common, C::of(1)), leaves) * expression_of(&rest, leaves),
            requires,
        })
    }
}
