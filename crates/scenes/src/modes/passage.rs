//! The mode in which a run begins, and the mode after an event.

use super::consistency::{Standing, alone, beyond};
use super::course::Sets;
use super::decision::{Decided, Open, SLACKS, TERMS, decided};
use super::event_error::late;
use super::expansion::{Expansion, Instant, Kind, Touching};
use super::glides::Glide;
use super::jet::Jet;
use super::mode::{Case, Mode, Phase};
use super::reasons::{CONTINUUM, JAMS, NO_LAW, NONE, NONE_AT_ONCE, SEVERAL, TOGETHER, TOO_MANY, refused};
use super::sides::{Past, Side, side};
use super::signals::Fall;
use super::touch::{Touch, margins};
use super::touches::NEGATIVE;
use super::{Current, Modes};
use integrators::{Event, Happening};

/// A determinant below this part of its initial value counts as zero.
const JAMMED: f64 = 1e-6;

/// A value counts if it exceeds this multiple of its error bound.
pub(super) const SLACK: f64 = SLACKS[0];

/// The continuation after an event.
pub(super) enum After {
    /// The law continues: for example, an expression crossed zero in a direction that does not count.
    Unchanged(Current),
    Changed(Current, Sets),
    /// The event ends the run.
    Ended,
}

impl Modes {
    /// The index of the first condition at zero.
    pub(super) fn at_zero(&self, time: f64, state: &[f64]) -> Option<usize> {
        let off = Mode::off(&self.laws.model);
        let found = self.laws.expansions().ok()?.as_given(&Instant::at(time, state), &off)?;
        found.conditions.iter().position(|condition| condition.sign_of(0, SLACK) == 0.0)
    }

    /// The mode at a state without history, such as the start.
    pub(super) fn begun(&self, time: f64, state: &[f64]) -> Result<Current, &'static str> {
        let instant = Instant::at(time, state);
        let cases = self.cases_next(&instant)?;
        let touches = self.touches(time, state, &cases)?;
        self.at(&instant, (&[], &touches), |_| Past::None)
    }

    /// The mode at a state. Conditions in `held` were held so far and may remain held. `past` tells the history of each event's
    /// expression.
    pub(super) fn at(
        &self,
        instant: &Instant<'_>,
        (held, touches): (&[usize], &[Touch]),
        past: impl Fn(usize) -> Past,
    ) -> Result<Current, &'static str> {
        let (mode, open) = self.cases_at(instant, held)?;
        self.settled(instant, &mode, Open { switches: &open, touches, at_zero: &self.laws.at_zero }, past)
    }

    /// The cases of conditions just after a state. For a condition at zero its rate decides, if the rate does not depend on cases.
    pub(super) fn cases_next(&self, instant: &Instant<'_>) -> Result<Vec<Case>, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let (mut mode, open) = self.cases_at(instant, &[])?;
        let found = expansions.at::<2>(instant, &mode);
        for switch in open {
            if found.as_ref().is_some_and(|found| found.conditions[switch].sign_of(1, SLACK) > 0.0) {
                mode.cases[switch] = Case::On;
            }
        }
        expansions.mirror(&mut mode);
        Ok(mode.cases)
    }

    /// The cases of conditions at a state, and the indices of the open conditions: at zero, or held so far.
    pub(super) fn cases_at(&self, instant: &Instant<'_>, held: &[usize]) -> Result<(Mode, Vec<usize>), &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let mut mode = Mode::off(&self.laws.model);
        let mut open = Vec::new();
        // a condition may depend on the cases of earlier conditions
        for switch in 0..mode.cases.len() {
            let Some(Expansion { conditions, .. }) = expansions.as_given(instant, &mode) else { return Err(NO_LAW) };
            let sign = conditions[switch].sign_of(0, SLACK);
            mode.cases[switch] = if sign > 0.0 { Case::On } else { Case::Off };
            let is_open = sign == 0.0 || held.contains(&switch) || expansions.direct_conditions[switch];
            if expansions.mirrored[switch].is_none() && is_open {
                open.push(switch);
            }
            expansions.mirror(&mut mode);
        }
        Ok((mode, open))
    }

    /// Conditions that jump because another condition crossed zero; for example, a change of the law may change the speed of a support.
    /// They get the case of the side to which they jump, and their indices are returned.
    fn jumped(
        &self,
        instant: &Instant<'_>,
        mode: &mut Mode,
        known: &Expansion<TERMS>,
        passed: usize,
    ) -> Result<Vec<usize>, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let Some(now) = expansions.as_given(instant, mode) else { return Ok(Vec::new()) };
        let jumps = |switch: &usize| {
            let (now, before) = (&now.conditions[*switch], &known.conditions[*switch]);
            let rounding = SLACK * (now.doubts[0] + before.doubts[0]);
            *switch != passed && (now.terms[0] - before.terms[0]).abs() > rounding
        };
        let own = |switch: &usize| expansions.mirrored[*switch].is_none() && !expansions.direct_conditions[*switch];
        let jumped: Vec<usize> = (0..mode.cases.len()).filter(own).filter(jumps).collect();
        for &switch in &jumped {
            mode.cases[switch] = if now.conditions[switch].terms[0] > 0.0 { Case::On } else { Case::Off };
        }
        expansions.mirror(mode);
        Ok(jumped)
    }

    /// The continuation after an event, which may change the state.
    ///
    /// # Errors
    /// No single motion continues; the text is the reason.
    pub(super) fn after(&self, before: &Current, event: &Event, state: &mut [f64]) -> Result<After, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let mut mode = before.moded.system.mode.clone();
        let mut fall = before.moded.signals.falls[event.signal];
        expansions.return_to_zero(event.time, state, &mode, SLACK);
        let exact = Instant::at(event.time, state);
        // at the end of a slide, reactions and the times of their signals have no correct digits: the slide must stop first
        let over = match fall {
            Fall::Lifts { .. } | Fall::Slides { .. } | Fall::Jams => self.is_over(before, &exact),
            _ => None,
        };
        // direction and reactions of a contact in space that has slowed down have few correct digits; nothing here depends on them
        let seen = match fall.is_of_a_glide() || over.is_some() {
            true => mode.clone().without_glides(),
            false => mode.clone(),
        };
        let Some(known) = expansions.at::<TERMS>(&exact, &seen) else {
            // a long step may end beyond the jamming
            return Err(if self.jams(before, event.time, state) { JAMS } else { NO_LAW });
        };
        // after a condition has touched zero, the law continues if it leads away from zero
        if let (Fall::Passes { switch }, Happening::Touches) = (fall, event.what)
            && alone(&known, mode.cases[switch], switch, SLACK) == Some(Standing::Moves)
        {
            let condition = &known.conditions[switch];
            let mut current = before.clone();
            current.near[switch] = (SLACK * condition.doubts[0]).max(condition.hidden(SLACK));
            return Ok(After::Unchanged(current));
        }
        let late = if over.is_some() { 0.0 } else { late(before, &known, event) };
        fall = over.map_or(fall, |contact| Fall::Stops { contact });
        let rates: Vec<f64> = match expansions.has_algebraic() {
            true => known.rates.iter().map(|rate| rate.terms[0]).collect(),
            false => Vec::new(),
        };
        let is_near = |found: &Expansion<TERMS>, switch: usize| {
            let condition = &found.conditions[switch];
            condition.terms[0].abs() <= before.near[switch].max(SLACK * condition.doubts[0])
        };
        let own = |switch: &usize| expansions.mirrored[*switch].is_none();
        let cases = mode.cases.len();
        let mut held: Vec<usize> = (0..cases).filter(own).filter(|&switch| mode.cases[switch].rests()).collect();
        let keeps = |other: usize| match before.sides[other] {
            Side { is_open: true, .. } => Past::None,
            Side { sign: from, .. } if expansions.has_algebraic() => {
                Past::Jumping { from, near: before.near_events[other] }
            }
            Side { sign: from, .. } => Past::Side { from, near: before.near_events[other] },
        };
        let last = match fall {
            Fall::Event { event: number } => {
                return self.after_own(before, (number, late), event, state, (&known, &held));
            }
            // a condition that touches zero has not crossed it
            Fall::Passes { switch } if event.what == Happening::Touches => Some(switch),
            Fall::Passes { switch } => {
                mode.cases[switch] = if mode.cases[switch] == Case::On { Case::Off } else { Case::On };
                Some(switch)
            }
            Fall::Leaves { switch, to } => {
                mode.cases[switch] = to;
                Some(switch)
            }
            Fall::Frees { switch } => Some(switch),
            Fall::Jams => return Err(JAMS),
            Fall::Smooths { .. } => return Err(NEGATIVE),
            Fall::Slows { contact } | Fall::Hastens { contact } | Fall::Turns { contact } => {
                let next = before.glides[contact].and_then(|glide| glide.next(&known.contacts[contact], fall));
                if next.is_some() {
                    let mut current = before.clone();
                    current.glides[contact] = next;
                    return Ok(After::Unchanged(current));
                }
                fall = Fall::Stops { contact };
                None
            }
            Fall::Closes { .. } | Fall::Lifts { .. } | Fall::Slides { .. } | Fall::Stops { .. } => None,
        };
        expansions.mirror(&mut mode);
        let cases = &before.moded.system.mode.cases;
        let together = self.rest_together(before, event, state);
        let (mut touches, sets) = self.touches_after((cases, &mode), fall, (event.time, late), state)?;
        self.bring_to_rest(&mode, &together, event.time, state, &mut touches);
        // the gap of a closed contact is set to zero: the error of the time has no effect
        let late = match fall {
            Fall::Closes { contact } if !expansions.kinds[contact].is_direct => 0.0,
            _ => late,
        };
        let jumped = match fall {
            Fall::Passes { switch } if event.what != Happening::Touches => {
                self.jumped(&Instant::at(event.time, state), &mut mode, &known, switch)?
            }
            _ => Vec::new(),
        };
        held.retain(|switch| !jumped.contains(switch));
        let is_open = |switch: &usize| {
            let is_direct = expansions.direct_conditions[*switch];
            let may_rest = held.contains(switch) || Some(*switch) == last || is_near(&known, *switch);
            !jumped.contains(switch) && (may_rest || is_direct)
        };
        let open: Vec<usize> = (0..mode.cases.len()).filter(own).filter(is_open).collect();
        expansions.mirror(&mut mode);
        let instant = Instant { late, before: &rates, ..Instant::at(event.time, state) };
        let current = self.settled(
            &instant,
            &mode,
            Open { switches: &open, touches: &touches, at_zero: &self.laws.at_zero },
            keeps,
        );
        let current = match current {
            Ok(current) => current,
            // near jamming, rounding decides which condition fails first
            Err(NONE | NONE_AT_ONCE | SEVERAL) if self.jams(before, event.time, state) => return Err(JAMS),
            Err(why) => return Err(why),
        };
        // a condition that has touched zero continues as before the event
        if matches!(fall, Fall::Passes { .. }) && current.moded.system.mode == before.moded.system.mode {
            current.moded.system.set_algebraic_speeds(event.time, state);
            return Ok(After::Unchanged(current));
        }
        // residuals of held conditions and sticking contacts are set to exactly zero
        expansions.return_to_zero(event.time, state, &current.moded.system.mode, 0.0);
        current.moded.system.set_algebraic_speeds(event.time, state);
        self.push_off(event.time, state, &current);
        let rests = match fall {
            Fall::Stops { contact } => before.glides[contact].map(|glide| glide.rest(contact)),
            _ => None,
        };
        Ok(After::Changed(current, rests.unwrap_or(sets)))
    }

    /// True if the determinant of the equations for the reactions has decreased to zero since the law began (jamming).
    pub(super) fn jams(&self, current: &Current, time: f64, state: &[f64]) -> bool {
        let mode = &current.moded.system.mode;
        let instant = Instant::at(time, state);
        mode.phases.iter().any(|phase| phase.has_friction())
            && self.laws.expansions().is_ok_and(|expansions| {
                expansions.determinant(&instant, mode) * current.determinant.signum()
                    < JAMMED * current.determinant.abs()
            })
    }

    /// The only consistent mode, with the tolerances of its signals. Open conditions and contacts are decided, the others keep the case
    /// that they have in `mode`.
    fn settled(
        &self,
        instant: &Instant<'_>,
        mode: &Mode,
        open: Open<'_>,
        past: impl Fn(usize) -> Past,
    ) -> Result<Current, &'static str> {
        let expansions = self.laws.expansions().map_err(refused)?;
        let (mode, expansion, slack) = match decided(expansions, instant, mode, open) {
            Decided::One { mode, expansion, slack } => (mode, expansion, slack),
            Decided::None { not_held } => {
                return Err(match not_held {
                    true => NO_LAW,
                    false if expansions.has_algebraic() => NONE_AT_ONCE,
                    false => NONE,
                });
            }
            Decided::Several => return Err(SEVERAL),
            Decided::Continuum => return Err(CONTINUUM),
            Decided::TooMany => return Err(TOO_MANY),
            Decided::RestTogether => return Err(TOGETHER),
        };
        let rounding = |jet: &Jet<TERMS>| if jet.sign_of(0, slack) == 0.0 { slack * jet.doubts[0] } else { 0.0 };
        let near = |switch: usize| {
            let condition = &expansion.conditions[switch];
            let beyond = beyond(condition.terms[0], mode.cases[switch]);
            let rounding = (slack * condition.doubts[0]).max(condition.hidden(slack));
            let near = (2.0 * beyond).max(rounding);
            // a direct condition is open at any value
            if condition.terms[0].abs() <= near && open.switches.contains(&switch) { near } else { 0.0 }
        };
        // a quantity with algebraic speeds may leave zero more slowly than its terms suggest
        let left =
            |jet: &Jet<TERMS>, is_direct: bool| rounding(jet).max(if is_direct { jet.hidden(slack) } else { 0.0 });
        let near_contact = |((phase, contact), kind): ((&Phase, &Touching<TERMS>), &Kind)| {
            let below = |jet: &Jet<TERMS>| (-2.0 * jet.terms[0]).max(rounding(jet)).max(0.0);
            match *phase {
                // a large gap needs no tolerance
                Phase::Apart => [below(&contact.gap).max(left(&contact.gap, kind.is_direct)), 0.0, 0.0],
                Phase::Carried => [0.0; 3],
                Phase::Sticks(face) | Phase::Leans { face, .. } => margins(contact, face).each_ref().map(rounding),
                Phase::Rests { face, .. } | Phase::Glides { face, .. } => {
                    [rounding(&margins(contact, face)[0]), 0.0, 0.0]
                }
                Phase::Slips { face, forwards } => {
                    let way = if forwards { 1.0 } else { -1.0 };
                    let slide = Jet::constant(way, 0.0) * contact.slide;
                    let begins = slide.terms[0] <= slack * slide.doubts[0];
                    let near = if begins { below(&slide).max(slide.hidden(slack)) } else { 0.0 };
                    [left(&margins(contact, face)[0], kind.is_direct), near, 0.0]
                }
            }
        };
        let begun = |event: usize| {
            let (past, jet) = (past(event), &expansion.events[event]);
            let side = side(jet, past, slack);
            let is_zero = jet.sign_of(0, slack) == 0.0;
            let beyond = (-2.0 * side.sign * jet.terms[0]).max(0.0);
            let near = match past {
                Past::None if !side.is_open => rounding(jet),
                // a body that an event sets to rest on a wall remains there if the expression is zero up to rounding
                Past::Set { near, .. } if jet.way(0.0, slack) == 0.0 => near.max(beyond).max(rounding(jet)),
                Past::Set { near, .. } if is_zero => near,
                Past::Side { near, .. } | Past::Jumping { near, .. } if is_zero => near.max(beyond),
                _ => 0.0,
            };
            (side, near)
        };
        let phases = mode.phases.iter().zip(&expansion.contacts);
        let (sides, near_events) = (0..self.laws.model.events.len()).map(begun).unzip();
        Ok(Current {
            moded: self.laws.moded(&mode.clone().without_headings()).map_err(refused)?,
            sides,
            glides: Glide::of_all(&expansion.contacts, &mode.phases, instant.time),
            determinant: expansions.determinant(instant, &mode),
            near_contacts: phases.zip(&expansions.kinds).map(near_contact).collect(),
            near: (0..mode.cases.len()).map(near).collect(),
            near_bounds: (0..mode.cases.len())
                .map(|switch| expansion.margins(switch).each_ref().map(|jet| left(jet, expansion.is_direct[switch])))
                .collect(),
            near_events,
        })
    }
}
