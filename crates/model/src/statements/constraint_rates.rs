//! The equations J u' + c = 0 keep the constraints: their left side is the second rate of a constraint of positions and the first of one
//! of speeds, found a second time by partial derivatives alone.

use super::Statement;
use crate::Trace;
use crate::agreement::decided;
use crate::equations::{Equation, Level, constraints_of, vanishes};
use symbolic::Sym;

pub(super) fn statements(trace: &Trace<'_>) -> Vec<Statement> {
    constraints_of(trace).iter().enumerate().map(|(place, constraint)| statement(trace, place, constraint)).collect()
}

fn statement(trace: &Trace<'_>, place: usize, constraint: &Equation) -> Statement {
    let kept = constraint.row.iter().zip(&trace.accelerations);
    let kept = kept.fold(constraint.bias, |sum, (&slope, &acceleration)| sum + slope * acceleration);
    let second = match constraint.level {
        Level::Position => total_rate(trace, total_rate(trace, constraint.zero)),
        Level::Speed => total_rate(trace, constraint.zero),
    };
    let agreement = decided(&[(kept, second)]);
    let rates = if constraint.level == Level::Position { "its second rate" } else { "its rate" };
    // lambda J u is the power of the reaction: zero with f' = J u, and with a homogeneous f of second degree, where J u = 2 f
    let along = constraint.row.iter().zip(&trace.speeds).fold(Sym::ZERO, |sum, (&slope, &speed)| sum + slope * speed);
    let is_idle = vanishes(along - constraint.rate) || vanishes(along - constraint.rate - constraint.rate);
    let work = if is_idle { "its reaction does no work" } else { "its reaction may do work" };
    Statement { subject: constraint.title(place), says: format!("J u' + c is {rates}; {work}"), agreement }
}

/// df/dt by the chain rule over partial derivatives, one for each coordinate, speed and the time.
fn total_rate(trace: &Trace<'_>, expression: Sym) -> Sym {
    let by_coordinates = trace.coordinates.iter().zip(&trace.position_rates);
    let by_speeds = trace.speeds.iter().zip(&trace.accelerations);
    by_coordinates
        .chain(by_speeds)
        .fold(expression.diff(trace.time), |sum, (&symbol, &rate)| sum + expression.diff(symbol) * rate)
}
