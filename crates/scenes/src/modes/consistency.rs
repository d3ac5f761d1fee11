//! The consistency of cases of conditions and phases of contacts with the motion that they give.

use super::decision::{FEW, Open, TERMS};
use super::expansion::{Expansion, Touching};
use super::mode::{Case, Mode};
use super::touch::{Beside, possible, standing_of};

/// The degree of consistency of a combination, in ascending order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Standing {
    /// A contact does not press, because others carry the body.
    Carries,
    /// A condition, or a contact, remains at zero although its case requires that it leaves zero.
    Rests,
    /// The switch value of a held condition, or a reaction, remains at its bound.
    AtBound,
    /// Every condition and contact moves as its case or phase requires.
    Moves,
}

/// The case to try next for a condition, if the motion contradicts its assumed case.
pub(super) fn contradicted(expansion: &Expansion<TERMS>, case: Case, switch: usize, slack: f64) -> Option<Case> {
    let [low, high] = expansion.margins(switch).map(|margin| margin.sign(slack) < 0.0);
    match case {
        Case::Held if low => Some(Case::Off),
        Case::Held if high => Some(Case::On),
        Case::On | Case::Off => alone(expansion, case, switch, slack).is_none().then_some(Case::Held),
        _ => None,
    }
}

/// True if a condition that should leave zero remains there.
pub(super) fn rests(expansion: &Expansion<TERMS>, case: Case, switch: usize, slack: f64) -> bool {
    alone(expansion, case, switch, slack) == Some(Standing::Rests)
}

/// True if the hidden constraints of a mode hold.
pub(super) fn holds_hidden<const N: usize>(expansion: &Expansion<N>, slack: f64) -> bool {
    expansion.hidden.iter().all(|hidden| hidden.sign_of(0, slack) == 0.0)
}

/// True if the first terms contradict no case of an open condition and no phase of a contact.
pub(super) fn is_possible(sifted: &Expansion<FEW>, mode: &Mode, open: Open<'_>, slack: f64) -> bool {
    if !holds_hidden(sifted, slack) {
        return false;
    }
    let order = |switch: usize| usize::from(!sifted.is_direct[switch]);
    let mut contacts = sifted.contacts.iter().zip(&mode.phases).zip(open.touches);
    let agree = contacts.all(|((contact, phase), touch)| possible(contact, *phase, *touch, slack));
    agree
        && open.switches.iter().all(|&switch| match mode.cases[switch] {
            Case::On => sifted.conditions[switch].sign_of(order(switch), slack) >= 0.0,
            Case::Off => sifted.conditions[switch].sign_of(order(switch), slack) <= 0.0,
            _ => sifted.margins(switch).iter().all(|margin| margin.sign_of(0, slack) >= 0.0),
        })
}

/// The degree of consistency of open conditions and contacts; `None` for a contradiction.
pub(super) fn standing(expansion: &Expansion<TERMS>, mode: &Mode, open: Open<'_>, slack: f64) -> Option<Standing> {
    if !holds_hidden(expansion, slack) {
        return None;
    }
    let each = open.switches.iter().map(|&switch| alone(expansion, mode.cases[switch], switch, slack));
    each.chain([of_contacts(expansion, mode, open, slack)]).min().unwrap_or(Some(Standing::Moves))
}

/// The degree of consistency of the contacts; `None` for a contradiction.
pub(super) fn of_contacts(expansion: &Expansion<TERMS>, mode: &Mode, open: Open<'_>, slack: f64) -> Option<Standing> {
    let contacts = expansion.contacts.iter().zip(&mode.phases).zip(open.touches);
    let is_alone = open.is_alone();
    let pressure = |contact: &Touching<TERMS>| contact.reactions[0].terms[0].abs();
    let all: f64 = expansion.contacts.iter().map(pressure).sum();
    let acceleration = expansion.rates.iter().map(|rate| rate.terms[0].abs()).fold(0.0, f64::max);
    let each = contacts.map(|((contact, phase), touch)| {
        let beside = Beside { others: all - pressure(contact), acceleration };
        standing_of(contact, *phase, (*touch, is_alone), beside, slack)
    });
    each.min().unwrap_or(Some(Standing::Moves))
}

/// The degree of consistency of one condition; `None` for a contradiction.
pub(super) fn alone(expansion: &Expansion<TERMS>, case: Case, switch: usize, slack: f64) -> Option<Standing> {
    let condition = &expansion.conditions[switch];
    // a condition that drifted off zero while it was held must cross zero again
    let band = || (slack * condition.doubts[0]).max(4.0 * beyond(condition.terms[0], case));
    // the value of a direct condition has the sign of its case, or leaves zero in this direction
    let value = if expansion.is_direct[switch] { condition.sign_of(0, slack) } else { 0.0 };
    let (signs, at_zero) = match case {
        Case::On if value != 0.0 => ([value; 2], Standing::Rests),
        Case::Off if value != 0.0 => ([-value; 2], Standing::Rests),
        Case::On => ([condition.way(band(), slack); 2], Standing::Rests),
        Case::Off => ([-condition.way(band(), slack); 2], Standing::Rests),
        _ => (expansion.margins(switch).map(|margin| margin.sign(slack)), Standing::AtBound),
    };
    let contradicts = |sign: &f64| sign.is_nan() || *sign < 0.0;
    match signs {
        _ if signs.iter().any(contradicts) => None,
        _ if signs.contains(&0.0) => Some(at_zero),
        _ => Some(Standing::Moves),
    }
}

/// The absolute value of a condition on the side of zero opposite to its case, else zero.
pub(super) fn beyond(value: f64, case: Case) -> f64 {
    match case {
        Case::On => (-value).max(0.0),
        Case::Off => value.max(0.0),
        _ => 0.0,
    }
}
