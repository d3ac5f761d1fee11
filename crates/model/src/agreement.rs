//! Whether two principles give the same equations: residuals are compared as they stand, linear in the accelerations, never solved.

use crate::Trace;
use crate::principles::{NotApplicable, Principle};
use std::fmt;
use symbolic::{Decision, Hypotheses, Identity, Sym, decide, identified};

/// The degree to which two principles are known to agree.
#[derive(Clone, Debug, PartialEq)]
pub enum Agreement {
    /// The normal form of every difference is zero: for all values of all letters for which no divisor vanishes.
    Proved { divisors: Vec<String> },
    /// Every difference vanishes at random points of prime fields: but for an error of at most 2^`error`.
    Identified { points: usize, error: f64 },
    /// The difference in this equation is not zero, and here is a point.
    Refuted { equation: usize, point: String },
    /// Nothing is known, for this reason.
    Undecided { equation: usize, reason: String },
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Proved { divisors } if divisors.is_empty() => {
                write!(f, "proved by normal form: equal for all values of all letters")
            }
            Self::Proved { divisors } => {
                write!(
                    f,
                    "proved by normal form: equal for all values for which none of these vanishes: {}",
                    divisors.join("; ")
                )
            }
            Self::Identified { points, error } => write!(
                f,
                "identified: equal at {points} random points of random prime fields; the probability of error is below 2^{:.0}",
                error.ceil()
            ),
            Self::Refuted { equation, point } => {
                write!(f, "refuted in equation {}: the difference is {point}", equation + 1)
            }
            Self::Undecided { equation, reason } => write!(f, "undecided in equation {}: {reason}", equation + 1),
        }
    }
}

/// Expressions with more operations have normal forms that may explode: they are identified instead.
const MOST_EXPANDED: usize = 4_000;

/// Compares the residuals of two principles.
///
/// # Errors
/// Where one of them does not apply to the model.
pub fn agreement(trace: &Trace<'_>, one: Principle, other: Principle) -> Result<Agreement, NotApplicable> {
    let (one, other) = (one.residual(trace)?, other.residual(trace)?);
    let differences: Vec<Sym> = one.iter().zip(&other).map(|(&one, &other)| one - other).collect();
    let identity = identified(&differences);
    if let (Identity::Identified { points, error, .. }, true) =
        (&identity, Sym::operations_of(&differences) > MOST_EXPANDED)
    {
        return Ok(Agreement::Identified { points: *points, error: *error });
    }
    let mut divisors: Vec<String> = Vec::new();
    for (equation, difference) in differences.into_iter().enumerate() {
        match (decide(difference, &Hypotheses::none()), &identity) {
            (Decision::Zero(proof), _) => {
                for divisor in proof.requires.iter().map(Sym::to_string) {
                    if !divisors.contains(&divisor) {
                        divisors.push(divisor);
                    }
                }
            }
            (Decision::NonZero(witness), _) => {
                return Ok(Agreement::Refuted { equation, point: witness.to_string() });
            }
            (_, Identity::Identified { points, error, .. }) => {
                return Ok(Agreement::Identified { points: *points, error: *error });
            }
            (Decision::Undefined(divisor), _) => {
                let reason = format!("the divisor {divisor} vanishes everywhere");
                return Ok(Agreement::Undecided { equation, reason });
            }
            (Decision::GaveUp(reason), _) => return Ok(Agreement::Undecided { equation, reason }),
        }
    }
    Ok(Agreement::Proved { divisors })
}
