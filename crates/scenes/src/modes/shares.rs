//! The distribution of friction among redundant sticking contacts.
//!
//! One consistent set of cases determines the motion. Conditions at zero that depend on held ones then share their forces: the switches
//! are s = 1/2 + B^T l, limited to 0 and 1, which is a convex problem with one solution (see `expansion/parts.rs`). Criss-cross pivots
//! find the switches at their limits.

use super::consistency::rests;
use super::decision::{TERMS, differ};
use super::expansion::{Expansion, Expansions, Instant, Slopes};
use super::mode::{Case, Mode};
use super::pivots::{Implied, replaced};

/// The largest number of pivots, for each condition at rest.
const PIVOTS: usize = 40;

/// The mode with shared conditions, and its motion; `None` if no condition is shared, or the pivots fail.
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
        // a direct condition has no share
        if expansions.direct_conditions[switch] {
            continue;
        }
        if mode.cases[switch] != Case::Held && rests(expansion, mode.cases[switch], switch, slack) {
            // a condition at zero that does not depend on held ones is held itself
            match Implied::of(slopes, &expansions.held(&mode), switch) {
                // a blocking diode keeps the condition at zero by its own voltage in this case
                Some(implied) if expansions.has_algebraic() && implied.terms().next().is_none() => {}
                // a condition of positions that remains at zero in one of its cases: the other case would move it
                Some(implied)
                    if implied.terms().next().is_none()
                        && moves(expansions, instant, (&mode, expansion), switch, slack) => {}
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

/// True if the motion changes when a condition takes a share of the forces.
fn moves(
    expansions: &Expansions,
    instant: &Instant<'_>,
    (mode, expansion): (&Mode, &Expansion<TERMS>),
    switch: usize,
    slack: f64,
) -> bool {
    let mut mode = mode.clone();
    mode.cases[switch] = Case::Shared;
    expansions.mirror(&mut mode);
    expansions.at::<TERMS>(instant, &mode).is_none_or(|shared| differ(&shared, expansion, slack))
}

/// The condition that is held instead of one whose switch remains at a bound: a shared condition, or a condition whose switch leaves its
/// own bound such that the first switch returns.
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
