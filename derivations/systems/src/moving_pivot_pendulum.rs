//! A pendulum with a moving pivot: a geometric constraint that depends on time (rheonomic).
//!
//! The coordinates are the position (x, y) of the bob, y downwards; the pivot is at (s, 0) with s = u t + a t^2/2.

use field::{Analytic, Base, Over};
use mechanics::constrained::newton::Reactions;
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};

/// The data of the pendulum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MovingPivotPendulum<P> {
    /// The mass m, kg.
    pub mass: P,
    /// The length l, m.
    pub length: P,
    /// The acceleration of gravity g, m/s^2.
    pub gravity: P,
    /// The pivot's speed u at t = 0, m/s.
    pub speed: P,
    /// The pivot's acceleration a, m/s^2.
    pub acceleration: P,
}

impl<P: Base> MovingPivotPendulum<P> {
    /// The pivot's position s(t).
    fn pivot<S: Over<P>>(&self, time: S) -> S {
        (S::lift(self.speed) + S::lift(self.acceleration).half() * time) * time
    }
}

impl<P: Base> PointSystem<2> for MovingPivotPendulum<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 2] {
        [self.mass, self.mass].map(S::lift)
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 2>) -> [S; 2] {
        [P::zero(), self.mass * self.gravity].map(S::lift)
    }
}

impl<P: Base> Constrained<2, 1> for MovingPivotPendulum<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 2>) -> [Constraint<S>; 1] {
        let [x, y] = at.place;
        let aside = x - self.pivot(at.time);
        [Constraint::Geometric((aside.squared() + y.squared() - S::lift(self.length).squared()).half())]
    }
}

/// The reaction of the thread; positive away from the pivot.
impl<P: Base> Reactions<2, 1> for MovingPivotPendulum<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 2>) -> [[S; 2]; 1] {
        let ([x, y], length) = (at.place, S::lift(self.length));
        [[(x - self.pivot(at.time)) / length, y / length]]
    }
}

/// The chart q = theta, measured from the vertical, with p = theta'.
impl<P: Base> Charted<2, 1, 1> for MovingPivotPendulum<P> {
    fn place<S: Over<P> + Analytic>(&self, time: S, [theta]: [S; 1]) -> [S; 2] {
        let (point, length) = (theta.circle(), S::lift(self.length));
        [self.pivot(time) + length * point.sin, length * point.cos]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 1], p: [S; 1]) -> [S; 1] {
        p
    }
}
