//! The ladder under a weight that is carried up along it.
//!
//! The weight P stands at the distance v t from the foot B, in steady steps: its inertia is neglected, so that it is a
//! load and nothing else. Everything else is the ladder's.

use super::ladder::Ladder;
use field::{Base, Over};
use mechanics::constrained::contacts::{Contact, Contacts};
use mechanics::constrained::{Constrained, Constraint, State, System};

/// The data of the ladder and its load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClimbedLadder<P> {
    pub ladder: Ladder<P>,
    /// P, N
    pub weight: P,
    /// v along the ladder, m/s
    pub speed: P,
}

impl<P: Base> System<4> for ClimbedLadder<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 4] {
        self.ladder.masses()
    }

    /// The weight's place is G + d (-s, c) with d = v t - l: its work is -P times the change of y + d c.
    fn force<S: Over<P>>(&self, at: &State<S, 4>) -> [S; 4] {
        let [x, y, c, s] = self.ladder.force(at);
        let weight = S::lift(self.weight);
        let along = S::lift(self.speed) * at.time - S::lift(self.ladder.half_length);
        [x, y - weight, c - weight * along, s]
    }
}

impl<P: Base> Constrained<4, 1> for ClimbedLadder<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 4>) -> [Constraint<S>; 1] {
        self.ladder.constraints(at)
    }
}

/// The ladder's two contacts, and its top above the floor, where its fall ends.
impl<P: Base> Contacts<4, 1, 3> for ClimbedLadder<P> {
    fn contacts<S: Over<P>>(&self, time: S, place: [S; 4]) -> [Contact<S>; 3] {
        let [wall, floor] = self.ladder.contacts(time, place);
        let [x, y, c, s] = place;
        let half = S::lift(self.ladder.half_length);
        [wall, floor, Contact { gap: y + half * c, along: x - half * s, ..floor }]
    }
}
