//! Chapter 3's governors with a rigid wheel in the paper's symbols: `systems/governor` with symbolic data.

use super::alphabet::{letter, letters, tidy};
use claims::Condition;
use field::{Analytic, Scalar};
use mechanics::constrained::motion::Motion;
use mechanics::constrained::{PointSystem, State, kinetic_energy};
use symbolic::{Hypotheses, Sym};
use systems::governor::{Gearing, Governor, Torque};

/// The symbols of sections 3.1 and 3.2, and a governor in these symbols.
pub struct GovernorLetters {
    pub governor: Governor<Sym>,
    pub first: Sym,
    pub second: Sym,
    pub wheel: Sym,
    pub mass: Sym,
    pub drum: Sym,
    pub radius: Sym,
    pub distance: Sym,
    pub m1: Sym,
    pub m2: Sym,
    pub friction: Sym,
    pub push: Sym,
    pub rho: Sym,
    pub drho: Sym,
    pub ddrho: Sym,
    pub speed: Sym,
    pub dspeed: Sym,
}

impl GovernorLetters {
    /// The governor with a drum (section 3.1).
    pub fn with_drum() -> Self {
        Self::new(|drum, _| Gearing::Drum { radius: drum })
    }

    /// The second governor, with two discs.
    pub fn with_discs() -> Self {
        Self::new(|_, distance| Gearing::Discs { distance })
    }

    fn new(gearing: impl Fn(Sym, Sym) -> Gearing<Sym>) -> Self {
        let [first, second, wheel, mass, drum, radius, distance] = letters(["J1", "J2", "J", "m", "R", "r", "aᵈ"]);
        let [m1, m2, growth1, growth2, push] = letters(["M1", "M2", "Ṁ1", "Ṁ2", "u"]);
        let friction = letter("F₁₁") + letter("F₂₂");
        let [rho, drho, ddrho, speed, dspeed] = letters(["ϱ", "ϱ̇", "ϱ̈", "ω2", "ω̇2"]);
        let moments = [Torque { start: m1, growth: growth1 }, Torque { start: m2, growth: growth2 }];
        let governor = Governor {
            inertia: [first, second, wheel],
            mass,
            radius,
            gearing: gearing(drum, distance),
            moments,
            push,
            lateral: friction,
        };
        GovernorLetters {
            governor,
            first,
            second,
            wheel,
            mass,
            drum,
            radius,
            distance,
            m1,
            m2,
            friction,
            push,
            rho,
            drho,
            ddrho,
            speed,
            dspeed,
        }
    }

    /// The motion at (rho, omega2, rho'), at a position where the discs' directions are along the axes.
    pub fn motion(&self) -> Motion<Sym, 7, 2> {
        let zero = Sym::ZERO;
        Motion::at(&self.governor, zero, [zero, zero, zero, self.rho], [self.speed, self.drho])
    }

    /// The state of three bodies with any angular velocities and directions.
    pub fn turning(&self, speeds: [Sym; 3]) -> State<Sym, 7> {
        let [first, second, wheel] = letters(["α", "θ", "φ"]).map(Analytic::circle);
        let [w1, w2, w] = speeds;
        State {
            time: Sym::ZERO,
            place: [first.cos, first.sin, second.cos, second.sin, wheel.cos, wheel.sin, self.rho],
            velocity: [
                -first.sin * w1,
                first.cos * w1,
                -second.sin * w2,
                second.cos * w2,
                -wheel.sin * w,
                wheel.cos * w,
                self.drho,
            ],
        }
    }

    /// The accelerations of the coordinates.
    pub fn acceleration(&self) -> [Sym; 7] {
        self.motion().acceleration([self.dspeed, self.ddrho])
    }

    /// The acceleration energy S = 1/2 sum m x''^2 of the bodies.
    pub fn acceleration_energy(&self) -> Sym {
        tidy(kinetic_energy(self.governor.masses(), self.acceleration()))
    }

    /// The angular velocities and accelerations of first disc, second disc and wheel.
    pub fn spins(&self) -> [[Sym; 2]; 3] {
        let (velocity, acceleration) = (self.motion().state.velocity, self.acceleration());
        [1, 3, 5].map(|tangent| [velocity[tangent], acceleration[tangent]])
    }

    /// The residuals dS'/dp' - Q' of omega2 and of rho.
    pub fn balance(&self) -> [Sym; 2] {
        self.governor.balance(Sym::ZERO, self.rho, [self.speed, self.drho], [self.dspeed, self.ddrho]).map(tidy)
    }

    /// The residuals dS'/dp' - Q' at the prescribed speed, omega2' = 0.
    pub fn kept(&self) -> [Sym; 2] {
        self.balance().map(|side| tidy(side.substitute(&[(self.dspeed, Sym::ZERO)])))
    }

    /// The coefficient n = J1/R^2 + J/r^2.
    pub fn reduced(&self) -> Sym {
        self.first / self.drum.powi(2) + self.wheel / self.radius.powi(2)
    }

    /// The values of k, k1, k2 by (3.4).
    pub fn names(&self) -> Hypotheses {
        let [k, k1, k2] = letters(["k", "k₁", "k₂"]);
        let square = self.radius.squared();
        Hypotheses::none()
            .given(k, self.speed * (self.wheel + self.first * square / self.drum.squared()))
            .given(k1, square * self.m2)
            .given(k2, square * self.m1 / self.drum)
    }

    /// The conditions that lengths and inertias of the governor are positive.
    pub fn real(&self) -> [Condition; 6] {
        [self.first, self.second, self.wheel, self.mass, self.drum, self.radius].map(Condition::Positive)
    }
}
