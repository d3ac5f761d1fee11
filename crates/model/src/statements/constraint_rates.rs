//! The equations J u' + c = 0 keep the constraints: their left side is the second rate of a constraint of positions and the first of one
//! of speeds, found a second time by partial derivatives alone.

use super::Statement;
use crate::Trace;
use crate::agreement::{decided, is_zero};
use crate::equations::{Equation, Level, constraints_of};
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
    // lambda J u where the constraint holds: the power of the reaction
    let power = constraint.row.iter().zip(&trace.speeds).fold(Sym::ZERO, |sum, (&slope, &speed)| sum + slope * speed);
    let work = if is_zero(power - constraint.rate) { "its reaction does no work" } else { "its reaction does work" };
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
