//! The forms of an expression of the model in the letters of a paper.

use crate::letters::Letters;
use crate::position_letters::by_position_letters;
use symbolic::{Hypotheses, Sym, normal};

/// A letter for a sum, or for a product of parameters: a symbol in its meaning, the value of this symbol in terms of the letter, and the letter.
struct ForSum {
    symbol: Sym,
    value: Sym,
    placeholder: Sym,
    own: Sym,
}

/// The forms of an expression of the model in the paper's letters: without letters for sums and products; with one or all of these letters, each replacing
/// one symbol of its meaning; and each of these forms also with letters that are functions of the position.
pub(crate) fn ways_to_tell(letters: &Letters<'_, '_>, expression: Sym, hypotheses: &Hypotheses) -> Vec<Sym> {
    let for_sums = letters_for_sums(letters, expression);
    let by_all = (for_sums.len() > 1).then(|| {
        let mut replaced: Vec<Sym> = Vec::new();
        for_sums.iter().fold(expression, |known, one| {
            // a second letter for the same symbol would replace it again
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
            let rest = value.substitute(&[(symbol, Sym::ZERO)]);
            let solved = (placeholder - rest) / factor;
            let is_product =
                || rest == Sym::ZERO && is_of_parameters(letters, value) && divides(expression, symbol, solved);
            if factor.as_constant().is_some() || is_product() {
                all.push(ForSum { symbol, value: solved, placeholder, own });
            }
        }
    }
    all
}

fn is_of_parameters(letters: &Letters<'_, '_>, value: Sym) -> bool {
    value.leaves_of().iter().all(|leaf| leaf.as_constant().is_some() || letters.trace.parameters.contains(leaf))
}

/// Whether the replacement of a symbol by a letter for a product adds no divisor, so that the letter replaces the whole product.
fn divides(expression: Sym, symbol: Sym, solved: Sym) -> bool {
    let below = |expression: Sym| normal(expression, &Hypotheses::none()).map(|form| form.denominator().symbols_of());
    match (below(expression), below(expression.substitute(&[(symbol, solved)]))) {
        (Ok(before), Ok(after)) => after.iter().all(|symbol| before.contains(symbol)),
        _ => false,
    }
}
