//! The ways in which a normal form is not reached.

use crate::Sym;
use algebra::multivariate::Limit;
use std::fmt;

/// Why a computation with expressions ended without a result.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Failure {
    /// A limit of the polynomials.
    Polynomial(Limit),
    /// More generators than are provided for.
    Generators(usize),
    /// This denominator vanishes identically.
    Undefined(Sym),
    /// The hypotheses do not make a canonical set of rules.
    Hypotheses(String),
}

impl From<Limit> for Failure {
    fn from(limit: Limit) -> Self {
        Failure::Polynomial(limit)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Polynomial(limit) => write!(f, "{limit}"),
            Failure::Generators(count) => write!(f, "{count} generators are more than are provided for"),
            Failure::Undefined(denominator) => write!(f, "the denominator {denominator} vanishes identically"),
            Failure::Hypotheses(reason) => write!(f, "{reason}"),
        }
    }
}
