//! Laws with the norm |v| of a velocity, such as the drag -c |v| v: the law is differentiable at rest, although |v| is not.
//!
//! Terms with |v| that vanish faster than the speeds do not contribute to the linear equations at rest. This is tested numerically, at
//! several states with decreasing speeds.

use crate::letters::Letters;
use crate::spread_values::spread;
use model::equations::{Residuals, constraints_of};
use model::{Model, Trace};
use std::borrow::Cow;
use symbolic::{Sym, Tape};

/// The number of test states.
const STATES: u32 = 12;

/// The least number of test states at which the terms must have values.
const LEAST: usize = 4;

/// The factor by which speeds are decreased, twice.
const SMALLER: f64 = 1.0 / 64.0;

/// The factor below which a term is of higher than first order: [`SMALLER`] would be first order, its square second order.
const FASTER: f64 = 1.0 / 512.0;

/// Differences below this part of the terms are rounding errors.
const ROUNDING: f64 = 1e-13;

/// The model without terms that contain |v|, if the state is at rest and these terms are of higher order there; otherwise the model
/// itself.
pub fn law_at_rest<'a>(model: &'a Model, state: &[f64]) -> Cow<'a, Model> {
    let rests = state.iter().skip(model.positions()).all(|speed| *speed == 0.0);
    let without = if rests { model.without_lengths_at_rest() } else { None };
    match without.filter(|without| symbolic::apart(|| keeps_derivatives(model, without)) == Some(true)) {
        Some(without) => Cow::Owned(without),
        None => Cow::Borrowed(model),
    }
}

/// All expressions that a linearisation differentiates, and the symbols of the speeds; `None` without equations.
fn expressions(model: &Model) -> Option<(Vec<Sym>, Vec<Sym>)> {
    let trace = Trace::of(model);
    let state = [&trace.coordinates[..], &trace.speeds].concat();
    let constraints = constraints_of(&trace);
    let rows = Residuals::of(&trace).into_iter().next()?.residuals;
    let shown = model.outputs.iter().map(|output| trace.scalar(output.is));
    let given = model.inputs.iter().filter_map(|input| input.value).map(|value| trace.scalar(value));
    let conditions = model.switches.iter().map(|&condition| trace.scalar(condition));
    let all: Vec<Sym> = rows
        .into_iter()
        .chain(constraints.iter().map(|one| one.zero))
        .chain(shown)
        .chain(given)
        .chain(conditions)
        .collect();
    Some((Letters::with_decimals(trace.time, &state).put_into(&trace, &all), trace.speeds.clone()))
}

/// Some(true) if all differences of two models vanish faster than the speeds at enough test states; `None` if an expression has no value.
fn keeps_derivatives(model: &Model, without: &Model) -> Option<bool> {
    let (whole, speeds) = expressions(model)?;
    let (rest, _) = expressions(without)?;
    let differences: Vec<Sym> = whole.iter().zip(&rest).map(|(whole, rest)| *whole - *rest).collect();
    let mut letters: Vec<Sym> = speeds.clone();
    for own in differences.iter().flat_map(|own| own.symbols_of()) {
        if !letters.contains(&own) {
            letters.push(own);
        }
    }
    let tape = Tape::record(&letters, &differences).ok()?;
    let mut program = tape.over::<f64>();
    let mut valued = 0;
    for state in 1..=STATES {
        let mut at = |factor: f64| {
            let value = |(place, letter): (usize, &Sym)| {
                let own = spread(&letter.to_string(), state);
                if place < speeds.len() { factor * own } else { own }
            };
            let inputs: Vec<f64> = letters.iter().enumerate().map(value).collect();
            let mut values = vec![f64::NAN; differences.len()];
            program.evaluate(&inputs, &mut values);
            values
        };
        let [first, second, third] = [1.0, SMALLER, SMALLER * SMALLER].map(&mut at);
        if ![&first, &second, &third].into_iter().flatten().all(|value| value.is_finite()) {
            continue;
        }
        let falls = |k: usize| third[k].abs() <= FASTER * second[k].abs() + ROUNDING * first[k].abs();
        if !(0..differences.len()).all(falls) {
            return Some(false);
        }
        valued += 1;
    }
    Some(valued >= LEAST)
}
