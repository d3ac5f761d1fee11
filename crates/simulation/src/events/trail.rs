//! States of a motion before a singular position, for the continuation beyond it.

use super::law_end::SwitchesAndEnds;
use integrators::{System, Taylor, TaylorSeries, Tolerance};

/// The order of the Taylor series.
pub(super) const ORDER: usize = 24;

/// The number of states from which a trail is thinned out, and the smallest ratio of their distances from the last
/// state afterwards.
const MOST: usize = 128;
const THINNED: f64 = 1.25;

/// The smallest ratio of the distances of states from which the motion is integrated again.
const FARTHER: f64 = 2.0;

/// The tolerance of steps between such states: rounding.
const EXACTLY: f64 = 1e-15;

/// The number of repeated states, each at half the distance of the one before.
const HALVINGS: usize = 6;

/// The first step away from a singular position near the start, as a fraction of the span; each further step is twice
/// as long. The series of a motion that deviates from its branch by rounding converges up to the position only: no step
/// is longer than the distance from it.
pub(super) const FIRST: f64 = 1e-11;
const DOUBLINGS: i32 = 40;

/// The number of states with positive margins before the first state of a trail, or before a start.
const BEFORE: usize = 9;

/// A time (s) and the state then.
pub(super) type Instant = (f64, Vec<f64>);

/// States of a motion up to the last one. They are denser towards the end, where the motion approaches a singular
/// position.
#[derive(Debug, Default)]
pub(super) struct Trail {
    states: Vec<Instant>,
    /// Buffers of dropped states.
    spare: Vec<Vec<f64>>,
}

impl Trail {
    /// The states of a motion before its start near a singular position, by series backwards in time. `None` where they
    /// do not reach positive margins.
    pub fn before(law: &dyn System, start: &Instant, span: f64, switches: &SwitchesAndEnds<'_>) -> Option<Self> {
        let mut states = away(law, start, -FIRST * span, (switches, BEFORE))?;
        states.reverse();
        states.push(start.clone());
        Some(Trail { states, spare: Vec::new() })
    }

    /// The trail with additional states before its first one, for a run that began close to an event. `None`
    /// if the trail is empty, or no such states are found.
    pub fn extended(&self, law: &dyn System, event: f64, switches: &SwitchesAndEnds<'_>) -> Option<Self> {
        let first = self.states.first()?;
        let mut states = away(law, first, first.0 - event, (switches, BEFORE))?;
        states.reverse();
        states.extend(self.states.iter().cloned());
        Some(Trail { states, spare: Vec::new() })
    }

    /// Forgets all states, and begins the trail with this one at a time (s).
    pub fn restart(&mut self, time: f64, state: &[f64]) {
        self.spare.extend(self.states.drain(..).map(|(_, room)| room));
        self.step(time, state);
    }

    /// Adds a state at a time (s). If the trail is full, some earlier states are left out.
    pub fn step(&mut self, time: f64, state: &[f64]) {
        if self.states.len() == MOST {
            let mut kept = f64::INFINITY;
            let dropped = self.states.extract_if(.., |(known, _)| {
                let distance = (time - *known).abs();
                let goes = distance * THINNED > kept;
                kept = if goes { kept } else { distance };
                goes
            });
            self.spare.extend(dropped.map(|(_, room)| room));
        }
        let mut room = self.spare.pop().unwrap_or_default();
        room.clear();
        room.extend_from_slice(state);
        self.states.push((time, room));
    }

    /// Chains of states towards an event, the nearest chain first. Each begins with a state of the trail and continues
    /// with Taylor's method: states of a chain differ from one motion by rounding only, whatever the method of the run.
    /// `None` if the law has no Taylor series.
    pub fn chains(&self, law: &dyn System, event: f64) -> Option<Vec<Vec<Instant>>> {
        let mut path = Path::of(law)?;
        let mut chains: Vec<Vec<Instant>> = Vec::new();
        for from in self.states.iter().rev().filter(|(time, _)| *time != event) {
            let is_farther = |chain: &Vec<Instant>| (event - from.0).abs() >= FARTHER * (event - chain[0].0).abs();
            if chains.last().is_none_or(is_farther) {
                let next = |last: &Instant| path.moved(last, f64::midpoint(last.0, event));
                chains.push(std::iter::successors(Some(from.clone()), next).take(HALVINGS + 1).collect());
            }
        }
        Some(chains)
    }
}

/// Repeated integration to rounding accuracy.
struct Path<'a> {
    law: &'a dyn System,
    taylor: Taylor<Box<dyn TaylorSeries<f64> + 'a>>,
}

impl<'a> Path<'a> {
    fn of(law: &'a dyn System) -> Option<Self> {
        Some(Path { law, taylor: Taylor::new(law.taylor()?, &Tolerance::both(EXACTLY)) })
    }

    /// The state at another time; `None` where the integration fails.
    fn moved(&mut self, (time, state): &Instant, next: f64) -> Option<Instant> {
        let mut moved = state.clone();
        self.taylor.propagate(*time, next, &mut moved).ok()?;
        if let Some(projection) = self.law.projection() {
            projection.project(next, &mut moved);
        }
        moved.iter().all(|part| part.is_finite()).then_some((next, moved))
    }
}

/// States at increasing distances from a singular position, until `count` of them have positive margins.
pub(super) fn away(
    law: &dyn System,
    start: &Instant,
    first: f64,
    (switches, count): (&SwitchesAndEnds<'_>, usize),
) -> Option<Vec<Instant>> {
    let mut path = Path::of(law)?;
    let mut states: Vec<Instant> = Vec::new();
    let mut up = 0;
    for doubling in 0..DOUBLINGS {
        let last = states.last().unwrap_or(start);
        let Some(next) = path.moved(last, last.0 + first * f64::from(doubling).exp2()) else { break };
        let holds = switches.margins_hold(next.0, &next.1);
        if !holds && up > 0 {
            break;
        }
        up += usize::from(holds);
        states.push(next);
        if up == count {
            break;
        }
    }
    (up > 0).then_some(states)
}
