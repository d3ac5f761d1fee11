//! Painleve's rod: two mass points on a massless rod, the first of them on a rough horizontal guide.
//!
//! The coordinates are (x, y, x1, y1) of the points M and M1, with the masses (m, m, m1, m1); y points downwards, in
//! the direction of gravity. theta is the angle from the guide to the rod: x1 = x + l cos theta, y1 = y + l sin theta.

use field::{Analytic, Base, Over};
use mechanics::constrained::contacts::{Closed, Contact, Contacts, Sides};
use mechanics::constrained::newton::Reactions;
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};

/// The data of the rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rod<P> {
    /// The mass m of the point M on the guide, kg.
    pub guided: P,
    /// The mass m1 of the point M1, kg.
    pub free: P,
    /// The length l, m.
    pub length: P,
    /// The acceleration of gravity g, m/s^2.
    pub gravity: P,
    /// The coefficient of friction f of the guide.
    pub friction: P,
    /// Whether the guide acts on M from one side only (as a floor below it) or from both sides.
    pub sides: Sides,
}

/// The rod with M on the guide: the first constraint is the length of the rod, the second the guide.
pub type GuidedRod<P> = Closed<Rod<P>, 1, 1>;

impl<P: Base> PointSystem<4> for Rod<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 4] {
        [self.guided, self.guided, self.free, self.free].map(S::lift)
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 4>) -> [S; 4] {
        [P::zero(), self.guided * self.gravity, P::zero(), self.free * self.gravity].map(S::lift)
    }
}

impl<P: Base> Constrained<4, 1> for Rod<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 4>) -> [Constraint<S>; 1] {
        let [x, y, x1, y1] = at.place;
        let length = S::lift(self.length);
        [Constraint::Geometric(((x1 - x).squared() + (y1 - y).squared() - length.squared()).half())]
    }
}

/// The gap is the height of M above the floor, -y: a floor pushes upwards.
impl<P: Base> Contacts<4, 1, 1> for Rod<P> {
    fn contacts<S: Over<P>>(&self, _time: S, [x, y, ..]: [S; 4]) -> [Contact<S>; 1] {
        [Contact { gap: -y, along: x, friction: S::lift(self.friction), sides: self.sides }]
    }
}

/// The reactions: the force of the rod along itself on both ends, and the upward force of the guide.
impl<P: Base> Reactions<4, 2> for Rod<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 4>) -> [[S; 4]; 2] {
        let ([x, y, x1, y1], length) = (at.place, S::lift(self.length));
        let (cos, sin) = ((x1 - x) / length, (y1 - y) / length);
        [[-cos, -sin, cos, sin], [S::zero(), -S::one(), S::zero(), S::zero()]]
    }
}

/// The chart q = (x, theta), p = q'.
impl<P: Base> Charted<4, 2, 2> for Rod<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [x, theta]: [S; 2]) -> [S; 4] {
        let (point, length) = (theta.circle(), S::lift(self.length));
        [x, S::zero(), x + length * point.cos, length * point.sin]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 2], p: [S; 2]) -> [S; 2] {
        p
    }
}
