//! The prescribed motion (programme) of the wheel between two discs under constant torques: a quadrature in closed
//! form.
//!
//! The equation is (A + B/rho^3) rho' = -r (M1/rho + M2/(a - rho)) with A = J omega2/r, B = J1 omega2 a r. Therefore
//!
//!   -r t = integral of (A rho (a - rho) + B (a - rho)/rho^2) / D(rho),   D = M1 (a - rho) + M2 rho .
//!
//! The integrand is rational; its integral is a sum of powers, reciprocals and two logarithms. The inverse function
//! rho(t) has no closed form. The wheel approaches the axis of the first disc in infinite time; at the axis of the
//! second disc rho' becomes infinite.

use super::constant::ProgrammeEnd;
use super::{Gearing, Governor};
use field::{Base, Scalar};

/// The law of the programme for a prescribed speed of the second shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Between<P> {
    /// The coefficient A = J omega2/r.
    pub wheel: P,
    /// The coefficient B = J1 omega2 a r.
    pub first: P,
    /// The radius r of the wheel.
    pub radius: P,
    /// The distance a of the axes.
    pub distance: P,
    /// The torques M1, M2.
    pub moments: [P; 2],
}

/// The function t(rho), up to a constant, as a linear combination of elementary functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadrature<S> {
    /// The coefficients of rho^3, rho^2, rho.
    pub powers: [S; 3],
    /// The coefficients of 1/rho, 1/rho^2.
    pub reciprocals: [S; 2],
    /// The coefficients of ln rho and ln |D|.
    pub logarithms: [S; 2],
}

impl<P: Base> Governor<P> {
    /// The law between two discs for a prescribed speed, with the torques at t = 0; `None` for a drum.
    pub fn between(&self, speed: P) -> Option<Between<P>> {
        let Gearing::Discs { distance } = self.gearing else { return None };
        let [first, _, wheel] = self.inertia;
        Some(Between {
            wheel: wheel * speed / self.radius,
            first: first * speed * distance * self.radius,
            radius: self.radius,
            distance,
            moments: self.moments.map(|moment| moment.start),
        })
    }
}

impl<S: Scalar> Between<S> {
    /// The denominator D(rho): the torque on the wheel, multiplied by both levers.
    pub fn pull(&self, rho: S) -> S {
        self.moments[0] * (self.distance - rho) + self.moments[1] * rho
    }

    /// The quadrature for M1 != 0 and M1 != M2.
    pub fn general(&self) -> Quadrature<S> {
        let (a, [m1, m2]) = (self.distance, self.moments);
        let gap = m2 - m1;
        let logarithm = m2 / (m1.squared() * a);
        self.scaled(
            [S::zero(), -S::one() / (gap + gap), a * m2 / gap.squared()],
            -m1 * m2 * a.squared() / (gap.squared() * gap),
            [-S::one() / m1, S::zero()],
            [-logarithm, logarithm],
        )
    }

    /// The quadrature for M1 = M2 != 0.
    pub fn equal(&self) -> Quadrature<S> {
        let (a, m) = (self.distance, self.moments[0]);
        let third = S::one() / (S::int(3) * m * a);
        let reciprocals = [-S::one() / m, S::zero()];
        self.scaled([-third, S::one() / (m + m), S::zero()], S::zero(), reciprocals, [-S::one() / (m * a), S::zero()])
    }

    /// The quadrature for M1 = 0 != M2.
    pub fn free_first(&self) -> Quadrature<S> {
        let (a, m) = (self.distance, self.moments[1]);
        let half = S::one() / (m + m);
        self.scaled([S::zero(), -half, a / m], S::zero(), [S::one() / m, -a * half], [S::zero(); 2])
    }

    /// The quadrature: A times the powers and their ln |D|, plus B times the reciprocals and their logarithms, divided
    /// by -r.
    fn scaled(&self, powers: [S; 3], of_powers: S, reciprocals: [S; 2], logarithms: [S; 2]) -> Quadrature<S> {
        let [by_wheel, by_first] = [self.wheel, self.first].map(|inertia| -inertia / self.radius);
        let [of_rho, of_pull] = logarithms.map(|factor| by_first * factor);
        Quadrature {
            powers: powers.map(|factor| by_wheel * factor),
            reciprocals: reciprocals.map(|factor| by_first * factor),
            logarithms: [of_rho, of_pull + by_wheel * of_powers],
        }
    }

    /// The derivative dt/drho of a quadrature.
    pub fn slope(&self, of: &Quadrature<S>, rho: S) -> S {
        let Quadrature { powers: [cube, square, linear], reciprocals: [one, two], logarithms: [near, far] } = *of;
        let polynomial = (S::int(3) * cube * rho + S::int(2) * square) * rho + linear;
        let rate = self.moments[1] - self.moments[0];
        polynomial - (one + S::int(2) * two / rho) / rho.squared() + near / rho + far * rate / self.pull(rho)
    }
}

impl Between<f64> {
    /// The time, s, at which the wheel passes rho on its way from `start`; NaN if it never does. Near M1 = M2 there is
    /// cancellation of terms of magnitude (a M1/(M1 - M2))^3.
    pub fn time(&self, start: f64, rho: f64) -> f64 {
        let (from, to) = (self.pull(start), self.pull(rho));
        if from * to <= 0.0 && from != to {
            return f64::NAN;
        }
        let [m1, m2] = self.moments;
        let Quadrature { powers: [cube, square, linear], reciprocals: [one, two], logarithms: [near, far] } =
            if m1 == 0.0 {
                self.free_first()
            } else if m1 == m2 {
                self.equal()
            } else {
                self.general()
            };
        let (step, sum) = (rho - start, rho + start);
        let polynomial = step * (cube * (sum * sum - rho * start) + square * sum + linear);
        let reciprocal = -step / (rho * start) * (one + two * sum / (rho * start));
        let logarithm = |ratio: f64, factor: f64| if factor == 0.0 { 0.0 } else { factor * ratio.ln() };
        polynomial + reciprocal + logarithm(rho / start, near) + logarithm(to / from, far)
    }

    /// The long-time behaviour of the motion from `start`.
    pub fn course(&self, start: f64) -> ProgrammeEnd {
        let [m1, m2] = self.moments;
        let outwards = -self.pull(start) / self.first;
        // without a torque on the second shaft the equilibrium is at the axis of that shaft
        let balance = if m2 == 0.0 { self.distance } else { m1 * self.distance / (m1 - m2) };
        let attracts = (m2 - m1) / self.first > 0.0;
        if outwards == 0.0 {
            ProgrammeEnd::Rest
        } else if attracts && 0.0 < balance && balance <= self.distance {
            ProgrammeEnd::TendsTo { distance: balance }
        } else if outwards > 0.0 {
            ProgrammeEnd::ReachesAxis { time: self.time(start, self.distance) }
        } else {
            ProgrammeEnd::TendsTo { distance: 0.0 }
        }
    }

    /// The distance rho at an instant, by inversion of the quadrature; `None` after the end of the motion.
    pub fn distance_at(&self, start: f64, time: f64) -> Option<f64> {
        let goal = match self.course(start) {
            ProgrammeEnd::Rest => return Some(start),
            ProgrammeEnd::ReachesAxis { time: end } if time >= end => return None,
            ProgrammeEnd::ReachesAxis { .. } | ProgrammeEnd::Grows => self.distance,
            ProgrammeEnd::TendsTo { distance } => distance,
        };
        // the time is monotone along the motion: bisection between start and goal
        let (mut passed, mut ahead) = (start, goal);
        loop {
            let middle = 0.5 * (passed + ahead);
            if middle == passed || middle == ahead {
                return Some(middle);
            }
            if self.time(start, middle) <= time { passed = middle } else { ahead = middle }
        }
    }
}
