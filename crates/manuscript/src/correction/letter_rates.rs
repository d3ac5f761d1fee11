//! The letters of a paper and their rates, in the form in which edits write them.

use crate::letters::{Letters, rate};
use model::equations::constraints_of;
use symbolic::{Dimension, Sym};

/// A letter (order 0), its rate (1) or its second rate (2).
pub(super) struct LetterRate {
    pub name: String,
    /// The number of differentiations.
    pub order: u32,
    pub latex: String,
    pub dimension: Dimension,
    /// Whether the letter is a single symbol of the model.
    pub is_symbol: bool,
    pub is_input: bool,
    pub is_parameter: bool,
    /// Whether the letter is the reaction of a constraint.
    pub is_reaction: bool,
    /// The value in the symbols of the model.
    pub value: Sym,
    /// Whether the value is zero along every motion, such as the rate of an integral; a formula multiplied by it would state nothing.
    pub vanishes: bool,
}

/// All scalar letters, and their rates as far as they are defined.
pub(super) fn rates(letters: &Letters<'_, '_>) -> Vec<LetterRate> {
    let trace = letters.trace;
    let reactions: Vec<Sym> = constraints_of(trace).into_iter().map(|one| one.multiplier).collect();
    let mut all = Vec::new();
    for (name, value, _, dimension) in letters.scalars() {
        let (mut next, mut dimension) = (Some(value), dimension);
        for (order, dots) in (0..).zip(["", r"\dot", r"\ddot"]) {
            let Some(value) = next.filter(|value| order == 0 || *value != Sym::ZERO) else { break };
            let latex = if order == 0 { name.to_owned() } else { format!("{dots}{{{name}}}") };
            let is_symbol = value.symbol_name().is_some();
            let is_input = trace.model.inputs.iter().any(|input| Sym::symbol(&input.name) == value);
            all.push(LetterRate {
                name: name.to_owned(),
                order,
                latex,
                dimension,
                is_symbol,
                is_input,
                is_parameter: trace.parameters.contains(&value),
                is_reaction: reactions.contains(&value),
                value,
                vanishes: false,
            });
            next = rate(trace, value).ok();
            dimension = dimension / Dimension::time();
        }
    }
    all
}
