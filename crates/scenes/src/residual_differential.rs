//! The differential of the equations of motion for Jacobians, computed from their residuals M u' + h - Q. It has about half as many terms as
//! the differential of the explicit accelerations, which contain the factors of the mass matrix.

use crate::changing_laws::changes;
use crate::letters::Letters;
use model::equations::{Residuals, constraints_of, solved};
use model::{Model, Trace};
use simulation::{DirectionalProgram, SymbolicLaw};
use std::sync::Arc;
use symbolic::{Differential, Sym};

/// A program for directional derivatives of a model's law: from residuals if the law has one mode and no algebraic speeds, otherwise from
/// `law`.
pub(crate) fn residual_differential(model: &Arc<Model>, law: Arc<dyn SymbolicLaw>) -> DirectionalProgram {
    if changes(model) || !model.algebraic_speeds.is_empty() {
        return DirectionalProgram::of(law);
    }
    let model = Arc::clone(model);
    DirectionalProgram::by(model.positions() + model.speeds(), move |state, time| {
        by_residuals(&model, (state, time)).unwrap_or_else(|| DirectionalProgram::of_rates(&*law, state, time))
    })
}

/// The differential with the least cost among those of all forms of the residuals; `None` if the accelerations have no expression.
fn by_residuals(model: &Model, (state, time): (&[Sym], Sym)) -> Option<Differential> {
    let (trace, letters) = (Trace::of(model), Letters::with_data(time, state));
    let (accelerations, multipliers) = solved(&trace).ok()?;
    let rates = letters.put_into(&trace, &trace.position_rates);
    let all = Residuals::of(&trace).into_iter().map(|one| composed(&trace, (letters, state, time), &rates, &one));
    let shortest = all.min_by_key(cost)?;
    let multiplier_letters = constraints_of(&trace).into_iter().map(|one| one.multiplier);
    let unknowns = trace.accelerations.iter().copied().chain(multiplier_letters);
    let found = letters.put_into(&trace, &[accelerations, multipliers].concat());
    Some(shortest.substituted(&unknowns.zip(found).collect::<Vec<_>>()))
}

/// The estimated number of operations of one Jacobian: terms for all batches of directions, and the operations for the coefficients.
fn cost(differential: &Differential) -> usize {
    let weights = differential.weights();
    let runs = differential.inputs.div_ceil(DirectionalProgram::DIRECTIONS);
    8 * runs * weights.len() + Sym::operations_of(&weights)
}

/// Composes two differentials: of position rates and residuals by state and time, at fixed accelerations; and of accelerations by residuals.
fn composed(
    trace: &Trace<'_>,
    (letters, state, time): (Letters<'_>, &[Sym], Sym),
    rates: &[Sym],
    equations: &Residuals,
) -> Differential {
    let residuals = letters.put_into(trace, &equations.residuals);
    let inner = Differential::of(&[state, &[time]].concat(), &[rates, &residuals].concat());
    let copies: Vec<Sym> = (0..rates.len()).map(|place| Sym::symbol(&format!("rate {place}"))).collect();
    let answers = letters.put_into(trace, &equations.answers[..trace.speeds.len()]);
    let outer = Differential::of(&[&copies[..], &equations.letters].concat(), &[&copies[..], &answers].concat());
    inner.then(&outer)
}
