//! Taylor series of the motion: accelerations and multipliers need one factorisation per step for all orders.

use super::{linear_equations, unknown_letters};
use crate::letters::{Inputs, Letters};
use model::{Model, Trace};
use series::Equations;
use simulation::Expandable;
use std::collections::BTreeSet;
use symbolic::linear::Solve;
use symbolic::{Sym, Untapeable, apart};

/// The series of a model with numbers for its parameters. `None` if an expression has no series, or if fewer than `least` unknowns have
/// variable coefficients; a symbolic elimination is then shorter.
pub(crate) fn recurrence(model: &Model, least: usize) -> Option<Expandable> {
    apart(|| {
        let inputs = Inputs::of(model);
        let (trace, letters) = (Trace::of(model), Letters::with_data(inputs.time, &inputs.state));
        let solve = linear_equations(&trace, letters);
        (moving(&solve) >= least).then(|| of_equations(&solve, &trace, &inputs, letters, (&[], None)).ok())?
    })
}

/// The series of a model with one more state at the end, with the given rate as an expression over the symbols of the trace.
pub(crate) fn recurrence_with(
    model: &Model,
    least: usize,
    rate: impl Fn(&Trace<'_>) -> Sym + Send + Sync,
) -> Option<Expandable> {
    apart(|| {
        let mut inputs = Inputs::of(model);
        let (own, grown) = (inputs.state.clone(), Sym::symbol("grown"));
        inputs.state.push(grown);
        let (trace, letters) = (Trace::of(model), Letters::with_data(inputs.time, &own));
        let rate = rate(&trace);
        let solve = linear_equations(&trace, letters);
        (moving(&solve) >= least).then(|| of_equations(&solve, &trace, &inputs, letters, (&[], Some(rate))).ok())?
    })
}

/// The number of unknowns with a variable coefficient.
fn moving(solve: &Solve) -> usize {
    let entries = solve.pattern.places().iter().zip(&solve.entries);
    let columns = entries.filter(|(_, entry)| !entry.symbols_of().is_empty()).map(|(&(_, column), _)| column);
    columns.collect::<BTreeSet<usize>>().len()
}

/// The series of a trace over `letters`, with `parameters` as inputs.
///
/// # Errors
/// [`Untapeable`] if an expression has no series.
pub(crate) fn recurrence_of(
    trace: &Trace<'_>,
    inputs: &Inputs,
    letters: Letters<'_>,
    parameters: &[Sym],
) -> Result<Expandable, Untapeable> {
    of_equations(&linear_equations(trace, letters), trace, inputs, letters, (parameters, None))
}

/// The series of linear equations, with parameters as inputs, and with the rate of an additional last state, if given.
fn of_equations(
    solve: &Solve,
    trace: &Trace<'_>,
    inputs: &Inputs,
    letters: Letters<'_>,
    (parameters, last): (&[Sym], Option<Sym>),
) -> Result<Expandable, Untapeable> {
    let mut rates = letters.put_into(trace, &trace.position_rates);
    rates.extend(&solve.unknowns[..trace.speeds.len()]);
    if let Some(last) = last {
        // the equations are solved for negative multipliers
        let (accelerations, multipliers) = solve.unknowns.split_at(trace.speeds.len());
        let solved: Vec<Sym> = accelerations.iter().copied().chain(multipliers.iter().map(|less| -*less)).collect();
        rates.extend(letters.put_into(trace, &[last.substitute(&unknown_letters(trace, &solved))]));
    }
    let mut all = rates.iter().copied().chain(solve.expressions());
    let time = all.any(|each| each.symbols_of().contains(&inputs.time)).then_some(inputs.time);
    Expandable::record(&Equations { state: &inputs.state, time, parameters, rates: &rates, solve: Some(solve) })
}
