//! A point in the plane with prescribed speed: a kinematic constraint that is not linear in the velocity.
//!
//! Coordinates (x, y), y downwards; x'^2 + y'^2 = v^2 with v = u + a t. Its virtual displacements after Chetaev are across
//! the velocity, so the reaction is along it: a propeller's thrust, which does work.

use field::{Analytic, Base, Over};
use mechanics::constrained::newton::Reactions;
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};

/// The data of the point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrescribedSpeedPoint<P> {
    /// m, kg
    pub mass: P,
    /// g, m/s^2
    pub gravity: P,
    /// u, the speed at t = 0, m/s
    pub speed: P,
    /// a, m/s^2
    pub acceleration: P,
}

impl<P: Base> PrescribedSpeedPoint<P> {
    /// v(t)
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

/// The thrust.
impl<P: Base> Reactions<2, 1> for PrescribedSpeedPoint<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 2>) -> [[S; 2]; 1] {
        [at.velocity.map(|v| v / self.prescribed(at.time))]
    }
}

/// q = (x, y), p = chi: the direction of the velocity, from the x-axis.
impl<P: Base> Charted<2, 2, 1> for PrescribedSpeedPoint<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, q: [S; 2]) -> [S; 2] {
        q
    }

    fn rates<S: Over<P> + Analytic>(&self, time: S, _q: [S; 2], [chi]: [S; 1]) -> [S; 2] {
        let (point, v) = (chi.circle(), self.prescribed(time));
        [v * point.cos, v * point.sin]
    }
}
