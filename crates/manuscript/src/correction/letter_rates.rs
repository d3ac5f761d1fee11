//! The letters of a paper and their rates, as an edit may write them.

use crate::letters::{Letters, rate};
use symbolic::{Dimension, Sym};

/// A letter, or its rate of this order.
pub(super) struct LetterRate {
    pub name: String,
    pub order: u32,
    pub latex: String,
    pub dimension: Dimension,
    /// Whether it is one symbol of the model.
    pub is_symbol: bool,
    pub is_input: bool,
    /// Over the model.
    pub value: Sym,
}

/// Every letter that is a scalar, and its rates as far as they have a meaning of their own.
pub(super) fn rates(letters: &Letters<'_, '_>) -> Vec<LetterRate> {
    let trace = letters.trace;
    let mut all = Vec::new();
    for (name, value, _, dimension) in letters.scalars() {
        let (mut next, mut dimension) = (Some(value), dimension);
        for (order, dots) in (0..).zip(["", r"\dot", r"\ddot"]) {
            let Some(value) = next.filter(|value| order == 0 || *value != Sym::ZERO) else { break };
            let latex = if order == 0 { name.to_owned() } else { format!("{dots}{{{name}}}") };
            let is_symbol = value.symbol_name().is_some();
            let is_input = trace.model.inputs.iter().any(|input| Sym::symbol(&input.name) == value);
            all.push(LetterRate { name: name.to_owned(), order, latex, dimension, is_symbol, is_input, value });
            next = rate(trace, value).ok();
            dimension = dimension / Dimension::time();
        }
    }
    all
}

/// An expression of the model in the paper's letters: as it is, and by each letter that stands for a sum, solved for one of its symbols.
pub(super) fn ways_to_tell(letters: &Letters<'_, '_>, expression: Sym) -> Vec<Sym> {
    let mut all = vec![letters.told(expression)];
    let known = expression.symbols_of();
    for (_, value, own, _) in letters.scalars() {
        for symbol in value.symbols_of().into_iter().filter(|symbol| known.contains(symbol) && *symbol != value) {
            let factor = value.diff(symbol);
            if factor.as_constant().is_none() {
                continue;
            }
            let letter = Sym::symbol("letter that is told");
            let solved = (letter - value.substitute(&[(symbol, Sym::ZERO)])) / factor;
            let by_letter = expression.substitute(&[(symbol, solved)]);
            all.push(letters.told(by_letter).substitute(&[(letter, own)]));
        }
    }
    all
}
