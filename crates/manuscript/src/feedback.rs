//! Inputs that hypotheses give: `u = F_0`, or `u = -k x - c v` as a feedback of the state. Such a hypothesis holds at all times, so that it may be
//! differentiated.

use crate::conditions::Hypothesis;
use crate::motion::{Motion, solution};
use model::Trace;
use symbolic::{Sym, substitute_all};

/// The inputs that hypotheses give.
pub(crate) struct Feedback {
    /// Expressions that are zero at all times, each with its input.
    laws: Vec<(Sym, Sym)>,
    /// The inputs by their values, in which no given input stands.
    values: Vec<(Sym, Sym)>,
}

impl Feedback {
    pub fn of(trace: &Trace<'_>, assumed: &[Hypothesis]) -> Self {
        let mut found = Feedback { laws: Vec::new(), values: Vec::new() };
        for hypothesis in assumed {
            let Some((zero, input)) = given_input(trace, hypothesis) else { continue };
            found.laws.push((zero, input));
            let by_others = found.put_in(zero);
            let Some(solved) = solution(trace, by_others, Some(input)).filter(|solved| solved.symbol == input) else {
                continue;
            };
            let new = [(input, solved.value)];
            found.values.iter_mut().for_each(|(_, value)| *value = value.substitute(&new));
            found.values.extend(new);
        }
        found
    }

    /// An expression with the values of given inputs.
    pub fn put_in(&self, expression: Sym) -> Sym {
        substitute_all(&[expression], &self.values)[0]
    }

    /// Puts the given inputs into the equations of a motion.
    ///
    /// # Errors
    /// One of them cannot be solved for its input.
    pub fn close(&self, motion: &mut Motion<'_, '_>) -> Result<(), String> {
        self.laws.iter().try_for_each(|&(zero, input)| motion.assume(zero, Some(input)))
    }
}

/// The input that a hypothesis gives at all times, with the expression that is then zero; none of a hypothesis on the state at an instant.
pub(crate) fn given_input(trace: &Trace<'_>, hypothesis: &Hypothesis) -> Option<(Sym, Sym)> {
    let (zero, alone) = hypothesis.equality?;
    let input = alone?;
    trace.model.inputs.iter().any(|one| Sym::symbol(&one.name) == input).then_some((zero, input))
}
