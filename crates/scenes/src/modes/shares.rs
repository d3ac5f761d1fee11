//! The distribution of friction among redundant sticking contacts.
//!
//! One set of cases that agrees gives the motion. Conditions at rest that held ones imply then share with these: switches
//! s = 1/2 + B^T l, cut at 0 and at 1, which is a convex problem with one solution (see the parts of an expansion). Criss-cross pivots
//! find those that are cut.

use super::decision::{TERMS, rests};
use super::expansion::{Expansion, Expansions, Instant, Slopes};
use super::mode::{Case, Mode};
use super::pivots::{Implied, replaced};

/// Pivots for each condition at rest.
const PIVOTS: usize = 40;

/// The mode with its shares, where contacts share; none where no shares are found.
pub(super) fn shares(
    expansions: &Expansions,
    instant: &Instant<'_>,
    (mode, expansion): (&Mode, &Expansion<TERMS>),
    open: &[usize],
    slack: f64,
) -> Option<(Mode, Expansion<TERMS>)> {
    let slopes = &expansion.slopes;
    let mut mode = mode.clone();
    let mut shared = Vec::new();
    for &switch in open {
        // one whose value follows at once has no share
        if expansions.direct_conditions[switch] {
            continue;
        }
        if mode.cases[switch] != Case::Held && rests(expansion, mode.cases[switch], switch, slack) {
            // a condition at rest that no others imply is held
            match Implied::of(slopes, &expansions.held(&mode), switch) {
                // a diode that blocks keeps it there alone, by the voltage that this case leaves across it
                Some(implied) if expansions.has_algebraic() && implied.terms().next().is_none() => {}
                Some(_) => shared.push(switch),
                None => mode.cases[switch] = Case::Held,
            }
        }
    }
    if shared.is_empty() {
        return None;
    }
    let resting: Vec<usize> =
        open.iter().copied().filter(|switch| mode.cases[*switch] == Case::Held || shared.contains(switch)).collect();
    shared.into_iter().for_each(|switch| mode.cases[switch] = Case::Shared);
    for _ in 0..PIVOTS * resting.len() {
        expansions.mirror(&mut mode);
        let expansion = expansions.at::<TERMS>(instant, &mode)?;
        let turned = resting.iter().find_map(|&switch| {
            let [low, high] = expansion.margins(switch).map(|margin| margin.sign(slack));
            let to = match mode.cases[switch] {
                Case::Held | Case::Shared if low < 0.0 => Case::Spent { on: false },
                Case::Held | Case::Shared if high < 0.0 => Case::Spent { on: true },
                Case::Spent { on: true } if high > 0.0 => Case::Shared,
                Case::Spent { on: false } if low > 0.0 => Case::Shared,
                _ => return None,
            };
            Some((switch, to))
        });
        let Some((switch, to)) = turned else { return Some((mode, expansion)) };
        if mode.cases[switch] == Case::Held {
            let successor = successor((&expansion.slopes, &expansions.held(&mode)), &mode.cases, &resting, switch, to)?;
            mode.cases[successor] = Case::Held;
        }
        mode.cases[switch] = to;
    }
    None
}

/// The condition that is held in the place of another whose switch stays at a bound: a shared one, or one whose switch leaves its own
/// bound such that the other returns.
fn successor(
    (slopes, held): (&Slopes<TERMS>, &[usize]),
    mode: &[Case],
    resting: &[usize],
    switch: usize,
    to: Case,
) -> Option<usize> {
    let needed = if to == (Case::Spent { on: true }) { -1.0 } else { 1.0 };
    let change = |other: usize| {
        let all = replaced(slopes, held, other)?;
        all.into_iter().find(|(held, _)| *held == switch).map(|(_, sign)| sign).filter(|sign| *sign != 0.0)
    };
    let shared = resting.iter().copied().filter(|&other| mode[other] == Case::Shared);
    let mut spent = resting.iter().copied().filter_map(|other| match mode[other] {
        Case::Spent { on } => Some((other, if on { -1.0 } else { 1.0 })),
        _ => None,
    });
    shared
        .into_iter()
        .find(|&other| change(other).is_some())
        .or_else(|| spent.find_map(|(other, way)| change(other).filter(|sign| sign * way == needed).map(|_| other)))
}
