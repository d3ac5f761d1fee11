//! A rod that touches a rough line with one end.
//!
//! A plane body with the coordinates (x, y, c, s): its centre of mass and its direction. The masses are (m, m, J, J); y
//! points upwards. theta is the angle from the line y = 0 to the rod, (c, s) = (cos theta, sin theta); the end that
//! touches the line is the centre of mass minus l (c, s).

use field::{Base, Over};
use mechanics::constrained::contacts::{Contact, Contacts, Sides};
use mechanics::constrained::{Constrained, Constraint, PointSystem, State};

/// The data of the rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlenderRod<P> {
    /// The mass m, kg.
    pub mass: P,
    /// The moment of inertia J about the centre of mass, kg m^2; m l^2/3 for a uniform rod.
    pub inertia: P,
    /// Half of the length, l, m.
    pub half_length: P,
    /// The acceleration of gravity g, m/s^2.
    pub gravity: P,
    /// The coefficient of friction f of the line.
    pub friction: P,
}

impl<P: Base> PointSystem<4> for SlenderRod<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 4] {
        [self.mass, self.mass, self.inertia, self.inertia].map(S::lift)
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 4>) -> [S; 4] {
        [P::zero(), -self.mass * self.gravity, P::zero(), P::zero()].map(S::lift)
    }
}

impl<P: Base> Constrained<4, 1> for SlenderRod<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 4>) -> [Constraint<S>; 1] {
        let [_, _, c, s] = at.place;
        [Constraint::Geometric((c.squared() + s.squared() - S::one()).half())]
    }
}

impl<P: Base> Contacts<4, 1, 1> for SlenderRod<P> {
    fn contacts<S: Over<P>>(&self, _time: S, [x, y, c, s]: [S; 4]) -> [Contact<S>; 1] {
        let half = S::lift(self.half_length);
        [Contact { gap: y - half * s, along: x - half * c, friction: S::lift(self.friction), sides: Sides::One }]
    }
}
