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

/// An expression as one fraction of polynomials in lowest terms: terms by falling powers of the generators, which are
/// in natural order of their names, over a denominator whose first coefficient is positive.
///
/// It is zero exactly where the expression vanishes, and equal expressions have the same normal form; only a
/// denominator with so many angles and roots that their conjugates outgrow a limit is left as it came.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalForm {
    /// The common rational factor of the coefficients above and below, positive.
    content: Rational,
    primitive: Sym,
    numerator: Sym,
    denominator: Sym,
    requires: Vec<Sym>,
}

/// Why there is no normal form.
#[derive(Clone, Debug, PartialEq)]
pub enum NotNormal {
    /// This denominator vanishes identically.
    Undefined(Sym),
    /// The hypotheses are refused or a limit was reached.
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

/// The normal form under the hypotheses.
///
/// # Errors
/// [`NotNormal`] where the expression is undefined, the hypotheses are refused, or a limit was reached.
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
