//! Laws that change at conditions: each condition holds, fails, or is zero, and then its part of the law lies anywhere between both, as dry
//! friction does that sticks.
//!
//! Where a condition is zero at every rest, as the sign of a speed is, it is zero. Else all three are tried; where the law is the same on
//! both sides of the condition's zero, as of `abs`, that zero belongs to the sides.

use super::rows::{Rows, Touching};
use super::{NoSteadyMotions, Range};
use model::equations::vanishes;
use model::{Model, Trace};
use symbolic::{Sym, substitute_all};

/// The case of a condition, or of the gap of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    Holds,
    Fails,
    /// Its value is zero, and its part of the law lies between both; a contact is in touch, and sticks.
    Between,
}

/// More combinations of cases are not tried.
const MOST: usize = 243;

/// The part of a law at a condition's zero, between that where it fails and that where it holds.
pub(super) const BETWEEN: Range = Range { from: 0.0, to: 1.0 };

/// All combinations of cases that are tried.
pub(super) fn combinations(rows: &Rows, at_rest: &[(Sym, Sym)]) -> Result<Vec<Vec<Case>>, NoSteadyMotions> {
    let values = substitute_all(&rows.conditions, at_rest);
    let mut all: Vec<Vec<Case>> = vec![Vec::new()];
    let letters = rows.condition_letters.iter().map(Some).chain(rows.contacts.iter().map(|_| None));
    let contacts = rows.condition_letters.iter().map(|_| None).chain(rows.contacts.iter().map(Some));
    for ((value, letter), contact) in values.iter().zip(letters).zip(contacts) {
        let cases: &[Case] = match value.as_constant() {
            _ if contact.is_some_and(|contact| !contact.is_one_sided) => &[Case::Between],
            _ if contact.is_some() => &[Case::Holds, Case::Between],
            _ if vanishes(*value) => &[Case::Between],
            Some(number) if number.to_f64() > 0.0 => &[Case::Holds],
            Some(_) => &[Case::Fails],
            None if letter.is_some_and(|letter| is_continuous(rows, *letter, *value)) => &[Case::Holds, Case::Fails],
            None => &[Case::Holds, Case::Fails, Case::Between],
        };
        all = all.iter().flat_map(|own| cases.iter().map(move |case| [&own[..], &[*case]].concat())).collect();
        if all.len() > MOST {
            return Err(NoSteadyMotions::ManyConditions { conditions: rows.conditions.len(), most: MOST });
        }
    }
    Ok(all)
}

/// The conditions of a law, and the gaps of its contacts, as texts.
pub fn conditions_of(model: &Model) -> Vec<String> {
    let own = |trace: Trace<'_>| -> Vec<String> {
        let conditions = model.switches.iter().map(|&own| trace.scalar(own).to_string());
        let gaps = model.contacts.iter().enumerate().map(|(place, one)| format!("the gap of {}", one.title(place)));
        conditions.chain(gaps).collect()
    };
    symbolic::apart(|| own(Trace::of(model)))
}

/// Everything that a contact in touch adds: the normal reaction as a multiplier, the shares of friction that are used, from -1 to 1 along each
/// tangent, with the tangential reactions by these, and what shall be positive.
pub(super) struct InTouch {
    pub normal: Sym,
    pub shares: Vec<(Sym, Sym)>,
    pub sides: Vec<Sym>,
}

impl InTouch {
    pub fn of(contact: &Touching) -> Option<Self> {
        let (&normal, tangential) = contact.reactions.split_first()?;
        let share = |letter: &Sym| {
            let own = Sym::symbol(&format!("{letter}/({normal} mu)"));
            (own, contact.friction.map_or(Sym::ZERO, |friction| friction * own * normal))
        };
        let shares: Vec<(Sym, Sym)> = tangential.iter().map(share).collect();
        let mut sides = Vec::new();
        if contact.is_one_sided {
            sides.push(normal);
        }
        if shares.len() > 1 {
            sides.push(shares.iter().fold(Sym::ONE, |rest, (own, _)| rest - *own * *own));
        }
        Some(InTouch { normal, shares, sides })
    }
}

/// The share of friction along a tangent.
pub(super) const SHARE: Range = Range { from: -1.0, to: 1.0 };

/// Whether the law does not jump where a condition is zero: shown for conditions that are linear in a letter.
fn is_continuous(rows: &Rows, letter: Sym, value: Sym) -> bool {
    let jumps: Vec<Sym> = rows.residuals.iter().map(|row| row.diff(letter)).filter(|jump| !vanishes(*jump)).collect();
    value.symbols_of().into_iter().any(|own| {
        let slope = value.diff(own);
        if slope.symbols_of().contains(&own) || vanishes(slope) {
            return false;
        }
        let there = own - value / slope;
        jumps.iter().all(|jump| vanishes(jump.substitute(&[(own, there)])))
    })
}
