//! Check of passivity: forces that depend on speeds dissipate energy. The check is exact for quadratic forms.

use super::states::{Expressions, States};
use crate::letters::Letters;
use crate::row_units::unit_of;
use claims::finding::PropertyVerdict;
use field::Rational;
use model::{Model, Trace, forces_without_potential};
use num_traits::Zero;
use symbolic::{Hypotheses, Sym, apart, decide, substitute_all};

/// The number of states at which the power is evaluated.
const STATES: usize = 2_000;

/// A power below this part of the sum of its absolute terms is a rounding error.
const ROUNDING: f64 = 1e-11;

/// Relative distances of sampled positions from the start: near it, then anywhere.
const NEAR: f64 = 0.05;
const ANYWHERE: f64 = 1.0;

/// The verdict: exact if the power is a quadratic form of the speeds with constant coefficients, otherwise by sampled states.
pub(super) fn verdict(model: &Model) -> PropertyVerdict {
    if model.parameters.iter().any(|parameter| parameter.value.is_none()) {
        return PropertyVerdict::DoesNotApply("some parameters have no value".to_owned());
    }
    apart(|| {
        let trace = Trace::of(model);
        let mut forces = forces_without_potential(&trace);
        // the equation of a reaction's impulse is an algebraic law, not a force
        model.impulses.iter().for_each(|&impulse| forces[impulse] = Sym::ZERO);
        let held: Vec<Sym> = forces.iter().flat_map(|force| force.symbols_of()).collect();
        let chooses = trace.switches.iter().any(|switch| held.contains(switch));
        if !chooses && !trace.speeds.iter().any(|speed| held.contains(speed)) {
            let rubs = model.contacts.iter().any(|contact| contact.friction.is_some());
            let beside = if rubs { ", apart from friction in contacts" } else { "" };
            return PropertyVerdict::Proved(format!("no force depends on speeds{beside}"));
        }
        match (!chooses).then(|| quadratic(&trace, &forces)).flatten().map(is_never_positive) {
            Some(true) => PropertyVerdict::Proved(
                "the forces that depend on speeds dissipate energy, for all positions and speeds with these data"
                    .to_owned(),
            ),
            _ => sampled(&trace, &forces),
        }
    })
}

/// The matrix of second derivatives of the power sum (Q(q, u) - Q(q, 0)) u with respect to the speeds; `None` if the power is not a quadratic form
/// with constant coefficients.
fn quadratic(trace: &Trace<'_>, forces: &[Sym]) -> Option<Vec<Vec<Rational>>> {
    let state: Vec<Sym> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
    let at_rest: Vec<(Sym, Sym)> = trace.speeds.iter().map(|&speed| (speed, Sym::ZERO)).collect();
    let still = substitute_all(forces, &at_rest);
    let terms = forces.iter().zip(still).zip(&trace.speeds);
    let power = terms.fold(Sym::ZERO, |sum, ((&force, still), &speed)| sum + (force - still) * speed);
    let power = Letters::with_data(trace.time, &state).put_into(trace, &[power])[0];
    let form: Vec<Vec<Sym>> = trace
        .speeds
        .iter()
        .map(|&one| trace.speeds.iter().map(|&other| power.diff(one).diff(other)).collect())
        .collect();
    let constant = |entry: &Sym| {
        let decided = decide(*entry, &Hypotheses::none());
        entry.as_constant().or_else(|| decided.is_zero().then(Rational::zero))
    };
    let numbers = form.iter().map(|row| row.iter().map(constant).collect()).collect::<Option<Vec<Vec<Rational>>>>()?;
    let again = (0..form.len()).fold(Sym::ZERO, |sum, i| {
        (0..form.len()).fold(sum, |sum, j| sum + Sym::constant(numbers[i][j]) * trace.speeds[i] * trace.speeds[j])
    });
    let rest = power + power - again;
    decide(rest, &Hypotheses::none()).is_zero().then_some(numbers)
}

/// True if a quadratic form is negative semidefinite, by exact pivots.
fn is_never_positive(mut form: Vec<Vec<Rational>>) -> bool {
    let sign = |number: Rational| number.sign().unwrap_or(1);
    let mut open: Vec<usize> = (0..form.len()).collect();
    while let Some(&pivot) = open.iter().find(|&&place| sign(form[place][place]) != 0) {
        if sign(form[pivot][pivot]) > 0 {
            return false;
        }
        open.retain(|&place| place != pivot);
        let own = form[pivot].clone();
        for &row in &open {
            let factor = form[row][pivot] / own[pivot];
            for &column in &open {
                let less = factor * own[column];
                form[row][column] -= less;
            }
        }
    }
    // a semidefinite matrix with a zero diagonal is zero
    open.iter().all(|&row| open.iter().all(|&column| sign(form[row][column]) == 0))
}

/// The verdict by sampling: searches for a state at which the forces that depend on speeds have positive power.
fn sampled(trace: &Trace<'_>, forces: &[Sym]) -> PropertyVerdict {
    let model = trace.model;
    let Some(expressions) = Expressions::of(trace, forces) else {
        return PropertyVerdict::Undecided("the power has no values".to_owned());
    };
    let mut states = States::about_start(trace);
    let mut seen = 0;
    for part in [NEAR, ANYWHERE] {
        for _ in 0..STATES / 2 {
            let (time, state) = states.next(part);
            let (positions, speeds) = state.split_at(model.positions());
            let still = expressions.at(time, &[positions, &vec![0.0; speeds.len()]].concat());
            let moving = expressions.at(time, &state);
            let each = || moving.iter().zip(&still).zip(speeds);
            let power: f64 = each().map(|((moving, still), speed)| (moving - still) * speed).sum();
            let sizes: f64 = each().map(|((moving, still), speed)| ((moving.abs() + still.abs()) * speed).abs()).sum();
            if !power.is_finite() {
                continue;
            }
            seen += 1;
            if power > ROUNDING * sizes && power > 0.0 {
                let found = gives(model, &state, power);
                return match part == NEAR {
                    true => PropertyVerdict::Fails(format!(
                        "the forces that depend on speeds supply {found}: a wrong sign, or a motor whose field or supply they stand for"
                    )),
                    false => PropertyVerdict::Tested(format!(
                        "near the start the forces that depend on speeds dissipate energy; away from it they supply {found}"
                    )),
                };
            }
        }
    }
    match seen {
        0 => PropertyVerdict::Undecided("the power has a value at no state that was tried".to_owned()),
        _ => PropertyVerdict::Tested(format!("at {seen} states the forces that depend on speeds dissipate energy")),
    }
}

/// The largest number of state components in a message.
const MOST_SHOWN: usize = 6;

/// A text with the power, W, and the state at which it occurs.
fn gives(model: &Model, state: &[f64], power: f64) -> String {
    let names = model.state_names().into_iter().map(|(name, _)| name).zip(state);
    // the speeds first: positions explain them
    let (places, speeds): (Vec<_>, Vec<_>) = names.enumerate().partition(|(place, _)| *place < model.positions());
    let shown = speeds.into_iter().chain(places).take(MOST_SHOWN);
    let shown = shown.map(|(_, (name, value))| match unit_of(model, &name).as_str() {
        "1" => format!("{name} = {}", short(*value)),
        unit => format!("{name} = {} {unit}", short(*value)),
    });
    format!("{} W at {}", short(power), shown.collect::<Vec<_>>().join(", "))
}

/// A number rounded to four significant digits.
fn short(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
