//! All consistent regimes of contacts and conditions at a state, with their margins, and the critical friction.

use super::combinations::combinations;
use super::critical_friction::Critical;
use super::decision::{Candidates, Decided, MOST_OPEN, MOST_TRIED, Open, SLACKS, TERMS, best, decided, differ};
use super::expansion::{Expansion, Expansions, Instant};
use super::jet::Jet;
use super::mode::{Case, Mode, Phase};
use super::reasons::TOGETHER;
use super::rests::rests_beside;
use super::touch::{Touch, leaving, margins};
use super::unfit::Unfit;
use super::{Modes, Refused};
use model::OneWay;

/// A regime (the case of each condition, the phase of each contact) that is consistent with its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Regime {
    /// The regime in words.
    pub name: String,
    /// The conditions of consistency, with their margins.
    pub margins: Vec<Margin>,
    /// The index of its motion: regimes with different reactions may have equal motions, and then equal indices.
    pub motion: usize,
    /// True if other reactions give an equal motion; the reactions in the margins are then one possible choice.
    pub is_one_choice: bool,
}

/// A quantity that must be positive in a regime.
#[derive(Clone, Debug, PartialEq)]
pub struct Margin {
    /// The contact or the condition, in words.
    pub of: String,
    /// The quantity, in words.
    pub asks: &'static str,
    /// Its value in `unit`.
    pub value: f64,
    /// The SI unit; empty for a condition, whose unit is that of its expression.
    pub unit: &'static str,
}

/// The number of motions from a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motions {
    One,
    /// One motion, with a margin that is zero.
    OneOnItsBoundary,
    None,
    Several,
    /// A continuum of motions, in a regime whose reactions are not determined.
    Continuum,
    /// There are too many combinations to be tried.
    NotTried,
}

/// All regimes at a state.
#[derive(Clone, Debug, PartialEq)]
pub struct Regimes {
    /// The consistent regimes.
    pub regimes: Vec<Regime>,
    /// The number of motions that continue from the state.
    pub motions: Motions,
    /// The critical friction; `None` if no factor is critical, a contact slides in space, or more than seven contacts are closed.
    pub critical: Option<CriticalFriction>,
}

/// The critical friction at a state: for smaller friction, reactions are determined for all loads.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalFriction {
    /// The factor of all coefficients of friction at which reactions cease to be determined.
    pub factor: f64,
    /// The contacts whose reactions are not determined at this factor, in words.
    pub regime: String,
}

impl Modes {
    /// The regimes at a time (s) and a state without history.
    ///
    /// # Errors
    /// [`Refused`] if the equations cannot be compiled, or the state violates a contact.
    pub fn regimes(&self, time: f64, state: &[f64]) -> Result<Regimes, Refused> {
        let expansions = self.laws.expansions().map_err(Refused::Law)?;
        let instant = Instant::at(time, state);
        let refused = |why| Refused::Motion { why, switch: self.at_zero(time, state) };
        let cases = self.cases_next(&instant).map_err(refused)?;
        if let Some(unfit) = Unfit::first(expansions, &instant, &cases) {
            return Err(Refused::Contact(unfit));
        }
        let touches = self.touches(time, state, &cases).map_err(refused)?;
        let (mode, switches) = self.cases_at(&instant, &[]).map_err(refused)?;
        let open = Open { switches: &switches, touches: &touches, at_zero: &self.laws.at_zero };
        let verdict = decided(expansions, &instant, &mode, open);
        let one = |mode: &Mode, expansion: &Expansion<TERMS>, slack: f64| match self
            .is_on_a_bound(mode, expansion, open, slack)
        {
            true => Motions::OneOnItsBoundary,
            false => Motions::One,
        };
        let motions = match &verdict {
            Decided::One { mode, expansion, slack } => one(mode, expansion, *slack),
            Decided::None { .. } => Motions::None,
            Decided::Several => Motions::Several,
            Decided::Continuum => Motions::Continuum,
            Decided::TooMany => Motions::NotTried,
            Decided::RestTogether => return Err(refused(TOGETHER)),
        };
        let all = match (agreeing(expansions, &instant, &mode, open), verdict) {
            (Some(all), _) => all,
            // for very many conditions only the regime found by pivots
            (None, Decided::One { mode, expansion, .. }) => vec![(mode, *expansion, 0)],
            (None, _) => Vec::new(),
        };
        let regime = |(mode, expansion, motion): (Mode, Expansion<TERMS>, usize)| Regime {
            name: self.laws.words.mode(&mode),
            margins: self.margins_of(&mode, &expansion, open),
            motion,
            is_one_choice: mode.phases.iter().any(|phase| matches!(phase, Phase::Leans { .. })),
        };
        let mut regimes: Vec<Regime> = Vec::new();
        for found in all.into_iter().map(regime) {
            // a sticking foot may hold itself or be held by others: both have one description
            match regimes.iter_mut().find(|known| (&known.name, known.motion) == (&found.name, found.motion)) {
                Some(known) => known.is_one_choice = true,
                None => regimes.push(found),
            }
        }
        for place in 0..regimes.len() {
            let motion = regimes[place].motion;
            let shares = |other: &Regime| other.motion == motion;
            if regimes.iter().filter(|other| shares(other)).count() > 1 {
                regimes[place].is_one_choice = true;
            }
        }
        let critical = Critical::of(expansions, &instant, &mode, &touches);
        let critical = critical
            .map(|Critical { factor, mode }| CriticalFriction { factor, regime: self.laws.words.contacts_of(&mode) });
        Ok(Regimes { regimes, motions, critical })
    }

    /// True if a margin of the mode is zero.
    fn is_on_a_bound(&self, mode: &Mode, expansion: &Expansion<TERMS>, open: Open<'_>, slack: f64) -> bool {
        let of_contacts = expansion.contacts.iter().zip(&mode.phases).filter_map(|(contact, phase)| {
            let kept = margins(contact, phase.face()?);
            let counted = if phase.sticking().is_some() { &kept[..] } else { &kept[..1] };
            Some(counted.iter().any(|margin| margin.sign_of(0, slack) == 0.0))
        });
        let of_conditions = open.switches.iter().filter(|&&switch| mode.cases[switch].rests());
        of_contacts
            .chain(
                of_conditions
                    .map(|&switch| expansion.margins(switch).iter().any(|margin| margin.sign_of(0, slack) == 0.0)),
            )
            .any(|is_zero| is_zero)
    }

    fn margins_of(&self, mode: &Mode, expansion: &Expansion<TERMS>, open: Open<'_>) -> Vec<Margin> {
        let words = &self.laws.words;
        let mut found = Vec::new();
        for &switch in open.switches {
            let condition = &expansion.conditions[switch];
            let is_away = expansion.is_direct[switch] && condition.sign_of(0, SLACKS[0]) != 0.0;
            let stays = (1..TERMS).all(|order| condition.sign_of(order, SLACKS[0]) == 0.0);
            let (asks, value) = match mode.cases[switch] {
                Case::On if is_away => ("it is positive", condition.terms[0]),
                Case::Off if is_away => ("it is negative", -condition.terms[0]),
                Case::On | Case::Off if stays => ("its expression stays at zero", 0.0),
                Case::On => (RISES[order(condition) - 1], first_rate(condition)),
                Case::Off => (FALLS[order(condition) - 1], -first_rate(condition)),
                _ => {
                    let [low, high] = expansion.margins(switch).map(|margin| margin.terms[0]);
                    ("smaller share of its two sides", low.min(high))
                }
            };
            found.push(Margin { of: words.condition(switch), asks, value, unit: "" });
        }
        for (place, (contact, (phase, touch))) in
            expansion.contacts.iter().zip(mode.phases.iter().zip(open.touches)).enumerate()
        {
            let of = || words.contact(place);
            let [force, motion] = units(words.one_way(place));
            let mut add = |asks, value, unit| found.push(Margin { of: of(), asks, value, unit });
            match phase {
                Phase::Apart if *touch == Touch::Open => {}
                Phase::Apart if *touch == Touch::AtOnce && contact.gap.sign_of(0, SLACKS[0]) != 0.0 => {
                    let [name, unit] = words.passing(place);
                    add(name, contact.gap.terms[0], unit);
                }
                Phase::Apart => add(words.leaving(place), contact.gap_rate.terms[1], motion),
                Phase::Carried => {}
                Phase::Sticks(face) | Phase::Leans { face, .. } if contact.is_in_space => {
                    let [pressure, ..] = margins(contact, *face).map(|margin| margin.terms[0]);
                    let [_, one, other] = contact.reactions.map(|reaction| reaction.terms[0]);
                    add("normal reaction |N|", pressure, force);
                    add("friction limit f|N| - |T|", contact.friction.terms[0] * pressure - one.hypot(other), force);
                }
                Phase::Glides { face, begins } => {
                    add("normal reaction |N|", margins(contact, *face)[0].terms[0], force);
                    if begins.is_some() {
                        add("acceleration of the slip", leaving(contact, *phase).terms[1], "m/s^2");
                    }
                }
                Phase::Sticks(face) | Phase::Leans { face, .. } => {
                    let [pressure, forwards, backwards] = margins(contact, *face).map(|margin| margin.terms[0]);
                    add("normal reaction |N|", pressure, force);
                    add("friction limit f|N| - T", forwards, force);
                    add("friction limit f|N| + T", backwards, force);
                }
                Phase::Slips { face, forwards } => {
                    add(words.pressure(place), margins(contact, *face)[0].terms[0], force);
                    if words.is_rough(place) && *touch == Touch::Rest {
                        let way = if *forwards { 1.0 } else { -1.0 };
                        add("acceleration of the slip", way * contact.slide.terms[1], "m/s^2");
                    }
                }
                Phase::Rests { face, .. } => add("normal reaction |N|", margins(contact, *face)[0].terms[0], force),
            }
        }
        found
    }
}

/// Every combination that is consistent with the motion it gives, with the number of this motion; none if there are too many combinations.
fn agreeing(
    expansions: &Expansions,
    instant: &Instant<'_>,
    mode: &Mode,
    open: Open<'_>,
) -> Option<Vec<(Mode, Expansion<TERMS>, usize)>> {
    let phases = combinations(expansions, instant, open)?;
    if open.switches.len() > MOST_OPEN || phases.len() * 3_usize.pow(open.switches.len() as u32) > MOST_TRIED {
        return None;
    }
    let all = Candidates::of(expansions, instant, (mode, &phases), open).all;
    let Some((slack, (best, mut agreeing))) = SLACKS.iter().find_map(|&slack| Some((slack, best(&all, open, slack)?)))
    else {
        return Some(Vec::new());
    };
    agreeing.extend(rests_beside(&all, (best, agreeing[0]), open, slack));
    let mut found: Vec<(Mode, Expansion<TERMS>, usize)> = Vec::new();
    let mut motions = 0;
    for place in agreeing {
        let (mut mode, expansion) = all[place].clone();
        mode.rest(&expansion, open, slack);
        let same = found.iter().find(|(_, known, _)| !differ(known, &expansion, slack)).map(|(.., motion)| *motion);
        let motion = same.unwrap_or_else(|| {
            motions += 1;
            motions - 1
        });
        if found.iter().all(|(known, ..)| *known != mode) {
            found.push((mode, expansion, motion));
        }
    }
    Some(found)
}

/// Sentences for the first nonzero rate of a condition at zero.
const RISES: [&str; TERMS - 1] = [
    "its rate is positive",
    "its second rate is positive",
    "its third rate is positive",
    "its fourth rate is positive",
    "its fifth rate is positive",
];
const FALLS: [&str; TERMS - 1] = [
    "its rate is negative",
    "its second rate is negative",
    "its third rate is negative",
    "its fourth rate is negative",
    "its fifth rate is negative",
];

/// The order of the first rate that exceeds its rounding error.
fn order(condition: &Jet<TERMS>) -> usize {
    (1..TERMS).find(|&order| condition.sign_of(order, SLACKS[0]) != 0.0).unwrap_or(1)
}

/// The value of the first nonzero rate.
fn first_rate(condition: &Jet<TERMS>) -> f64 {
    let order = order(condition);
    (1..=order).fold(condition.terms[order], |rate, factor| rate * factor as f64)
}

/// The units of the reaction of a contact, and of the second rate of its gap.
fn units(one_way: Option<OneWay>) -> [&'static str; 2] {
    match one_way {
        None => ["N", "m/s^2"],
        Some(OneWay::Diode) => ["V", "A/s"],
        Some(OneWay::Freewheel) => ["N m", "rad/s^2"],
    }
}
