//! Inputs that hypotheses prescribe: `u = F_0`, or a state feedback `u = -k x - c v`. Such a hypothesis holds at all times and may therefore be
//! differentiated.

use crate::conditions::Hypothesis;
use crate::motion::{Motion, solution};
use model::Trace;
use symbolic::{Sym, substitute_all};

/// The inputs that hypotheses prescribe.
pub(crate) struct Feedback {
    /// Expressions that vanish at all times, each with the input that it determines.
    laws: Vec<(Sym, Sym)>,
    /// The inputs with their values, which contain no prescribed input.
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

    /// An expression with prescribed inputs replaced by their values.
    pub fn put_in(&self, expression: Sym) -> Sym {
        substitute_all(&[expression], &self.values)[0]
    }

    /// Adds the prescribed inputs to the equations of a motion.
    ///
    /// # Errors
    /// A hypothesis cannot be solved for its input.
    pub fn close(&self, motion: &mut Motion<'_, '_>) -> Result<(), String> {
        self.laws.iter().try_for_each(|&(zero, input)| motion.assume(zero, Some(input)))
    }
}

/// The input that a hypothesis prescribes at all times, with the expression that vanishes then; `None` for a hypothesis about the state at an instant.
pub(crate) fn given_input(trace: &Trace<'_>, hypothesis: &Hypothesis) -> Option<(Sym, Sym)> {
    let (zero, alone) = hypothesis.equality?;
    let input = alone?;
    trace.model.inputs.iter().any(|one| Sym::symbol(&one.name) == input).then_some((zero, input))
}
