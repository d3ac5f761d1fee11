//! A knife edge on an inclined plane (Chaplygin's sleigh).
//!
//! A plane body with the coordinates (x, y, c, s): its centre of mass G and its direction (c, s) = (cos theta, sin
//! theta). The masses are (m, m, J, J); x points down the slope. The blade at A = G - d (c, s) moves along (c, s) only.

use field::{Analytic, Base, Over, Tangent};
use mechanics::constrained::newton::{Reactions, at_point};
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};

reader::quantities! {
    /// The data of the sleigh.
    pub struct KnifeEdge {
        /// m, mass
        mass: "kg" > 0,
        /// J, moment of inertia about the centre
        inertia: "kg m^2" > 0,
        /// d, distance from the blade to the centre
        offset: "m",
        /// acceleration of gravity times the sine of the slope
        slope: "m/s^2",
    }
}

impl<P: Base> PointSystem<4> for KnifeEdge<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 4] {
        [self.mass, self.mass, self.inertia, self.inertia].map(S::lift)
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 4>) -> [S; 4] {
        [self.mass * self.slope, P::zero(), P::zero(), P::zero()].map(S::lift)
    }
}

impl<P: Base> Constrained<4, 2> for KnifeEdge<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 4>) -> [Constraint<S>; 2] {
        let ([_, _, c, s], [dx, dy, dc, ds]) = (at.place, at.velocity);
        let d = S::lift(self.offset);
        [
            Constraint::Geometric((c.squared() + s.squared() - S::one()).half()),
            Constraint::Kinematic(c * (dy - d * ds) - s * (dx - d * dc)),
        ]
    }
}

/// The reactions: the internal force of the rigid body, and the force of the ice perpendicular to the blade.
impl<P: Base> Reactions<4, 2> for KnifeEdge<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 4>) -> [[S; 4]; 2] {
        let [_, _, c, s] = at.place;
        let blade = |[x, y, c, s]: [Tangent<S>; 4]| {
            let d = Tangent::lift(self.offset);
            [x - d * c, y - d * s]
        };
        [[S::zero(), S::zero(), c, s], at_point(blade, at.place, [-s, c])]
    }
}

/// The chart q = (x, y, theta), p = (u, w): the velocity of the blade along itself, and theta'.
impl<P: Base> Charted<4, 3, 2> for KnifeEdge<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [x, y, theta]: [S; 3]) -> [S; 4] {
        let point = theta.circle();
        [x, y, point.cos, point.sin]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, [_, _, theta]: [S; 3], [u, w]: [S; 2]) -> [S; 3] {
        let (point, d) = (theta.circle(), S::lift(self.offset));
        [u * point.cos - d * w * point.sin, u * point.sin + d * w * point.cos, w]
    }
}
