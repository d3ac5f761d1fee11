//! Equations of motion as series, accelerations and multipliers by one factorisation a step.

use super::linear_equations;
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
        recurrence_of(&Trace::of(model), &inputs, letters, &[]).ok()
    })
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
    let solve = linear_equations(trace, letters);
    let mut rates = letters.put_into(trace, &trace.position_rates);
    rates.extend(&solve.unknowns[..trace.speeds.len()]);
    let mut all = rates.iter().copied().chain(solve.expressions());
    let time = all.any(|each| each.symbols_of().contains(&inputs.time)).then_some(inputs.time);
    Expandable::record(&Equations { state: &inputs.state, time, parameters, rates: &rates, solve: Some(&solve) })
}
