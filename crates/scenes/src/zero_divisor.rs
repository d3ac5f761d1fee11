//! Detection of parameters that are zero and occur in a divisor.

use crate::letters::Letters;
use model::{Model, Trace};
use reader::Issue;
use symbolic::apart;

/// Largest number of characters of a divisor that a user may have written.
const MOST_READ: usize = 40;

/// The fault of a parameter whose value makes a divisor zero; `None` if there is none.
pub(crate) fn found(model: &Model) -> Option<Issue> {
    let (divisor, place) = apart(|| {
        let trace = Trace::of(model);
        let divisors = trace.parameter_divisors();
        let state: Vec<_> = trace.coordinates.iter().chain(&trace.speeds).copied().collect();
        let values = Letters::with_decimals(trace.time, &state).put_into(&trace, &divisors);
        let is_zero = |value: &symbolic::Sym| value.as_constant().is_some_and(|value| value.to_f64() == 0.0);
        let divisor = divisors.iter().zip(&values).find(|(_, value)| is_zero(value))?.0;
        let symbols = divisor.symbols_of();
        let own = |place: &usize| symbols.contains(&trace.parameters[*place]);
        let mut parameters = (0..trace.parameters.len()).filter(own);
        let first = parameters.clone().next();
        let zero = parameters.find(|&place| model.parameters[place].value == Some(0.0));
        let text = divisor.to_string();
        // a longer divisor results from an elimination, and would mean nothing to the user
        let is_written = zero.is_some() || text.chars().count() <= MOST_READ;
        Some((text, zero.or(first)?)).filter(|_| is_written)
    })?;
    let parameter = &model.parameters[place];
    let title = format!("an expression divides by `{divisor}`, which is zero");
    let label = format!("`{}` is {}", parameter.name, parameter.written);
    let accepted = "another value; or a model without this element: a spring or a capacitor without effect is left out";
    Some(Issue::at(parameter.at.clone(), title, label).accepted(accepted))
}
