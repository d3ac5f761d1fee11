//! The motion after an event declared in the model.

use super::course::Sets;
use super::decision::TERMS;
use super::expansion::{Expansion, Instant};
use super::mode::Mode;
use super::passage::{After, SLACK};
use super::reasons::{BROKEN, refused};
use super::sides::{Past, Side, side};
use super::signals::Fall;
use super::{Current, Modes};
use integrators::{Event, Happening};
use model::Direction;
use simulation::events::Cause;

impl Modes {
    /// The continuation after event `number` of the model. `late` is the error of its time (s), `known` the motion at this time in the
    /// previous law, `held` the conditions that this law holds at zero.
    ///
    /// # Errors
    /// No single motion continues, or the event violates a constraint.
    pub(super) fn after_own(
        &self,
        before: &Current,
        (number, late): (usize, f64),
        event: &Event,
        state: &mut [f64],
        (known, held): (&Expansion<TERMS>, &[usize]),
    ) -> Result<After, &'static str> {
        let Side { sign: from, is_open } = before.sides[number];
        let with_side = |side: Side| {
            let mut current = before.clone();
            (current.sides[number], current.near_events[number]) = (side, 0.0);
            Ok(After::Unchanged(current))
        };
        if is_open && event.what == Happening::StartsBelow {
            return with_side(Side { sign: -from, is_open: false });
        }
        // an expression that has not left zero since the event set the state does not cross zero again
        let rate = before.moded.signals.event_rate(number, event.time, state, &before.glide_letters());
        let has_jumped = event.what == Happening::StartsBelow && known.events[number].sign_of(0, SLACK) == -from;
        if rate * from > 0.0 && !has_jumped {
            return Ok(After::Unchanged(before.clone()));
        }
        let counts = |number: usize, from: f64| match self.laws.model.events[number].direction {
            Direction::Down => from > 0.0,
            Direction::Up => from < 0.0,
            Direction::Both => true,
        };
        let is_counted = counts(number, from);
        if !is_counted && has_jumped {
            return with_side(Side { sign: -from, is_open: false });
        }
        if !is_counted {
            return with_side(side(&known.events[number], Past::Passed(from), SLACK));
        }
        let mut set = before.moded.signals.set_by(number, event.time, state, &before.glide_letters());
        if self.laws.model.events[number].ends {
            state.copy_from_slice(&set);
            return Ok(After::Ended);
        }
        let kept = self.laws.kept();
        kept.follow(event.time, &mut set);
        // the state before the event remains the last valid one
        if let Some(broken) = kept.broken(event.time, &set) {
            let name = self.laws.words.fall(Fall::Event { event: number });
            let what = format!("after {name} {broken}, which must be zero");
            self.tell((event.time, state), (Cause::Own, what), (&before.moded.system, false));
            return Err(BROKEN);
        }
        state.copy_from_slice(&set);
        let expansions = self.laws.expansions().map_err(refused)?;
        let instant = Instant { late, ..Instant::at(event.time, state) };
        // a held condition may remain held if the event has not changed it
        let now = expansions.as_given(&instant, &Mode::off(&self.laws.model));
        let stays = |switch: &usize| {
            now.as_ref().is_some_and(|now| {
                let (now, before) = (&now.conditions[*switch], &known.conditions[*switch]);
                (now.terms[0] - before.terms[0]).abs() <= SLACK * (now.doubts[0] + before.doubts[0])
            })
        };
        let held: Vec<usize> = held.iter().copied().filter(stays).collect();
        let past = |other: usize| match before.sides[other] {
            Side { sign: from, .. } if other == number => Past::Set { from, near: before.near_events[other] },
            Side { sign: from, is_open: false } if known.events[other].sign_of(0, SLACK) == 0.0 => {
                // an expression that crosses zero here in the direction that does not count has crossed it, whatever state the event sets
                let jet = &known.events[other];
                let has_passed = jet.way(SLACK * jet.doubts[0], SLACK) == -from && !counts(other, from);
                Past::Side { from: if has_passed { -from } else { from }, near: before.near_events[other] }
            }
            _ => Past::None,
        };
        let phases = &before.moded.system.mode.phases;
        let cases = self.cases_at(&instant, &held)?.0.cases;
        let now = Mode { cases, phases: phases.clone() };
        let touches = self.touches_set(&now, &known.contacts, event.time, state)?;
        let current = self.at(&instant, (&held, &touches), past)?;
        current.moded.system.set_algebraic_speeds(event.time, state);
        Ok(After::Changed(current, Sets::Event(number)))
    }
}
