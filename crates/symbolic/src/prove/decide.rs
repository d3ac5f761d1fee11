//! Decision whether an expression vanishes.

use super::convert::Converter;
use super::failure::Failure;
use super::generators::Generators;
use super::hypotheses::Hypotheses;
use super::kernel::{Computation, compute};
use super::witness::{self, Witness};
use crate::Sym;
use algebra::multivariate::Coefficient;
use std::fmt;

/// The decision whether an expression vanishes wherever it is defined and the hypotheses hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Decision {
    /// The expression vanishes identically.
    Zero(Proof),
    /// The expression does not vanish at the given point, which satisfies the hypotheses.
    NonZero(Witness),
    /// This denominator vanishes identically under the hypotheses.
    Undefined(Sym),
    /// No decision was reached; the text gives the reason.
    GaveUp(String),
}

/// The assumptions under which an expression was proved to vanish.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// Factors of the denominators that occurred in the proof; none of them may vanish.
    pub requires: Vec<Sym>,
}

impl Decision {
    /// Returns whether the expression was proved to vanish.
    pub fn is_zero(&self) -> bool {
        matches!(self, Decision::Zero(_))
    }

    /// Returns whether a point was found at which the expression does not vanish.
    pub fn is_nonzero(&self) -> bool {
        matches!(self, Decision::NonZero(_))
    }
}

impl fmt::Display for Decision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Decision::Zero(_) => write!(f, "zero"),
            Decision::NonZero(witness) => write!(f, "not zero: {witness}"),
            Decision::Undefined(denominator) => write!(f, "undefined: the denominator {denominator} vanishes"),
            Decision::GaveUp(reason) => write!(f, "gave up: {reason}"),
        }
    }
}

impl Hypotheses {
    /// Decides whether two expressions are equal under these hypotheses.
    pub fn equal(&self, a: Sym, b: Sym) -> Decision {
        decide(a - b, self)
    }
}

/// Decides whether the expression vanishes: if its normal form is not zero, an exact point is searched at which the expression differs from zero.
pub fn decide(expression: Sym, hypotheses: &Hypotheses) -> Decision {
    match proof(expression, hypotheses) {
        Ok(Some(proof)) => Decision::Zero(proof),
        Ok(None) => match witness::search(expression, hypotheses) {
            Some(witness) => Decision::NonZero(witness),
            None => Decision::GaveUp("the normal form is not zero, but no exact point was found that shows it".into()),
        },
        Err(Failure::Undefined(denominator)) => Decision::Undefined(denominator),
        Err(failure) => Decision::GaveUp(failure.to_string()),
    }
}

/// Decides whether the expression equals the sum of cofactor * h over the given pairs (cofactor, h) identically. If so, it
/// vanishes wherever all h vanish.
pub fn decide_modulo(expression: Sym, combination: &[(Sym, Sym)], hypotheses: &Hypotheses) -> Decision {
    decide(combination.iter().fold(expression, |rest, &(cofactor, h)| rest - cofactor * h), hypotheses)
}

fn proof(expression: Sym, hypotheses: &Hypotheses) -> Result<Option<Proof>, Failure> {
    let expression = if hypotheses.given.is_empty() { expression } else { expression.substitute(&hypotheses.given) };
    let generators = Generators::of(&[expression], hypotheses)?;
    compute(&Vanishing { expression, generators: &generators }, generators.leaves.len())
}

struct Vanishing<'a> {
    expression: Sym,
    generators: &'a Generators,
}

impl Computation for Vanishing<'_> {
    type Output = Option<Proof>;

    fn run<C: Coefficient, const W: usize>(&self) -> Result<Option<Proof>, Failure> {
        let mut converter = Converter::<C, W>::new(self.generators)?;
        let fraction = converter.fraction(self.expression)?;
        Ok(fraction.numerator.is_zero().then(|| Proof { requires: converter.requirements() }))
    }
}
