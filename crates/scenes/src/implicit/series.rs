//! Taylor series of the equations of motion, with accelerations and multipliers by one factorisation per step.

use super::{linear_equations, unknown_letters};
use crate::letters::{Inputs, Letters};
use model::{Model, Trace};
use series::Equations;
use simulation::Expandable;
use std::collections::BTreeSet;
use symbolic::linear::Solve;
use symbolic::{Sym, Untapeable, apart};

/// The equations of a model with the values of its parameters; none where they have no series, or where fewer unknowns than these have
/// coefficients that move: an elimination that is written down has constants in the place of all others.
pub(crate) fn recurrence(model: &Model, least: usize) -> Option<Expandable> {
    apart(|| {
        let inputs = Inputs::of(model);
        let (trace, letters) = (Trace::of(model), Letters::with_data(inputs.time, &inputs.state));
        let solve = linear_equations(&trace, letters);
        (moving(&solve) >= least).then(|| of_equations(&solve, &trace, &inputs, letters, (&[], None)).ok())?
    })
}

/// The series of a model with a further last state, whose rate is an expression over the letters of the trace.
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

/// The number of unknowns with a coefficient that moves.
fn moving(solve: &Solve) -> usize {
    let entries = solve.pattern.places().iter().zip(&solve.entries);
    let columns = entries.filter(|(_, entry)| !entry.symbols_of().is_empty()).map(|(&(_, column), _)| column);
    columns.collect::<BTreeSet<usize>>().len()
}

/// The equations of a trace over letters; `parameters` are inputs of them.
///
/// # Errors
/// [`Untapeable`] where an expression has no series.
pub(crate) fn recurrence_of(
    trace: &Trace<'_>,
    inputs: &Inputs,
    letters: Letters<'_>,
    parameters: &[Sym],
) -> Result<Expandable, Untapeable> {
    of_equations(&linear_equations(trace, letters), trace, inputs, letters, (parameters, None))
}

/// The series of equations of a trace, with their parameters, and with the rate of a last state where there is one.
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
