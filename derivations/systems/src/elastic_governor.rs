//! A friction governor with flyballs and an intermediate wheel with an elastic rim; the rim rolls according to
//! Keldysh's theory.
//!
//! The drum of radius R, together with the balls, rotates at omega1, the disc at omega2. The wheel touches the disc at
//! the distance rho = x - c from the disc's axis; x is the position of the sleeve, which carries the wheel along its
//! axle. The balls hang on a rhombus of links of length l: they are at the distance sqrt(l^2 - x^2/4) from the axis and
//! at the height x/2.
//!
//! The coordinates are (phi1, phi2, phi, x, ball, ball, lambda, psi); the masses of the angles are moments of inertia.
//! lambda is the lateral displacement of the wheel's centre relative to the centre of the contact area, psi the angle
//! from the plane of the wheel to the path of the contact. The centre of the contact area does not slip sideways, x' -
//! lambda' = R omega1 psi, and the curvature of its path is alpha lambda - beta psi. The rim exerts the force a lambda
//! and the torque b psi, with the signs printed in (3.17) of Manglieva and Beknazarov; for a rim that resists
//! deformation a < 0 and b < 0, and its stiffnesses are -a and -b. Their printed Z contains the stiffness itself, that
//! is the force -a lambda. With a > 0 here, all other data positive and a prescribed speed, no motion is stable. The
//! rim's mass may be zero.

use field::{Analytic, Base, Over, Tangent};
use mechanics::constrained::appell;
use mechanics::constrained::motion::Motion;
use mechanics::constrained::{Charted, Constrained, Constraint, PointSystem, State};
use mechanics::definite::NotDefinite;
use mechanics::differentiate::{along, unit};

reader::quantities! {
    /// The data of the governor.
    pub struct ElasticGovernor {
        /// J1, moment of inertia of the drum with its shaft
        drum_inertia: "kg m^2" > 0,
        /// J2, moment of inertia of the disc with its shaft
        disc_inertia: "kg m^2" > 0,
        /// J, moment of inertia of the wheel
        wheel_inertia: "kg m^2" > 0,
        /// R, radius of the drum
        drum: "m" > 0,
        /// r, radius of the wheel
        wheel: "m" > 0,
        /// c, distance of the sleeve at which the wheel is on the disc's axis
        offset: "m",
        /// mass of the sleeve with all that moves along with it
        sleeve: "kg" > 0,
        /// mass of each ball
        ball: "kg" > 0,
        /// l, length of a link
        link: "m" > 0,
        /// M1, moment on the drum
        m1: "N m",
        /// M2, moment on the disc
        m2: "N m",
        /// stiffness of the first spring
        c1: "N/m",
        /// stiffness of the second spring
        c2: "N/m",
        /// tension of the first spring at x0
        delta1: "m",
        /// tension of the second spring at x0
        delta2: "m",
        /// x0, place of the sleeve from which the springs are counted
        rest: "m" > 0,
        /// a of the rim's force a lambda: minus its stiffness, a < 0 of a rim that resists
        across: "N/m",
        /// b of the rim's moment b psi: minus its stiffness, b < 0 of a rim that resists
        twist: "N m",
        /// d of the moment d psi on the disc about its axis
        drill: "N m",
        /// alpha, curvature of the line of rolling by the displacement
        alpha: "1/m^2",
        /// beta, curvature of the line of rolling by the angle
        beta: "1/m",
        /// mass of the rim that moves with lambda
        rim_mass: "kg" >= 0,
        /// moment of inertia of the rim that turns with psi
        rim_inertia: "kg m^2" >= 0,
    }
}

impl<P: Base> PointSystem<12> for ElasticGovernor<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 12] {
        let ElasticGovernor { drum_inertia, disc_inertia, wheel_inertia, sleeve, ball, rim_mass, rim_inertia, .. } =
            self.map(S::lift);
        let mut masses = [ball; 12];
        masses[..4].copy_from_slice(&[drum_inertia, disc_inertia, wheel_inertia, sleeve]);
        masses[10..].copy_from_slice(&[rim_mass, rim_inertia]);
        masses
    }

    fn force<S: Over<P>>(&self, at: &State<S, 12>) -> [S; 12] {
        let (x, lambda, psi) = (at.place[3], at.place[10], at.place[11]);
        let given = self.map(S::lift);
        let mut force = [S::zero(); 12];
        force[0] = given.m1;
        force[1] = given.m2 + given.drill * psi;
        force[3] = -(given.c1 + given.c2) * (x - given.rest) - given.c1 * given.delta1 + given.c2 * given.delta2;
        force[10] = given.across * lambda;
        force[11] = given.twist * psi;
        force
    }
}

/// The constraints: the links determine the position of the balls, which rotate with the drum; the other rates follow
/// from those of drum and sleeve.
impl<P: Base> Constrained<12, 10> for ElasticGovernor<P> {
    fn constraints<S: Over<P>>(&self, at: &State<S, 12>) -> [Constraint<S>; 10] {
        let (place, velocity) = (at.place, at.velocity);
        let half = place[3].half();
        let link = |ball: usize| {
            let square = (0..3).fold(S::zero(), |sum, i| sum + place[ball + i].squared());
            Constraint::Geometric((square - S::lift(self.link).squared()).half())
        };
        let height = |ball: usize| Constraint::Geometric(place[ball + 2] - half);
        let carried = |ball: usize| {
            let ([x, y], [dx, dy]) = ([place[ball], place[ball + 1]], [velocity[ball], velocity[ball + 1]]);
            Constraint::Kinematic(x * dy - y * dx - (x.squared() + y.squared()) * velocity[0])
        };
        let q = [place[0], place[1], place[2], place[3], place[10], place[11]];
        let [_, disc, wheel, _, across, turn] = self.rolling(q, [velocity[0], velocity[3]]);
        let follows = |i: usize, rate: S| Constraint::Kinematic(velocity[i] - rate);
        [
            link(4),
            height(4),
            link(7),
            height(7),
            carried(4),
            carried(7),
            follows(1, disc),
            follows(2, wheel),
            follows(10, across),
            follows(11, turn),
        ]
    }
}

/// The chart q = (phi1, phi2, phi, x, lambda, psi) with p = (omega1, x').
impl<P: Base> Charted<12, 6, 2> for ElasticGovernor<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, q: [S; 6]) -> [S; 12] {
        let [phi1, phi2, phi, x, lambda, psi] = q;
        let (point, height) = (phi1.circle(), x.half());
        let arm = (S::lift(self.link).squared() - height.squared()).sqrt();
        let (across, along) = (arm * point.cos, arm * point.sin);
        [phi1, phi2, phi, x, across, along, height, -across, -along, height, lambda, psi]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, q: [S; 6], p: [S; 2]) -> [S; 6] {
        self.rolling(q, p)
    }
}

impl<P: Base> ElasticGovernor<P> {
    /// The rates q' that the conditions of rolling determine.
    fn rolling<S: Over<P>>(&self, q: [S; 6], [speed, drift]: [S; 2]) -> [S; 6] {
        let [_, _, _, x, lambda, psi] = q;
        let rolled = S::lift(self.drum) * speed;
        let curvature = S::lift(self.alpha) * lambda - S::lift(self.beta) * psi;
        [
            speed,
            rolled / (x - S::lift(self.offset)),
            rolled / S::lift(self.wheel),
            drift,
            drift - rolled * psi,
            rolled * curvature,
        ]
    }

    /// The rates (omega1', x', x'', lambda', psi') at the state (omega1, x, x', lambda, psi). The angle of the drum is
    /// set to zero, since no equation depends on it.
    ///
    /// # Errors
    /// [`NotDefinite`] if the masses of sleeve and balls are both zero.
    pub fn rates_of_state<S: Over<P> + Analytic>(&self, state: [S; 5]) -> Result<[S; 5], NotDefinite> {
        let [speed, x, drift, lambda, psi] = state;
        let zero = S::zero();
        let (q, p) = ([zero, zero, zero, x, lambda, psi], [speed, drift]);
        let motion: Motion<S, 12, 2> = Motion::at(self, zero, q, p);
        let [spin, push] = appell::rates(self, &motion, self.force(&motion.state))?;
        let [.., across, turn] = self.rates(zero, q, p);
        Ok([spin, drift, push, across, turn])
    }

    /// The energy T plus the energies of springs and rim, J.
    pub fn energy<S: Over<P> + Analytic>(&self, [speed, x, drift, lambda, psi]: [S; 5]) -> S {
        let zero = S::zero();
        let motion: Motion<S, 12, 2> = Motion::at(self, zero, [zero, zero, zero, x, lambda, psi], [speed, drift]);
        let moving: S = mechanics::constrained::kinetic_energy(self.masses(), motion.state.velocity);
        let ElasticGovernor { c1, c2, delta1, delta2, rest, across, twist, .. } = self.map(S::lift);
        let shift = x - rest;
        let rim = across * lambda.squared() + twist * psi.squared();
        moving + ((c1 + c2) * shift.squared() - rim).half() + (c1 * delta1 - c2 * delta2) * shift
    }

    /// The power of the torques on the shafts and of the rim's torque on the disc, W: the time derivative of
    /// [`energy`](Self::energy).
    pub fn power<S: Over<P>>(&self, [speed, x, _, _, psi]: [S; 5]) -> S {
        let ElasticGovernor { m1, m2, drill, drum, offset, .. } = self.map(S::lift);
        m1 * speed + (m2 + drill * psi) * drum * speed / (x - offset)
    }

    /// The governor with the torque M1 and the tension delta2 for which (omega1, x0, lambda = psi = 0) is a steady
    /// motion; c2 must not be zero.
    pub fn stationary_at(self, speed: P) -> Self {
        let m1 = -self.drum * self.m2 / (self.rest - self.offset);
        let pull = self.ball.half() * self.rest * speed.squared() + self.c1 * self.delta1;
        ElasticGovernor { m1, delta2: pull / self.c2, ..self }
    }

    /// The matrix of the linearisation about (omega1, x0, lambda = psi = 0), in the variables (omega1, x, x', lambda,
    /// psi).
    ///
    /// # Errors
    /// [`NotDefinite`] if the masses of sleeve and balls are both zero.
    pub fn linearised<S: Over<P> + Analytic>(&self, speed: S) -> Result<[[S; 5]; 5], NotDefinite>
    where
        Tangent<S>: Over<P>,
    {
        let state = [speed, S::lift(self.rest), S::zero(), S::zero(), S::zero()];
        let mut matrix = [[S::zero(); 5]; 5];
        for j in 0..5 {
            for (row, rate) in matrix.iter_mut().zip(self.rates_of_state(along(state, unit(j)))?) {
                row[j] = rate.slope;
            }
        }
        Ok(matrix)
    }
}
