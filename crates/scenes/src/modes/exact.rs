//! The course of a run to all digits: by one method in double-double along its laws, event after event.

use super::course::{Course, Crossing, Leg, Sets};
use super::{Laws, Moded, Modes};
use derivations::scene::hybrid::{At, Followed, Means, Unknown};
use field::{DoubleDouble, Over};
use integrators::{Happening, Ode, Real};
use num_traits::Zero;
use std::sync::PoisonError;

/// Newton's iteration doubles the digits: where a run knows thirteen one step comes to all that are kept, and the next finds so.
const MOST: usize = 8;
const COMES_TO_REST: &str = "a contact that slides in space comes to rest, which is not followed to all digits,";
const BEGINS: &str = "a contact begins to slide in space, which is not followed to all digits,";

/// A correction so small, relative to the time, leaves nothing to correct.
const LAST: f64 = 1e-20;

impl Modes {
    /// The laws of the last run.
    pub fn course(&self) -> Course {
        Course { legs: self.course.lock().unwrap_or_else(PoisonError::into_inner).clone() }
    }

    /// The course of a run by one method, at instants up to its end.
    ///
    /// # Errors
    /// Where the method does not follow it, or an event is told by a tie.
    pub fn exactly(
        &self,
        course: &Course,
        start: &[f64],
        instants: &[f64],
        means: Means,
    ) -> Result<(Followed, Means), Unknown> {
        let state = start.iter().map(|part| DoubleDouble::lift(*part)).collect();
        Follower { laws: &self.laws, means, at: (DoubleDouble::zero(), state) }.follow(course, instants)
    }
}

impl Course {
    /// y' of the law that holds at a time.
    pub fn rates_at(&self, time: f64, state: &[DoubleDouble], rates: &mut [DoubleDouble]) {
        let has_begun = |leg: &&Leg| leg.cause.is_none_or(|cause| cause.time <= time);
        if let Some(leg) = self.legs.iter().take_while(has_begun).last() {
            leg.moded.system.rates(DoubleDouble::lift(time), state, rates);
        }
    }
}

struct Follower<'a> {
    laws: &'a Laws,
    means: Means,
    at: At,
}

impl Follower<'_> {
    fn follow(mut self, course: &Course, instants: &[f64]) -> Result<(Followed, Means), Unknown> {
        let (mut states, mut events, mut left) = (Vec::new(), Vec::new(), instants);
        for (place, leg) in course.legs.iter().enumerate() {
            if leg.begins_to_glide {
                let time = leg.cause.map_or(0.0, |cause| cause.time);
                return Err(Unknown::Ends(format!("{BEGINS} at t = {time} s")));
            }
            let next = course.legs.get(place + 1).and_then(|next| next.cause);
            let within = left.iter().take_while(|instant| next.is_none_or(|next| **instant < next.time)).count();
            for &instant in &left[..within] {
                self.go_to(&leg.moded, DoubleDouble::lift(instant))?;
                states.push(self.at.1.clone());
            }
            left = &left[within..];
            if let Some(next) = next {
                self.pass(leg, next)?;
                if next.sets != Sets::Unseen {
                    events.push(self.at.clone());
                }
            }
        }
        Ok((Followed { states, events }, self.means))
    }

    /// Follows a law to a time.
    fn go_to(&mut self, moded: &Moded, time: DoubleDouble) -> Result<(), Unknown> {
        let (from, state) = &mut self.at;
        *state = self.means.flow(&*moded.system, [*from, time], state)?;
        *from = time;
        Ok(())
    }

    /// Goes to an event, and sets the state as it does.
    fn pass(&mut self, leg: &Leg, crossing: Crossing) -> Result<(), Unknown> {
        let Leg { moded, glides, .. } = leg;
        let blunt = || Unknown::Blunt { time: crossing.time };
        if crossing.what == Happening::Falls {
            self.zero_of(leg, crossing)?;
        }
        let (time, state) = &mut self.at;
        match crossing.sets {
            Sets::Nothing | Sets::Unseen | Sets::End => {}
            Sets::Event(event) => *state = moded.signals.set_by(event, *time, state, glides),
            Sets::Impact(contact) => {
                let expansions = self.laws.expansions().map_err(|_| blunt())?;
                *state =
                    expansions.struck_exactly(*time, state, (contact, &moded.system.mode.cases)).ok_or_else(blunt)?;
            }
            Sets::Rest => return Err(Unknown::Ends(format!("{COMES_TO_REST} at t = {} s", crossing.time))),
            Sets::LastBounce => return Err(Unknown::LastBounce { time: crossing.time }),
        }
        Ok(())
    }

    /// Where a signal is zero, close to where the run found it: Newton's method on the instant, the motion followed to each.
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
