//! Laws with a length of a velocity, as the drag -c |v| v: differentiable at rest, although |v| is not.
//!
//! Where the terms with |v| fall faster than the speeds when all of these become smaller, they leave the linear equations at rest. This is
//! tested by numbers, at many states with smaller and smaller speeds.

use crate::letters::Letters;
use crate::spread_values::spread;
use model::equations::{Residuals, constraints_of};
use model::{Model, Trace};
use std::borrow::Cow;
use symbolic::{Sym, Tape};

/// States at which speeds become smaller.
const STATES: u32 = 12;

/// States at which the terms must have values.
const LEAST: usize = 4;

/// The part by which speeds become smaller, twice.
const SMALLER: f64 = 1.0 / 64.0;

/// Terms of first order become smaller by the part above, those of second order by its square.
const FASTER: f64 = 1.0 / 512.0;

/// Differences below this part of the terms are rounding.
const ROUNDING: f64 = 1e-13;

/// The model that has the linear equations of a model about a state without the terms that have none at rest; the model itself where the
/// state moves, or where no such term falls faster than the speeds.
pub fn law_at_rest<'a>(model: &'a Model, state: &[f64]) -> Cow<'a, Model> {
    let rests = state.iter().skip(model.positions()).all(|speed| *speed == 0.0);
    let without = if rests { model.without_lengths_at_rest() } else { None };
    match without.filter(|without| symbolic::apart(|| keeps_derivatives(model, without)) == Some(true)) {
        Some(without) => Cow::Owned(without),
        None => Cow::Borrowed(model),
    }
}

/// Everything of a model that has derivatives, and its speeds and other letters.
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

/// Whether all differences of two models fall faster than the speeds; none where these models have no equations.
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
