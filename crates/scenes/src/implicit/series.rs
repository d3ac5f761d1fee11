//! Equations of motion as series, accelerations and multipliers by one factorisation a step.

use super::{linear_equations, unknown_letters};
use crate::letters::{Inputs, Letters};
use model::{Model, Trace};
use series::Equations;
use simulation::Expandable;
use symbolic::{Sym, Untapeable, apart};

/// The equations of a model with the values of its parameters; none where they have no series.
pub(crate) fn recurrence(model: &Model) -> Option<Expandable> {
    apart(|| {
        let inputs = Inputs::of(model);
        let letters = Letters::with_data(inputs.time, &inputs.state);
        recurrence_of(&Trace::of(model), &inputs, letters, &[], None).ok()
    })
}

/// The same with a last state that grows at a rate of its own, an expression over the letters of the trace.
pub(crate) fn recurrence_with(model: &Model, rate: impl Fn(&Trace<'_>) -> Sym + Send + Sync) -> Option<Expandable> {
    apart(|| {
        let mut inputs = Inputs::of(model);
        let (own, grown) = (inputs.state.clone(), Sym::symbol("grown"));
        inputs.state.push(grown);
        let trace = Trace::of(model);
        let rate = rate(&trace);
        recurrence_of(&trace, &inputs, Letters::with_data(inputs.time, &own), &[], Some(rate)).ok()
    })
}

/// The equations of a trace over letters; `parameters` are inputs of them, and a last state may grow at a rate of its own.
///
/// # Errors
/// [`Untapeable`] where an expression has no series.
pub(crate) fn recurrence_of(
    trace: &Trace<'_>,
    inputs: &Inputs,
    letters: Letters<'_>,
    parameters: &[Sym],
    last: Option<Sym>,
) -> Result<Expandable, Untapeable> {
    let solve = linear_equations(trace, letters);
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
    Expandable::record(&Equations { state: &inputs.state, time, parameters, rates: &rates, solve: Some(&solve) })
}
