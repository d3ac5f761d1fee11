//! Hypotheses that a print may have left out: a letter that is zero, a quantity that is constant.

use super::letter_rates::LetterRate;
use super::places::Places;
use super::probe::says_nothing;
use crate::claim_text::ClaimText;
use crate::integrals::known;
use crate::letters::Letters;
use crate::lines::lines;
use latex::read;
use std::cmp::Reverse;
use std::collections::BTreeSet;
use symbolic::Sym;

/// Letters and rates that are one symbol of the model, each as zero: inputs first, then what is differentiated most; those of the formula before
/// the others.
pub(super) fn candidates(places: &Places, rates: &[LetterRate]) -> Vec<String> {
    let names: BTreeSet<&str> = places.atoms.iter().map(|atom| atom.name.as_str()).collect();
    let mut all: Vec<&LetterRate> = rates.iter().filter(|rate| rate.is_symbol).collect();
    all.sort_by_key(|rate| (!names.contains(rate.name.as_str()), !rate.is_input, Reverse(rate.order)));
    all.iter().map(|rate| format!("{} = 0", rate.latex)).collect()
}

/// Whether a formula still states something where a letter is zero.
pub(super) fn leaves_something(claim: &ClaimText, hypothesis: &str, letters: &Letters<'_, '_>) -> bool {
    let zero =
        read(hypothesis, &letters.spelt()).ok().and_then(|statement| super::probe::own_difference(&statement, letters));
    let statement = read(&claim.formula.text, &known(claim.kind, letters)).ok();
    let (Some(zero), Some(statement)) = (zero, statement) else { return false };
    // claims of other kinds have sides that are read otherwise
    let Ok(mut lines) = lines(claim, &statement, letters) else { return true };
    lines.iter_mut().for_each(|line| line.own = line.own.map(|own| own.substitute(&[(zero, Sym::ZERO)])));
    !lines.iter().any(says_nothing)
}
