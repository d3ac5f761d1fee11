//! Deciding whether an expression vanishes.

use super::convert::Converter;
use super::failure::Failure;
use super::generators::Generators;
use super::hypotheses::Hypotheses;
use super::kernel::{Computation, compute};
use super::witness::{self, Witness};
use crate::Sym;
use algebra::multivariate::Coefficient;
use std::fmt;

/// Whether an expression vanishes wherever it is defined and the hypotheses hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Decision {
    /// The expression vanishes.
    Zero(Proof),
    /// The expression does not vanish, with a point that shows it.
    NonZero(Witness),
    /// This denominator vanishes identically.
    Undefined(Sym),
    /// The question was not decided, for this reason.
    GaveUp(String),
}

/// The assumptions of a proof that an expression vanishes.
#[derive(Clone, Debug, PartialEq)]
pub struct Proof {
    /// The denominators met on the way, none of which may vanish: factors, as far as they are known.
    pub requires: Vec<Sym>,
}

impl Decision {
    /// Whether the expression was proved to vanish.
    pub fn is_zero(&self) -> bool {
        matches!(self, Decision::Zero(_))
    }

    /// Whether a point was found where the expression does not vanish.
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
    /// Whether two expressions are equal under these hypotheses.
    pub fn equal(&self, a: Sym, b: Sym) -> Decision {
        decide(a - b, self)
    }
}

/// Decides whether the expression vanishes: by its normal form, and where this is not zero by a point.
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

/// Decides whether the expression equals the sum of cofactor * h over the given pairs, identically. If it does, it
/// vanishes wherever all h do.
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
