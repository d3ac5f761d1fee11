//! The steered rod: Painleve's rod with the additional constraint that the velocity of its midpoint is along the rod.
//!
//! The coordinates are (x1, y1, x2, y2) of M1 on the guide and of M2; y points downwards; a horizontal force X acts on
//! M1. The condition on the midpoint is kinematic but, by Frobenius' theorem, integrable.

use field::{Analytic, Base, Over, Scalar, Tangent};
use mechanics::constrained::contacts::{Closed, Contact, Contacts, Sides};
use mechanics::constrained::newton::{Reactions, at_point};
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};

/// The data of the steered rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteeredRod<P> {
    /// The mass m1 of the point M1 on the guide, kg.
    pub guided: P,
    /// The mass m2 of the point M2, kg.
    pub free: P,
    /// The length l, m.
    pub length: P,
    /// The acceleration of gravity g, m/s^2.
    pub gravity: P,
    /// The force X on M1 along the guide, N.
    pub drive: P,
    /// The coefficient of friction f of the guide.
    pub friction: P,
    /// The sides from which the guide acts on M1.
    pub sides: Sides,
}

/// The steered rod with M1 on the guide; the constraints are length, midpoint, guide.
pub type GuidedSteeredRod<P> = Closed<SteeredRod<P>, 2, 1>;

impl<P: Base> PointSystem<4> for SteeredRod<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 4] {
        [self.guided, self.guided, self.free, self.free].map(S::lift)
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 4>) -> [S; 4] {
        [self.drive, self.guided * self.gravity, P::zero(), self.free * self.gravity].map(S::lift)
    }
}

impl<P: Base> Constrained<4, 2> for SteeredRod<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 4>) -> [Constraint<S>; 2] {
        let ([x1, y1, x2, y2], [u1, v1, u2, v2]) = (at.place, at.velocity);
        let length = S::lift(self.length);
        let stretch = ((x2 - x1).squared() + (y2 - y1).squared() - length.squared()).half();
        let sideways = (x2 - x1) * (v2 + v1) - (y2 - y1) * (u2 + u1);
        [Constraint::Geometric(stretch), Constraint::Kinematic(sideways)]
    }
}

impl<P: Base> Contacts<4, 2, 1> for SteeredRod<P> {
    fn contacts<S: Over<P>>(&self, _time: S, [x1, y1, ..]: [S; 4]) -> [Contact<S>; 1] {
        [Contact { gap: -y1, along: x1, friction: S::lift(self.friction), sides: self.sides }]
    }
}

/// The reactions: the force of the rod along itself on both ends, the steering force perpendicular to the rod at the
/// midpoint, and the upward force of the guide.
impl<P: Base> Reactions<4, 3> for SteeredRod<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 4>) -> [[S; 4]; 3] {
        let ([x1, y1, x2, y2], length) = (at.place, S::lift(self.length));
        let (cos, sin) = ((x2 - x1) / length, (y2 - y1) / length);
        let middle = |[x1, y1, x2, y2]: [Tangent<S>; 4]| [(x1 + x2).half(), (y1 + y2).half()];
        [[-cos, -sin, cos, sin], at_point(middle, at.place, [-sin, cos]), [S::zero(), -S::one(), S::zero(), S::zero()]]
    }
}

/// The chart on the guide, q = (x1, theta), p = x1'; theta' = 2 x1' sin theta / l is regular at every angle.
impl<P: Base> Charted<4, 2, 1> for SteeredRod<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [x1, theta]: [S; 2]) -> [S; 4] {
        let (point, length) = (theta.circle(), S::lift(self.length));
        [x1, S::zero(), x1 + length * point.cos, length * point.sin]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, [_, theta]: [S; 2], [u]: [S; 1]) -> [S; 2] {
        [u, S::int(2) * u * theta.circle().sin / S::lift(self.length)]
    }
}
