//! Parameters that are zero and stand below a fraction.

use crate::letters::Letters;
use model::{Model, Trace};
use reader::Issue;
use symbolic::apart;

/// Characters of the longest divisor that may stand in a file.
const MOST_READ: usize = 40;

/// A parameter whose value makes a divisor zero, as the reason for which something has no value.
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
        // a long one is made by an elimination, and nobody has written it
        let is_written = zero.is_some() || text.chars().count() <= MOST_READ;
        Some((text, zero.or(first)?)).filter(|_| is_written)
    })?;
    let parameter = &model.parameters[place];
    let title = format!("an expression divides by `{divisor}`, which is zero");
    let label = format!("`{}` is {}", parameter.name, parameter.written);
    let accepted = "another value; or a model without this element: a spring or a capacitor without effect is left out";
    Some(Issue::at(parameter.at.clone(), title, label).accepted(accepted))
}
