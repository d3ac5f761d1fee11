//! The forms of an expression of the model in the letters of a paper.

use crate::letters::Letters;
use crate::position_letters::by_position_letters;
use symbolic::{Hypotheses, Sym};

/// A letter for a sum: the symbol that it replaces, the value of this symbol by the letter, and the paper's own letter.
struct ForSum {
    symbol: Sym,
    value: Sym,
    placeholder: Sym,
    own: Sym,
}

/// The forms of an expression of the model in the paper's letters: unchanged; with one or all letters for sums, each solved for one of its
/// symbols; and each of these with letters that are functions of the position.
pub(crate) fn ways_to_tell(letters: &Letters<'_, '_>, expression: Sym, hypotheses: &Hypotheses) -> Vec<Sym> {
    let for_sums = letters_for_sums(letters, expression);
    let by_all = (for_sums.len() > 1).then(|| {
        let mut replaced: Vec<Sym> = Vec::new();
        for_sums.iter().fold(expression, |known, one| {
            // with two letters for one symbol the replacement would not end
            let is_new = !replaced.contains(&one.symbol) && known.symbols_of().contains(&one.symbol);
            replaced.extend(is_new.then_some(one.symbol));
            if is_new { known.substitute(&[(one.symbol, one.value)]) } else { known }
        })
    });
    let by_one = for_sums.iter().map(|one| expression.substitute(&[(one.symbol, one.value)]));
    let own: Vec<(Sym, Sym)> = for_sums.iter().map(|one| (one.placeholder, one.own)).collect();
    let told = |way: Sym| {
        let by_position = by_position_letters(letters, way, hypotheses);
        [Some(letters.told(way)), by_position].into_iter().flatten().map(|way| way.substitute(&own)).collect::<Vec<_>>()
    };
    [expression].into_iter().chain(by_one).chain(by_all).flat_map(told).collect()
}

fn letters_for_sums(letters: &Letters<'_, '_>, expression: Sym) -> Vec<ForSum> {
    let known = expression.symbols_of();
    let mut all = Vec::new();
    for (name, value, own, _) in letters.scalars() {
        let placeholder = Sym::symbol(&format!("told letter {name}"));
        for symbol in value.symbols_of().into_iter().filter(|symbol| known.contains(symbol) && *symbol != value) {
            let factor = value.diff(symbol);
            if factor.as_constant().is_some() {
                let value = (placeholder - value.substitute(&[(symbol, Sym::ZERO)])) / factor;
                all.push(ForSum { symbol, value, placeholder, own });
            }
        }
    }
    all
}
