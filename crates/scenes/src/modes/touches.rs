//! The state of contacts at the start of a run and after events: open, at rest or sliding. Impacts change the speeds.

use super::Modes;
use super::accumulation::Impact;
use super::course::Sets;
use super::decision::TERMS;
use super::expansion::{Instant, Kind, NotStruck, Touching};
use super::headings::held;
use super::jet::Jet;
use super::mode::{Case, Face, Mode, Phase};
use super::passage::SLACK;
use super::reasons::refused;
use super::signals::Fall;
use super::touch::Touch;
use super::unfit::{RESTITUTION, Unfit};

const TOGETHER: &str = "an impact presses other contacts in touch: the impulses of several at once are not determined by these laws; Moreau's law has them, \
     `impact = \"moreau\"` and `restitution` at each of these contacts";
const BEYOND_MOREAU: &str = "an impact of several contacts at once, of which Moreau's law has not all: each needs `impact = \"moreau\"`, in space \
                             none may have friction, and no guide; and no more than six with friction";
const IMPULSES: &str =
    "an impact is not determined: no impulse within the cone of friction, or several, by this law of restitution";
const ENERGY: &str =
    "an impact would add energy: the laws of restitution and of friction contradict each other here (Kane 1984)";
const TURNS: &str =
    "an impact with friction in space would turn the direction of sliding, which its laws do not follow";
pub(crate) const NEGATIVE: &str = "a coefficient of friction is negative";

impl Modes {
    /// The states of all contacts at a time (s) and a state without history.
    pub(super) fn touches(&self, time: f64, state: &[f64], cases: &[Case]) -> Result<Vec<Touch>, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let instant = Instant::at(time, state);
        if let Some(Unfit { why, .. }) = Unfit::first(expansions, &instant, cases) {
            return Err(why);
        }
        let of = |(contact, kind): (Touching<1>, &Kind)| match [contact.gap, contact.gap_rate]
            .map(|jet| jet.sign_of(0, SLACK))
        {
            _ if kind.is_direct => Touch::AtOnce,
            [0.0, 0.0] => touching(&contact),
            _ => Touch::Open,
        };
        Ok(expansions.contacts(&instant, cases).into_iter().zip(&expansions.kinds).map(of).collect())
    }

    /// The states of all contacts after an event, and the kind of change of the state, which an impact changes in place. `before` are the
    /// cases before the event, `mode` has the phases before and the cases after, `late` is the error of the time (s).
    pub(super) fn touches_after(
        &self,
        (before, mode): (&[Case], &Mode),
        fall: Fall,
        (time, late): (f64, f64),
        state: &mut [f64],
    ) -> Result<(Vec<Touch>, Sets), &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let mut sets = Sets::Nothing;
        let phases = &mode.phases;
        if let Fall::Stops { contact } = fall
            && let Some(face) = phases[contact].face()
        {
            let stopped = if expansions.kinds[contact].is_in_space {
                held(expansions, &Instant::at(time, state), mode, &[(contact, face)])
            } else {
                let mut stopped = mode.clone();
                stopped.phases[contact] = Phase::Sticks(face);
                Some(stopped)
            };
            if let Some(stopped) = stopped {
                expansions.return_to_zero(time, state, &stopped, 0.0);
            }
        }
        let closing = match fall {
            Fall::Closes { contact } => Some(contact),
            _ => None,
        };
        let known = match fall {
            Fall::Passes { .. } => expansions.contacts(&Instant::at(time, state), before),
            _ => Vec::new(),
        };
        let [mut opened, mut struck, mut stay, mut stick, mut ended] = [const { Vec::new() }; 5];
        let approaches = |contact: &Touching<1>| contact.gap_rate.sign_of(0, SLACK) < 0.0;
        if let Some(contact) = closing {
            match expansions.kinds[contact].is_one_way {
                true if expansions.kinds[contact].is_direct => {}
                true => {
                    let mut blocked = mode.clone();
                    blocked.phases[contact] = Phase::Slips { forwards: true, face: Face::Front };
                    expansions.return_to_zero(time, state, &blocked, 0.0);
                }
                // the others in touch too: a rest of their gaps would grow into the next flight of a body that rocks
                false => {
                    let closed = expansions.in_touch(mode).into_iter().filter(|other| *other != contact);
                    expansions.close_gaps(time, state, &[contact].into_iter().chain(closed).collect::<Vec<_>>());
                }
            }
        }
        if let Some(contact) = closing
            && !expansions.kinds[contact].is_one_way
            && approaches(&expansions.contacts(&Instant { late, ..Instant::at(time, state) }, &mode.cases)[contact])
        {
            let in_touch: Vec<usize> = (0..phases.len()).filter(|&other| phases[other] != Phase::Apart).collect();
            let falling = expansions.contacts(&Instant { late, ..Instant::at(time, state) }, &mode.cases);
            let closes = |other: usize| falling[other].gap.sign_of(0, SLACK) == 0.0 && approaches(&falling[other]);
            let is_one_of_several =
                (0..phases.len()).any(|other| other != contact && phases[other] == Phase::Apart && closes(other));
            let shares = expansions.shares_impacts(contact);
            let why = |why: NotStruck| match why {
                NotStruck::Restitution => RESTITUTION,
                NotStruck::Friction => NEGATIVE,
                NotStruck::Together if shares => BEYOND_MOREAU,
                _ if is_one_of_several && !shares => TOGETHER,
                NotStruck::Together => TOGETHER,
                NotStruck::Undetermined => IMPULSES,
                NotStruck::AddsEnergy => ENERGY,
                NotStruck::Turns => TURNS,
            };
            if shares {
                let instant = Instant { late, ..Instant::at(time, state) };
                let [together, others] = expansions.partners(&instant, mode, contact, SLACK);
                expansions.close_gaps(time, state, &[together.clone(), expansions.in_touch(mode)].concat());
                let instant = Instant { late, ..Instant::at(time, state) };
                let after = expansions.struck_together(&instant, (&together, &others), &mode.cases).map_err(why)?;
                state.copy_from_slice(&after.state);
                (struck, opened, stay, stick) = (together, after.opened, after.stay, after.stick);
            } else {
                struck = vec![contact];
                opened = expansions.struck(time, state, (contact, &mode.cases), &in_touch).map_err(why)?;
            }
            let after = expansions.contacts(&Instant { late, ..Instant::at(time, state) }, &mode.cases);
            let turned =
                |(kind, contact): (&Kind, &Touching<1>)| kind.is_one_way && !kind.is_direct && approaches(contact);
            if expansions.kinds.iter().zip(&after).any(turned) {
                return Err(TOGETHER);
            }
            sets = Sets::Impact(contact);
            let impact = Impact { struck: &struck, opened: &opened, stay: &stay, stick: &stick };
            ended = self.accumulated(mode, impact, (time, state))?;
            if !ended.is_empty() {
                sets = Sets::LastBounce;
                opened.retain(|contact| !ended.contains(contact));
            }
        }
        let jumps = |place: usize, now: &Touching<1>| {
            let differ = |now: Jet<1>, before: Jet<1>| (now - before).sign_of(0, SLACK) != 0.0;
            known.get(place).is_some_and(|before| differ(now.slide, before.slide) || differ(now.aside, before.aside))
        };
        let of = |(place, (contact, phase)): (usize, (Touching<1>, &Phase))| match *phase {
            _ if expansions.kinds[place].is_direct => Touch::AtOnce,
            // other diodes with an equal current
            Phase::Apart if expansions.kinds[place].is_one_way && contact.gap.sign_of(0, SLACK) == 0.0 => {
                touching(&contact)
            }
            Phase::Apart if Some(place) != closing && !struck.contains(&place) => Touch::Open,
            Phase::Apart if expansions.kinds[place].is_one_way => touching(&contact),
            // rounding leaves a remainder of the velocities that an impact sets to zero
            _ if stick.contains(&place) && (stay.contains(&place) || ended.contains(&place)) => Touch::Rest,
            Phase::Apart if stay.contains(&place) => touching(&contact),
            Phase::Apart if contact.gap_rate.sign_of(0, SLACK) > 0.0 => Touch::Open,
            Phase::Apart => touching(&contact),
            // the impact at another contact has opened this one
            _ if opened.contains(&place) => Touch::Open,
            // an impact may reverse the sliding of other contacts
            _ if closing.is_some() => touching(&contact),
            Phase::Carried => touching(&contact),
            // a condition may change the velocity of a plane discontinuously
            _ if jumps(place, &contact) => touching(&contact),
            Phase::Sticks(_) | Phase::Leans { .. } | Phase::Rests { .. } => Touch::Rest,
            Phase::Glides { .. } if matches!(fall, Fall::Stops { contact } if contact == place) => Touch::Rest,
            Phase::Glides { .. } => touching(&contact),
            Phase::Slips { .. } if matches!(fall, Fall::Stops { contact } if contact == place) => Touch::Rest,
            Phase::Slips { forwards, .. } => match touching(&contact) {
                Touch::Rest => Touch::Rest,
                _ => Touch::Slides { forwards },
            },
        };
        let contacts = expansions.contacts(&Instant { late, ..Instant::at(time, state) }, &mode.cases);
        Ok((contacts.into_iter().zip(phases).enumerate().map(of).collect(), sets))
    }

    /// The touch of the contacts after an event has set the state: contacts that it did not change remain in touch.
    pub(super) fn touches_set(
        &self,
        Mode { phases, cases }: &Mode,
        before: &[Touching<TERMS>],
        time: f64,
        state: &[f64],
    ) -> Result<Vec<Touch>, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let stays = |now: &Jet<1>, before: &Jet<TERMS>| {
            (now.terms[0] - before.terms[0]).abs() <= SLACK * (now.doubts[0] + before.doubts[0])
        };
        let now = expansions.contacts(&Instant::at(time, state), cases);
        let all = now.iter().zip(before).zip(phases).zip(&expansions.kinds);
        let kept = all.map(|(((now, before), phase), kind)| {
            let stays = stays(&now.gap, &before.gap) && stays(&now.gap_rate, &before.gap_rate);
            (stays && !kind.is_direct && *phase != Phase::Apart).then(|| touching(now))
        });
        let kept: Vec<Option<Touch>> = kept.collect();
        if kept.iter().all(Option::is_some) {
            return Ok(kept.into_iter().flatten().collect());
        }
        let given = self.touches(time, state, cases)?;
        Ok(kept.into_iter().zip(given).map(|(kept, given)| kept.unwrap_or(given)).collect())
    }
}

/// The state of a closed contact by its sliding velocity: at rest or sliding.
fn touching(contact: &Touching<1>) -> Touch {
    match [contact.slide, contact.aside].map(|part| part.sign_of(0, SLACK)) {
        [0.0, 0.0] => Touch::Rest,
        [along, _] => Touch::Slides { forwards: along > 0.0 },
    }
}
