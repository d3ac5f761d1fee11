//! Reference runs in double-double arithmetic along the sequence of laws of a run in `f64`.

use super::course::{Crossing, Leg, RunTable, Sets};
use super::expansion::Instant;
use super::passage::SLACK;
use super::signals::{Fall, GLIDE};
use super::slowed::Slowed;
use super::{Laws, Moded, Modes};
use field::{DoubleDouble, Over};
use integrators::{Happening, Ode, Real};
use num_traits::Zero;
use simulation::references::{At, Followed, Means, Unknown};
use std::sync::PoisonError;

/// The largest number of Newton steps. Each doubles the number of correct digits: from the thirteen digits of a run one step reaches full
/// precision, and the next confirms it.
const MOST: usize = 8;
const BEGINS: &str = "a contact begins to slide in space, which is not followed to all digits,";

/// Each step to the rest of a contact that slides in space covers this fraction of the remaining time, until the relative speed is below
/// the second constant.
const SLOWS: f64 = 0.9;
const LEFT: f64 = 1e-14;

/// The contact must come to rest within this multiple of the time of its slide.
const BEYOND: f64 = 2.0;

/// A determinant below this part of its initial value counts as zero. It decreases like exp(-s^2) with the slowed time s, whose length is
/// doubled at each step.
const VANISHED: f64 = 1e-31;
const DOUBLINGS: usize = 40;

/// A correction of the time below this part of the time ends the iteration.
const LAST: f64 = 1e-20;

impl Modes {
    /// The laws of the last run.
    pub fn course(&self) -> RunTable {
        RunTable { legs: self.course.lock().unwrap_or_else(PoisonError::into_inner).clone() }
    }

    /// The states at `instants` (s) and at events, by one method along the sequence of laws `course`.
    ///
    /// # Errors
    /// The method fails, or the time of an event is undetermined because several signals are zero together.
    pub fn exactly(
        &self,
        course: &RunTable,
        start: &[f64],
        instants: &[f64],
        means: Means,
    ) -> Result<(Followed, Means), Unknown> {
        let state = start.iter().map(|part| DoubleDouble::lift(*part)).collect();
        Follower { laws: &self.laws, means, at: (DoubleDouble::zero(), state) }.follow(course, instants)
    }
}

impl RunTable {
    /// The rates y' by the law that is valid at a time (s).
    pub fn rates_at(&self, time: f64, state: &[DoubleDouble], rates: &mut [DoubleDouble]) {
        let has_begun = |leg: &&Leg| leg.cause.is_none_or(|cause| cause.time <= time);
        if let Some(leg) = self.legs.iter().take_while(has_begun).last() {
            leg.moded.system.rates(DoubleDouble::lift(time), state, rates);
        }
    }
}

/// The state of a reference run.
struct Follower<'a> {
    laws: &'a Laws,
    means: Means,
    at: At,
}

impl Follower<'_> {
    fn follow(mut self, course: &RunTable, instants: &[f64]) -> Result<(Followed, Means), Unknown> {
        let (mut states, mut events, mut left) = (Vec::new(), Vec::new(), instants);
        for (place, leg) in course.legs.iter().enumerate() {
            if leg.begins_to_glide {
                let time = leg.cause.map_or(0.0, |cause| cause.time);
                return Err(Unknown::Ends(format!("{BEGINS} at t = {time} s")));
            }
            leg.moded.system.set_algebraic_speeds(self.at.0, &mut self.at.1);
            let next = course.legs.get(place + 1).and_then(|next| next.cause);
            let within = left.iter().take_while(|instant| next.is_none_or(|next| **instant < next.time)).count();
            for &instant in &left[..within] {
                self.go_to(&leg.moded, DoubleDouble::lift(instant))?;
                states.push(self.at.1.clone());
            }
            left = &left[within..];
            if let Some(next) = next {
                match next.sets {
                    Sets::Jam => self.jam(leg, next.time)?,
                    Sets::Rest { contact, fastest } => {
                        let then = &course.legs[place + 1].moded;
                        self.rest(leg, (contact, fastest), (next.time, then))?;
                    }
                    _ => self.pass(leg, next)?,
                }
                if let Some(after) = course.legs.get(place + 1) {
                    after.moded.system.set_algebraic_speeds(self.at.0, &mut self.at.1);
                }
                if next.sets != Sets::Unseen {
                    events.push(self.at.clone());
                }
            }
        }
        Ok((Followed { states, events }, self.means))
    }

    /// Integrates with a law to a time.
    fn go_to(&mut self, moded: &Moded, time: DoubleDouble) -> Result<(), Unknown> {
        let (from, state) = &mut self.at;
        let bounds = moded.law.step_bounds(from.hi(), time.hi());
        *state = self.means.flow((&*moded.system, &bounds), [*from, time], state)?;
        *from = time;
        Ok(())
    }

    /// Integrates to an event, and applies its change of the state.
    fn pass(&mut self, leg: &Leg, crossing: Crossing) -> Result<(), Unknown> {
        let Leg { moded, glides, .. } = leg;
        let blunt = || Unknown::Blunt { time: crossing.time };
        if crossing.what == Happening::Falls {
            self.zero_of(leg, crossing)?;
        }
        let (time, state) = &mut self.at;
        match crossing.sets {
            Sets::Nothing | Sets::Unseen | Sets::End | Sets::Jam => {}
            Sets::Event(event) => *state = moded.signals.set_by(event, *time, state, glides),
            Sets::Impact(contact) => {
                let expansions = self.laws.expansions().map_err(|_| blunt())?;
                let mode = &moded.system.mode;
                let after = if expansions.shares_impacts(contact) {
                    let rounded: Vec<f64> = state.iter().map(|part| part.hi()).collect();
                    let partners = expansions.partners(&Instant::at(time.hi(), &rounded), mode, contact, SLACK);
                    expansions.struck_together_exactly(*time, state, (&partners.concat(), &mode.cases))
                } else {
                    expansions.struck_exactly(*time, state, (contact, &mode.cases))
                };
                *state = after.ok_or_else(blunt)?;
            }
            Sets::Rest { .. } => {}
            Sets::LastBounce => return Err(Unknown::LastBounce { time: crossing.time }),
        }
        Ok(())
    }

    /// Integrates until the equations for the reactions become singular: speeds are unbounded there, positions are finite.
    fn jam(&mut self, Leg { moded, .. }: &Leg, told: f64) -> Result<(), Unknown> {
        let blunt = || Unknown::Blunt { time: told };
        let slowed = Slowed::of(&self.laws.model, &moded.system.mode).ok_or_else(blunt)?;
        let (time, state) = &self.at;
        let mut both = [&state[..], &[*time]].concat();
        let first = slowed.determinant(&both).approx();
        let mut length = (told - time.approx()) / first;
        for _ in 0..DOUBLINGS {
            both = self.means.run(&slowed, length, &both, &[told])?;
            if slowed.determinant(&both).approx() / first <= VANISHED {
                let time = both.pop().ok_or_else(blunt)?;
                both.truncate(self.laws.model.positions());
                self.at = (time, both);
                return Ok(());
            }
            length *= 2.0;
        }
        Err(blunt())
    }

    /// Integrates until the relative sliding speed of a contact in space is rounding error, then sets it to zero.
    fn rest(
        &mut self,
        Leg { moded, glides, .. }: &Leg,
        (contact, fastest): (usize, f64),
        (told, then): (f64, &Moded),
    ) -> Result<(), Unknown> {
        let blunt = Unknown::Blunt { time: told };
        let signals = &moded.signals;
        let Some(signal) = signals.falls.iter().position(|fall| *fall == Fall::Slows { contact }) else {
            return Err(blunt);
        };
        let place = signals.in_space.iter().position(|own| *own == contact).unwrap_or(0);
        let slow = DoubleDouble::lift(glides[GLIDE * place + 2]);
        // stops shortly before the event of the run, where the speed decreases linearly
        let begun = self.at.0;
        let last = begun + (DoubleDouble::lift(told) - begun) * DoubleDouble::lift(BEYOND);
        self.go_to(moded, begun + (DoubleDouble::lift(told) - begun) * DoubleDouble::lift(SLOWS))?;
        let speed = |at: &At| {
            let [beyond, rate] = signals.of_one(signal, at.0, &at.1, glides);
            (beyond + slow, rate)
        };
        let (mut left, rate) = speed(&self.at);
        let mut fall = -rate;
        while left.approx() > LEFT * fastest {
            let (time, known) = (self.at.0, left);
            let next = time + left / fall * DoubleDouble::lift(SLOWS);
            if fall.approx() <= 0.0 || !next.finite() || next.approx() > last.approx() {
                return Err(blunt);
            }
            self.go_to(moded, next)?;
            left = speed(&self.at).0;
            if left.approx().is_nan() || left.approx() > 0.5 * known.approx() {
                return Err(blunt);
            }
            // rate by a difference quotient: the direction, and so the rate, of a small velocity has few correct digits
            fall = (known - left) / (next - time);
        }
        let expansions = self.laws.expansions().map_err(|_| Unknown::Blunt { time: told })?;
        let (time, state) = &mut self.at;
        *state = expansions.rested_exactly(*time, state, &then.system.mode).ok_or(blunt)?;
        // the remaining time, with the next law
        let rest = left / fall;
        let mut rates = vec![DoubleDouble::zero(); state.len()];
        then.system.rates(*time, state, &mut rates);
        state.iter_mut().zip(rates).for_each(|(part, rate)| *part += rest * rate);
        *time += rest;
        Ok(())
    }

    /// Integrates to the zero of a signal near the time found by the run, by Newton's method for the time.
    fn zero_of(&mut self, Leg { moded, glides, .. }: &Leg, crossing: Crossing) -> Result<(), Unknown> {
        let blunt = Unknown::Blunt { time: crossing.time };
        self.go_to(moded, DoubleDouble::lift(crossing.time))?;
        for _ in 0..MOST {
            let (time, state) = &self.at;
            let [value, rate] = moded.signals.of_one(crossing.signal, *time, state, glides);
            let step = value / rate;
            if !step.finite() {
                return Err(blunt);
            }
            let next = *time - step;
            self.go_to(moded, next)?;
            if step.approx().abs() <= LAST * next.approx().abs() {
                return Ok(());
            }
        }
        Err(blunt)
    }
}
