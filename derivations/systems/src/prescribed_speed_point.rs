//! A point in the plane with prescribed speed: a kinematic constraint that is nonlinear in the velocity.
//!
//! The coordinates are (x, y), y downwards; x'^2 + y'^2 = v^2 with v = u + a t. By Chetaev's definition its virtual
//! displacements are perpendicular to the velocity. Hence the reaction is along the velocity and does work, like the
//! thrust of a propeller.

use field::{Analytic, Base, Over};
use mechanics::constrained::newton::Reactions;
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};

/// The data of the point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrescribedSpeedPoint<P> {
    /// The mass m, kg.
    pub mass: P,
    /// The acceleration of gravity g, m/s^2.
    pub gravity: P,
    /// The speed u at t = 0, m/s.
    pub speed: P,
    /// The rate of change a of the speed, m/s^2.
    pub acceleration: P,
}

impl<P: Base> PrescribedSpeedPoint<P> {
    /// The prescribed speed v(t).
    fn prescribed<S: Over<P>>(&self, time: S) -> S {
        S::lift(self.speed) + S::lift(self.acceleration) * time
    }
}

impl<P: Base> PointSystem<2> for PrescribedSpeedPoint<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 2] {
        [self.mass, self.mass].map(S::lift)
    }

    fn force<S: Over<P>>(&self, _at: &State<S, 2>) -> [S; 2] {
        [P::zero(), self.mass * self.gravity].map(S::lift)
    }
}

impl<P: Base> Constrained<2, 1> for PrescribedSpeedPoint<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 2>) -> [Constraint<S>; 1] {
        let [dx, dy] = at.velocity;
        [Constraint::Kinematic((dx.squared() + dy.squared() - self.prescribed(at.time).squared()).half())]
    }
}

/// The reaction: the thrust along the velocity.
impl<P: Base> Reactions<2, 1> for PrescribedSpeedPoint<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 2>) -> [[S; 2]; 1] {
        [at.velocity.map(|v| v / self.prescribed(at.time))]
    }
}

/// The chart q = (x, y), p = chi, where chi is the angle from the x axis to the velocity.
impl<P: Base> Charted<2, 2, 1> for PrescribedSpeedPoint<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, q: [S; 2]) -> [S; 2] {
        q
    }

    fn rates<S: Over<P> + Analytic>(&self, time: S, _q: [S; 2], [chi]: [S; 1]) -> [S; 2] {
        let (point, v) = (chi.circle(), self.prescribed(time));
        [v * point.cos, v * point.sin]
    }
}
