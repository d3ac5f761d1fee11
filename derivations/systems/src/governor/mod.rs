//! Friction governors: two shafts are coupled by an intermediate wheel, which is moved so that the speed of the second
//! shaft is constant.
//!
//! The coordinates are (c1, s1, c2, s2, c, s, rho): unit vectors that describe the rotation of both discs and of the
//! wheel about their fixed axes, and the distance rho of the wheel from the axis of the second disc (with a
//! [`Gearing::Drum`]) or of the first disc (with [`Gearing::Discs`]). The wheel rolls on both bodies without slipping;
//! a force along its axle acts on it.
//!
//! * [`programme`]: the motion of the wheel for which the speed is constant, and its control force; [`servo`]: the same
//!   as a servo constraint;
//! * [`constant`]: the programme under constant torques in closed form, and its end; [`between`]: the programme between
//!   two discs;
//! * [`series`]: the programme as a power series in a small parameter;
//! * [`released`]: motions near the programme, and their linearisation.

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
    /// A drum of radius R on the first shaft, along which the wheel slides; the wheel touches the second disc at the
    /// distance rho from its axis.
    Drum { radius: P },
    /// Two discs whose axes are at the distance a; the wheel touches them at rho from the first axis and at a - rho
    /// from the second.
    Discs { distance: P },
}

/// A torque that is linear in time: M + M' t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torque<P> {
    /// The torque M at t = 0, N m.
    pub start: P,
    /// Its rate of change M', N m/s.
    pub growth: P,
}

impl<P: Base> Torque<P> {
    /// A constant torque.
    pub fn constant(start: P) -> Self {
        Torque { start, growth: P::zero() }
    }

    /// The torque at a time.
    pub fn at<S: Over<P>>(&self, time: S) -> S {
        S::lift(self.start) + S::lift(self.growth) * time
    }
}

/// The data of a governor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Governor<P> {
    /// The moments of inertia about their axes, kg m^2: J1, J2 of the discs with their shafts, and J of the wheel.
    pub inertia: [P; 3],
    /// The mass m of the wheel with its axle, kg.
    pub mass: P,
    /// The radius r of the wheel, m.
    pub radius: P,
    pub gearing: Gearing<P>,
    /// The torques M1, M2 on the shafts.
    pub moments: [Torque<P>; 2],
    /// The force u along the axle, N.
    pub push: P,
    /// The friction force F11 + F22 of both contacts across the wheel's plane, opposite to the growth of rho, N.
    pub lateral: P,
}

impl<P: Base> Governor<P> {
    /// The lever arms of the contacts about the axes of the first and the second disc, m.
    pub fn levers<S: Over<P>>(&self, rho: S) -> [S; 2] {
        match self.gearing {
            Gearing::Drum { radius } => [S::lift(radius), rho],
            Gearing::Discs { distance } => [rho, S::lift(distance) - rho],
        }
    }
}

/// The angular velocity, rad/s, of a body (0: first disc, 1: second disc, 2: wheel).
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

/// The constraints: the directions are unit vectors, and the wheel's rim has the velocity of the first disc and of the
/// second disc at the contacts.
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

/// The reactions: the internal force of a rigid body is along its unit vector; a contact force acts on the wheel's rim,
/// and the opposite force on the disc.
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

/// The chart q = (phi1, phi2, phi, rho) with p = (omega2, rho').
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
