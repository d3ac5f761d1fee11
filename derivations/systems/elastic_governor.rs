//! The friction governor with centrifugal balls and an intermediate wheel with an elastic rim (rolling after Keldysh).
//!
//! The drum of radius R with the balls turns with omega1, the disc with omega2; the wheel touches the disc at rho = x - c
//! from its axis. x is the place of the sleeve, with which the wheel moves along its axle. The balls hang on a rhombus of
//! links of length l, so that they are at sqrt(l^2 - x^2/4) from the axis and at the height x/2.
//!
//! Coordinates (phi1, phi2, phi, x, ball, ball, lambda, psi) with the moments of inertia for the masses of angles. lambda is
//! the displacement of the wheel's centre across its plane from the centre of the contact, psi the angle from the plane of
//! the wheel to the line of rolling. The centre of the contact does not slip sideways, x' - lambda' = R omega1 psi, and
//! the curvature of the line is alpha lambda - beta psi. The rim pushes with a lambda and b psi: it is elastic where a and
//! b are negative. Its mass may vanish.

use field::{Analytic, Base, Over, Tangent};
use mechanics::constrained::appell;
use mechanics::constrained::motion::Motion;
use mechanics::constrained::{Charted, State, System};
use mechanics::definite::NotDefinite;
use mechanics::differentiate::{along, unit};

/// The data of the governor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticGovernor<P> {
    /// J1 of the drum, J2 of the disc, J of the wheel about their axes, kg m^2
    pub inertia: [P; 3],
    /// R, m
    pub drum: P,
    /// r, m
    pub wheel: P,
    /// c, m
    pub offset: P,
    /// of the sleeve with all that moves along with it, kg
    pub sleeve: P,
    /// of each ball, kg
    pub ball: P,
    /// l, m
    pub link: P,
    /// M1, M2, N m
    pub moments: [P; 2],
    /// c1, c2, N/m
    pub stiffness: [P; 2],
    /// delta1, delta2: tensions of the springs at x0, m
    pub tension: [P; 2],
    /// x0, m
    pub rest: P,
    pub rim: Rim<P>,
}

/// The elastic rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rim<P> {
    /// a: the force a lambda, N/m
    pub across: P,
    /// b: the moment b psi, N m
    pub twist: P,
    /// d: the moment d psi on the disc about its axis, N m
    pub drill: P,
    /// alpha, 1/m^2
    pub curved_by_displacement: P,
    /// beta, 1/m
    pub curved_by_angle: P,
    /// masses that belong to lambda and psi, kg and kg m^2
    pub masses: [P; 2],
}

impl<P: Base> System<12> for ElasticGovernor<P> {
    type Given = P;

    fn masses<S: Over<P>>(&self) -> [S; 12] {
        let ([first, second, wheel], ball) = (self.inertia, self.ball);
        let [across, twist] = self.rim.masses;
        [first, second, wheel, self.sleeve, ball, ball, ball, ball, ball, ball, across, twist].map(S::lift)
    }

    fn force<S: Over<P>>(&self, at: &State<S, 12>) -> [S; 12] {
        let (x, lambda, psi) = (at.place[3], at.place[10], at.place[11]);
        let [first, second] = self.moments.map(S::lift);
        let ([c1, c2], [d1, d2]) = (self.stiffness.map(S::lift), self.tension.map(S::lift));
        let springs = -(c1 + c2) * (x - S::lift(self.rest)) - c1 * d1 + c2 * d2;
        let mut force = [S::zero(); 12];
        force[0] = first;
        force[1] = second + S::lift(self.rim.drill) * psi;
        force[3] = springs;
        force[10] = S::lift(self.rim.across) * lambda;
        force[11] = S::lift(self.rim.twist) * psi;
        force
    }
}

/// q = (phi1, phi2, phi, x, lambda, psi), p = (omega1, x').
impl<P: Base> Charted<12, 6, 2> for ElasticGovernor<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, q: [S; 6]) -> [S; 12] {
        let [phi1, phi2, phi, x, lambda, psi] = q;
        let (point, height) = (phi1.circle(), x.half());
        let arm = (S::lift(self.link).squared() - height.squared()).sqrt();
        let (across, along) = (arm * point.cos, arm * point.sin);
        [phi1, phi2, phi, x, across, along, height, -across, -along, height, lambda, psi]
    }

    fn rates<S: Over<P> + Analytic>(&self, _time: S, q: [S; 6], [speed, drift]: [S; 2]) -> [S; 6] {
        let [_, _, _, x, lambda, psi] = q;
        let rolled = S::lift(self.drum) * speed;
        let curvature = S::lift(self.rim.curved_by_displacement) * lambda - S::lift(self.rim.curved_by_angle) * psi;
        [
            speed,
            rolled / (x - S::lift(self.offset)),
            rolled / S::lift(self.wheel),
            drift,
            drift - rolled * psi,
            rolled * curvature,
        ]
    }
}

impl<P: Base> ElasticGovernor<P> {
    /// (omega1', x', x'', lambda', psi') at (omega1, x, x', lambda, psi); the angle of the drum is zero, which no equation
    /// can see.
    ///
    /// # Errors
    /// [`NotDefinite`] where neither the sleeve nor the balls have a mass.
    pub fn rates_of_state<S: Over<P> + Analytic>(&self, state: [S; 5]) -> Result<[S; 5], NotDefinite> {
        let [speed, x, drift, lambda, psi] = state;
        let zero = S::zero();
        let (q, p) = ([zero, zero, zero, x, lambda, psi], [speed, drift]);
        let motion: Motion<S, 12, 2> = Motion::at(self, zero, q, p);
        let [spin, push] = appell::rates(self, &motion, self.force(&motion.state))?;
        let [.., across, turn] = self.rates(zero, q, p);
        Ok([spin, drift, push, across, turn])
    }

    /// T + the energies of springs and rim, J.
    pub fn energy<S: Over<P> + Analytic>(&self, [speed, x, drift, lambda, psi]: [S; 5]) -> S {
        let zero = S::zero();
        let motion: Motion<S, 12, 2> = Motion::at(self, zero, [zero, zero, zero, x, lambda, psi], [speed, drift]);
        let moving: S = mechanics::constrained::kinetic_energy(self.masses(), motion.state.velocity);
        let ([c1, c2], [d1, d2]) = (self.stiffness.map(S::lift), self.tension.map(S::lift));
        let shift = x - S::lift(self.rest);
        let rim = S::lift(self.rim.across) * lambda.squared() + S::lift(self.rim.twist) * psi.squared();
        moving + ((c1 + c2) * shift.squared() - rim).half() + (c1 * d1 - c2 * d2) * shift
    }

    /// The same governor with the moment M1 and the tension delta2 that (omega1, x0, lambda = psi = 0) needs to be a
    /// motion; c2 must not vanish.
    pub fn stationary_at(self, speed: P) -> Self {
        let ([_, load], [c1, c2], [d1, _]) = (self.moments, self.stiffness, self.tension);
        let balanced = -self.drum * load / (self.rest - self.offset);
        let pull = self.ball.half() * self.rest * speed.squared() + c1 * d1;
        ElasticGovernor { moments: [balanced, load], tension: [d1, pull / c2], ..self }
    }

    /// The first approximation about (omega1, x0) with lambda = psi = 0, in (omega1, x, x', lambda, psi).
    ///
    /// # Errors
    /// As [`rates_of_state`](Self::rates_of_state).
    pub fn first_approximation<S: Over<P> + Analytic>(&self, speed: S) -> Result<[[S; 5]; 5], NotDefinite>
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
