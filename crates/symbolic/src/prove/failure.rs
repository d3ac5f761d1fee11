//! Failures of the computation of a normal form.

use crate::Sym;
use algebra::multivariate::Limit;
use std::fmt;

/// The reason why a computation with expressions has no result.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Failure {
    /// A size limit of the polynomials was exceeded.
    Polynomial(Limit),
    /// There are more generators than the limit allows; the value is their number.
    Generators(usize),
    /// This denominator vanishes identically.
    Undefined(Sym),
    /// The rules of the hypotheses do not define a canonical normal form.
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
