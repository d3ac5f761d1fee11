//! Friction governors: two shafts and an intermediate wheel that is moved so that the second shaft keeps its speed.
//!
//! Coordinates (c1, s1, c2, s2, c, s, rho): the directions of both discs and of the wheel, each a plane body that turns
//! about a fixed axis, and the distance of the wheel from the axis of the second disc (with a [`Gearing::Drum`]) or of the
//! first (with [`Gearing::Discs`]). The wheel rolls on both without slipping; a force acts on it along its axle.
//!
//! * [`programme`]: the motion of the wheel that keeps the speed, and its control force; [`servo`]: as a servo constraint;
//! * [`constant`]: the programme in closed form under constant torques, and its end; [`between`]: between two discs;
//! * [`series`]: the programme by powers of a small parameter;
//! * [`released`]: the motion near the programme, and its linearisation.

pub mod between;
pub mod constant;
pub mod programme;
pub mod released;
pub mod series;
pub mod servo;

use field::{Analytic, Base, Over, Scalar};
use mechanics::constrained::newton::Reactions;
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};

/// The bodies on which the wheel rolls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gearing<P> {
    /// A drum of radius R on the first shaft, along which the wheel slides; on the second disc at rho from its axis.
    Drum { radius: P },
    /// Two discs whose axes are a apart: at rho from the first axis, at a - rho from the second.
    Discs { distance: P },
}

/// A torque that is linear in the time: M + M' t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torque<P> {
    /// at t = 0, N m
    pub start: P,
    /// N m/s
    pub growth: P,
}

impl<P: Base> Torque<P> {
    /// A constant torque.
    pub fn constant(start: P) -> Self {
        Torque { start, growth: P::zero() }
    }

    /// M(t)
    pub fn at<S: Over<P>>(&self, time: S) -> S {
        S::lift(self.start) + S::lift(self.growth) * time
    }
}

/// The data of a governor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Governor<P> {
    /// J1, J2 of the discs with their shafts and J of the wheel about their axes, kg m^2
    pub inertia: [P; 3],
    /// m of the wheel with its axle, kg
    pub mass: P,
    /// r of the wheel, m
    pub radius: P,
    pub gearing: Gearing<P>,
    /// M1, M2 on the shafts
    pub moments: [Torque<P>; 2],
    /// u, the force along the axle, N
    pub push: P,
    /// F11 + F22, the friction across the wheel at both contacts, against the growth of rho, N
    pub lateral: P,
}

impl<P: Base> Governor<P> {
    /// The levers of the contacts about the axes of the first and of the second disc, m.
    pub fn levers<S: Over<P>>(&self, rho: S) -> [S; 2] {
        match self.gearing {
            Gearing::Drum { radius } => [S::lift(radius), rho],
            Gearing::Discs { distance } => [rho, S::lift(distance) - rho],
        }
    }
}

/// The angular velocity, rad/s, of a body: first disc, second disc, wheel.
fn turning<S: Scalar>(at: &State<S, 7>, body: usize) -> S {
    let (cos, sin) = (2 * body, 2 * body + 1);
    at.place[cos] * at.velocity[sin] - at.place[sin] * at.velocity[cos]
}

impl<P: Base> PointSystem<7> for Governor<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 7] {
        let [first, second, wheel] = self.inertia;
        [first, first, second, second, wheel, wheel, self.mass].map(S::lift)
    }

    fn force<S: Over<P>>(&self, at: &State<S, 7>) -> [S; 7] {
        let [c1, s1, c2, s2, ..] = at.place;
        let [first, second] = self.moments.map(|moment| moment.at(at.time));
        let along = S::lift(self.push) - S::lift(self.lateral);
        [-s1 * first, c1 * first, -s2 * second, c2 * second, S::zero(), S::zero(), along]
    }
}

/// The directions are unit vectors; the rim of the wheel moves with the first disc and with the second.
impl<P: Base> Constrained<7, 5> for Governor<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 7>) -> [Constraint<S>; 5] {
        let length = |k: usize| {
            let [cos, sin] = [at.place[2 * k], at.place[2 * k + 1]];
            Constraint::Geometric((cos.squared() + sin.squared() - S::one()).half())
        };
        let [first, second] = self.levers(at.place[6]);
        let rim = S::lift(self.radius) * turning(at, 2);
        let rolling =
            [first * turning(at, 0), second * turning(at, 1)].map(|surface| Constraint::Kinematic(rim - surface));
        [length(0), length(1), length(2), rolling[0], rolling[1]]
    }
}

/// The reaction of rigidity is along each direction; a contact acts on the rim of the wheel and oppositely on the disc.
impl<P: Base> Reactions<7, 5> for Governor<P> {
    fn reactions<S: Over<P>>(&self, at: &State<S, 7>) -> [[S; 7]; 5] {
        let [c1, s1, c2, s2, c, s, rho] = at.place;
        let (zero, radius) = (S::zero(), S::lift(self.radius));
        let [first, second] = self.levers(rho);
        [
            [c1, s1, zero, zero, zero, zero, zero],
            [zero, zero, c2, s2, zero, zero, zero],
            [zero, zero, zero, zero, c, s, zero],
            [s1 * first, -c1 * first, zero, zero, -s * radius, c * radius, zero],
            [zero, zero, s2 * second, -c2 * second, -s * radius, c * radius, zero],
        ]
    }
}

/// q = (phi1, phi2, phi, rho), p = (omega2, rho').
impl<P: Base> Charted<7, 4, 2> for Governor<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [phi1, phi2, phi, rho]: [S; 4]) -> [S; 7] {
        let [first, second, wheel] = [phi1, phi2, phi].map(Analytic::circle);
        [first.cos, first.sin, second.cos, second.sin, wheel.cos, wheel.sin, rho]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, [.., rho]: [S; 4], [speed, drift]: [S; 2]) -> [S; 4] {
        let [first, second] = self.levers(rho);
        let rim = second * speed;
        [rim / first, speed, rim / S::lift(self.radius), drift]
    }
}
