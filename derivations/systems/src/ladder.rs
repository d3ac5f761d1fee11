//! Appell's ladder: a rod that leans on a rough wall and stands on a rough floor.
//!
//! A plane body with the coordinates (x, y, c, s): its centre of mass G and its direction. The masses are (m, m, J, J);
//! y points upwards. alpha is the angle from the wall to the ladder, (c, s) = (cos alpha, sin alpha). The end A = G + l
//! (-s, c) touches the wall x = 0, the end B = G + l (s, -c) touches the floor y = 0.

use field::{Analytic, Base, Over, Tangent};
use mechanics::constrained::contacts::{Closed, Contact, Contacts, Sides};
use mechanics::constrained::newton::{Reactions, at_point};
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};

/// The data of the ladder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ladder<P> {
    /// The mass m, kg.
    pub mass: P,
    /// The moment of inertia J about the centre of mass, kg m^2; m l^2/3 for a uniform ladder.
    pub inertia: P,
    /// Half of the length, l, m.
    pub half_length: P,
    /// The acceleration of gravity g, m/s^2.
    pub gravity: P,
    /// The coefficients of friction f of the wall at A and of the floor at B.
    pub friction: [P; 2],
}

/// The ladder in contact with wall and floor; the constraints are rigidity, wall, floor.
pub type LeaningLadder<P> = Closed<Ladder<P>, 1, 2>;

impl<P: Base> PointSystem<4> for Ladder<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 4] {
        [self.mass, self.mass, self.inertia, self.inertia].map(S::lift)
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 4>) -> [S; 4] {
        [P::zero(), -self.mass * self.gravity, P::zero(), P::zero()].map(S::lift)
    }
}

impl<P: Base> Constrained<4, 1> for Ladder<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 4>) -> [Constraint<S>; 1] {
        let [_, _, c, s] = at.place;
        [Constraint::Geometric((c.squared() + s.squared() - S::one()).half())]
    }
}

impl<P: Base> Contacts<4, 1, 2> for Ladder<P> {
    fn contacts<S: Over<P>>(&self, _time: S, [x, y, c, s]: [S; 4]) -> [Contact<S>; 2] {
        let half = S::lift(self.half_length);
        let [wall, floor] = self.friction.map(S::lift);
        [
            Contact { gap: x - half * s, along: y + half * c, friction: wall, sides: Sides::One },
            Contact { gap: y - half * c, along: x + half * s, friction: floor, sides: Sides::One },
        ]
    }
}

/// The reactions: the internal force of the rigid body, the force of the wall at A, and the force of the floor at B.
impl<P: Base> Reactions<4, 3> for Ladder<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 4>) -> [[S; 4]; 3] {
        let half = Tangent::lift(self.half_length);
        let (top, foot) = (
            |[x, y, c, s]: [Tangent<S>; 4]| [x - half * s, y + half * c],
            |[x, y, c, s]: [Tangent<S>; 4]| [x + half * s, y - half * c],
        );
        let [_, _, c, s] = at.place;
        let (o, l) = (S::zero(), S::one());
        [[o, o, c, s], at_point(top, at.place, [l, o]), at_point(foot, at.place, [o, l])]
    }
}

/// The chart q = alpha, p = alpha' for contact with wall and floor.
impl<P: Base> Charted<4, 1, 1> for Ladder<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [alpha]: [S; 1]) -> [S; 4] {
        let (point, half) = (alpha.circle(), S::lift(self.half_length));
        [half * point.sin, half * point.cos, point.cos, point.sin]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 1], p: [S; 1]) -> [S; 1] {
        p
    }
}
