//! Integrability of constraints of speeds (Frobenius).
//!
//! Constraints J u = 0 leave the directions X with J X = 0. They are rates of constraints of positions exactly where no two of these
//! directions lead out of them: for each row w of J
//!
//!   dw(X, Y) = sum (dw_b/dq_a - dw_a/dq_b) X_a Y_b = 0
//!
//! for all X and Y among them. Each of these numbers is tested at random points of prime fields: one that is not zero there is not
//! zero, and one that is zero there is zero but for a probability below 2^-100.

use super::{Characteristics, Equation, Level, vanishes};
use crate::Trace;
use symbolic::{Identity, Sym, identified};

/// Whether constraints of speeds are rates of constraints of positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrability {
    Integrable,
    /// Directions that the constraints leave lead, one after the other, to every place near.
    NotIntegrable,
    /// Not decided: with the time, nonlinear in the speeds, affine, of frames that turn freely, or with functions whose values no
    /// prime field has.
    Open,
}

impl Integrability {
    /// Integrability of the constraints of speeds among these, where the constraints of positions keep any constant values.
    pub fn of(trace: &Trace<'_>, constraints: &[Equation]) -> Self {
        let moving = [trace.speeds.as_slice(), &[trace.time]].concat();
        let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
        let is_plain = |constraint: &Equation| {
            let slopes = constraint.row.iter().flat_map(|slope| slope.symbols_of());
            let linear = !slopes.into_iter().any(|symbol| moving.contains(&symbol));
            linear && vanishes(constraint.rate.substitute(&at_rest))
        };
        if !trace.model.free.is_empty() || !constraints.iter().all(is_plain) {
            return Integrability::Open;
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
                        Identity::Untested(_) => return Integrability::Open,
                    }
                }
            }
        }
        Integrability::Integrable
    }
}

/// dw(X, Y), with the slopes dw_b/dq_a.
fn turned(slopes: &[Vec<Sym>], x: &[Sym], y: &[Sym]) -> Sym {
    let mut sum = Sym::ZERO;
    for (a, row) in slopes.iter().enumerate() {
        for (b, &slope) in row.iter().enumerate() {
            sum += slope * (x[a] * y[b] - y[a] * x[b]);
        }
    }
    sum
}
