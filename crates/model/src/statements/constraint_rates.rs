//! Statements on constraints: the equations J u' + c = 0 preserve them. The left side is the second time derivative of a constraint of positions, and the first of one
//! of speeds, computed independently by partial derivatives, plus the gain terms of a stabilised constraint.

use super::reaction_power::{ReactionPower, multiplier};
use super::{Statement, piecewise, residual, while_inputs_rest};
use crate::Trace;
use crate::agreement::decided;
use crate::equations::{Equation, Level, constraints_of};
use field::Scalar as _;
use symbolic::Sym;

pub(super) fn statements(trace: &Trace<'_>) -> Vec<Statement> {
    // coordinates that are functions of time move bodies even at u = 0
    let relative = if trace.has_quadratic_kinetic_energy() { "" } else { CARRIED };
    let constraints = constraints_of(trace).into_iter().enumerate();
    constraints.map(|(place, constraint)| statement(trace, place, &constraint, relative)).collect()
}

/// A restriction in a sentence: the energy H contains velocities relative to those at u = 0.
const CARRIED: &str = " with velocities less the velocities at u = 0";

fn statement(trace: &Trace<'_>, place: usize, constraint: &Equation, relative: &str) -> Statement {
    let kept = constraint.row.iter().zip(&trace.accelerations);
    let kept = kept.fold(constraint.bias, |sum, (&slope, &acceleration)| sum + slope * acceleration);
    let (led, rates) = led(trace, constraint);
    let power = ReactionPower::of(trace, constraint);
    let mut pairs = vec![(kept, led), (power.along, power.idle + power.working)];
    if let Some(law) = &constraint.law {
        // the combination of the equations of motion is the law, and contains no other constraint
        let combined = |of: &dyn Fn(usize) -> Sym| {
            law.iter().fold(Sym::ZERO, |sum, &(speed, factor)| sum + Sym::int(factor) * of(speed))
        };
        let inertia = residual(trace);
        pairs.push((combined(&|speed| inertia[speed]), constraint.zero));
        let others = constraints_of(trace).into_iter().filter(|other| other.law.is_none());
        pairs.extend(others.map(|other| (combined(&|speed| other.row[speed]), Sym::ZERO)));
    }
    let subject = constraint.title(place);
    let agreement = decided(trace, &subject, &pairs);
    let written = || power.written(trace, place).unwrap_or_else(|| format!("{} J u", multiplier(trace, place)));
    let work = match power.is_zero() {
        true if constraint.law.is_some() => {
            "it is an equation of motion without accelerations; its multiplier is zero where such laws determine their coordinates"
                .to_owned()
        }
        true => "its reaction does no work".to_owned(),
        false => format!("the power of its reaction is {}", written()),
    };
    let says = format!("J u' + c is {rates}; {work}{relative}");
    let chooses = constraint.zero.symbols_of().iter().any(|symbol| trace.switches.contains(symbol));
    let says = if chooses { piecewise(trace, &says) } else { says };
    let says = while_inputs_rest(trace, &[constraint.zero], says);
    Statement { subject, says, agreement }
}

/// Returns the combination of a constraint's time derivatives that its equation sets to zero, and its name.
fn led(trace: &Trace<'_>, constraint: &Equation) -> (Sym, String) {
    let mut rates = vec![constraint.zero, total_rate(trace, constraint.zero)];
    if constraint.level == Level::Position {
        rates.push(total_rate(trace, rates[1]));
    }
    let highest = rates.len() - 1;
    let gains = constraint.gains.as_deref().unwrap_or_default();
    if gains.is_empty() {
        return (rates[highest], if highest == 2 { "its second rate" } else { "its rate" }.to_owned());
    }
    let names = ["f", "f'", "f''"];
    let (mut sum, mut name) = (rates[highest], names[highest].to_owned());
    for (number, (&gain, lower)) in gains.iter().zip((0..highest).rev()).enumerate() {
        sum += gain * rates[lower];
        name += &format!(" + g{} {}", number + 1, names[lower]);
    }
    (sum, name)
}

/// Returns df/dt by the chain rule, with one partial derivative for each coordinate, each speed and the time.
fn total_rate(trace: &Trace<'_>, expression: Sym) -> Sym {
    let by_coordinates = trace.coordinates.iter().zip(&trace.position_rates);
    let by_speeds = trace.speeds.iter().zip(&trace.accelerations);
    by_coordinates
        .chain(by_speeds)
        .fold(expression.diff(trace.time), |sum, (&symbol, &rate)| sum + expression.diff(symbol) * rate)
}
