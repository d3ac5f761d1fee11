//! Rest beside a motion that leaves it: bodies wedged between contacts, and conditions that stay at zero.
//!
//! With more reactions than motions a contact whose friction is at its bound may rest, since the others hold it; the reactions are then those at
//! an end of a range. Coulomb's law allows this rest beside a motion in which one of the contacts opens, and the law does not decide between
//! both. A body at rest at x = 0 under `if(x > 0, F, 0)` may stay there or leave.

use super::consistency::{Standing, alone, holds_hidden, of_contacts, rests, standing};
use super::decision::{Open, TERMS};
use super::expansion::Expansion;
use super::mode::{Case, Mode};

/// Accelerations that differ by less than this part of the largest one count as equal.
const APART: f64 = 1e-6;

/// The combinations in which bodies stay at rest beside the motion of the combination `first`, whose degree of consistency is `best`.
pub(super) fn rests_beside(
    all: &[(Mode, Expansion<TERMS>)],
    (best, first): (Standing, usize),
    open: Open<'_>,
    slack: f64,
) -> Vec<usize> {
    let staying = (0..all.len()).filter(|&place| best == Standing::Moves && stays(&all[place], open, slack));
    staying.chain(wedged(all, first, open, slack)).collect()
}

/// True if a motion keeps conditions at zero with the values that they have there: off for g > 0, on for g >= 0.
fn stays((mode, expansion): &(Mode, Expansion<TERMS>), open: Open<'_>, slack: f64) -> bool {
    let rests = |switch: &&usize| rests(expansion, mode.cases[**switch], **switch, slack);
    standing(expansion, mode, open, slack) == Some(Standing::Rests)
        && of_contacts(expansion, mode, open, slack) == Some(Standing::Moves)
        && open.switches.iter().filter(rests).all(|&switch| match mode.cases[switch] {
            Case::On => open.at_zero[switch] == Some(true),
            Case::Off => open.at_zero[switch] == Some(false),
            _ => false,
        })
}

/// The combinations in which contacts rest since others hold them, with other accelerations than a combination.
fn wedged(all: &[(Mode, Expansion<TERMS>)], first: usize, open: Open<'_>, slack: f64) -> Vec<usize> {
    if open.is_alone() {
        return Vec::new();
    }
    let known = &all[first].1.rates;
    let differs = |expansion: &Expansion<TERMS>| {
        let pairs = || expansion.rates.iter().zip(known).map(|(own, known)| [own.terms[0], known.terms[0]]);
        let size = pairs().flatten().fold(0.0, |size: f64, rate| size.max(rate.abs()));
        pairs().any(|[own, known]| (own - known).abs() > APART * size)
    };
    let moves = |switch: usize, mode: &Mode, expansion: &Expansion<TERMS>| {
        alone(expansion, mode.cases[switch], switch, slack) == Some(Standing::Moves)
    };
    let is_wedged = |(mode, expansion): &(Mode, Expansion<TERMS>)| {
        differs(expansion)
            && holds_hidden(expansion, slack)
            && open.switches.iter().all(|&switch| moves(switch, mode, expansion))
            && matches!(of_contacts(expansion, mode, open, slack), Some(Standing::Rests | Standing::Carries))
    };
    (0..all.len()).filter(|&place| is_wedged(&all[place])).collect()
}
