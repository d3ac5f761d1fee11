//! Integrability of constraints of speeds (Frobenius' theorem).
//!
//! Constraints J u = 0 admit the directions X with J X = 0. They are integrable, that is rates of constraints of positions, exactly if the Lie brackets of
//! these directions are admissible too: for each row w of J
//!
//!   dw(X, Y) = sum (dw_b/dq_a - dw_a/dq_b) X_a Y_b = 0
//!
//! for all admissible X and Y. Each of these expressions is tested at random points of prime fields. A nonzero value proves that the expression is not
//! zero; the probability that a nonzero expression passes the test is below 2^-100.

use super::{Characteristics, Equation, Level, vanishes};
use crate::Trace;
use std::fmt;
use symbolic::{Identity, Sym, identified};

/// Whether constraints of speeds are rates of constraints of positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrability {
    Integrable,
    /// The constraints are nonholonomic: some Lie bracket of admissible directions is not admissible.
    NotIntegrable,
    /// The integrability was not decided.
    Open(Undecided),
}

/// The reason why integrability was not decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undecided {
    /// A constraint is nonlinear in the speeds.
    Nonlinear,
    /// A constraint depends on the time.
    Time,
    /// A constraint has a term without speeds.
    Affine,
    /// The system has a free frame.
    FreeFrame,
    /// An expression contains functions that have no values in prime fields.
    Functions,
}

impl fmt::Display for Undecided {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Nonlinear => "a constraint is nonlinear in the speeds",
            Self::Time => "a constraint holds the time",
            Self::Affine => "a constraint is affine, and not homogeneous, in the speeds",
            Self::FreeFrame => "a frame turns freely",
            Self::Functions => "no prime field has values of its functions",
        })
    }
}

impl Integrability {
    /// Decides whether the constraints of speeds are integrable on all level sets of the constraints of positions.
    pub fn of(trace: &Trace<'_>, constraints: &[Equation]) -> Self {
        if let Some(why) = undecided(trace, constraints) {
            return Integrability::Open(why);
        }
        let characteristics = Characteristics::of(trace, constraints);
        let directions = characteristics.directions(trace.speeds.len());
        let of_speeds = constraints.iter().filter(|constraint| constraint.level == Level::Speed);
        for constraint in of_speeds {
            let slopes: Vec<Vec<Sym>> = (0..trace.speeds.len())
                .map(|a| constraint.row.iter().map(|&entry| trace.by_coordinate(entry, a)).collect())
                .collect();
            for (place, first) in directions.iter().enumerate() {
                for second in &directions[place + 1..] {
                    match identified(&[turned(&slopes, first, second)]) {
                        Identity::Identified { .. } => {}
                        Identity::NotZero => return Integrability::NotIntegrable,
                        Identity::Untested(_) => return Integrability::Open(Undecided::Functions),
                    }
                }
            }
        }
        Integrability::Integrable
    }
}

/// Returns the first reason why Frobenius' conditions do not apply.
fn undecided(trace: &Trace<'_>, constraints: &[Equation]) -> Option<Undecided> {
    let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let of = |constraint: &Equation| {
        let slopes: Vec<Sym> = constraint.row.iter().flat_map(|slope| slope.symbols_of()).collect();
        if slopes.iter().any(|symbol| trace.speeds.contains(symbol)) {
            Some(Undecided::Nonlinear)
        } else if slopes.contains(&trace.time) || constraint.zero.symbols_of().contains(&trace.time) {
            Some(Undecided::Time)
        } else {
            (!vanishes(constraint.rate.substitute(&at_rest))).then_some(Undecided::Affine)
        }
    };
    constraints.iter().find_map(of).or((!trace.model.free.is_empty()).then_some(Undecided::FreeFrame))
}

/// Returns dw(X, Y); `slopes[a][b]` is dw_b/dq_a.
fn turned(slopes: &[Vec<Sym>], x: &[Sym], y: &[Sym]) -> Sym {
    let mut sum = Sym::ZERO;
    for (a, row) in slopes.iter().enumerate() {
        for (b, &slope) in row.iter().enumerate() {
            sum += slope * (x[a] * y[b] - y[a] * x[b]);
        }
    }
    sum
}
