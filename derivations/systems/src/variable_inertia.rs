//! Systems with one degree of freedom, variable inertia, losses and a control: d/dt(m(t) y') + w(y, y', t) = u(y, y',
//! t).
//!
//! y is the amount produced, the amount learned, the angle or the distance; y' is the production capacity, the rate of
//! learning, the angular velocity or the velocity. The law is the balance of the momentum m y' and therefore includes
//! m' y'. For a point of variable mass it is valid if the mass that leaves or arrives has zero absolute velocity.

use field::{Analytic, Base, Over, Tangent};

/// A law of this form.
pub trait Growth {
    /// The scalar type of the parameters.
    type Given: Base;

    /// The inertia m(t): funds per capacity, inertia of learning, moment of inertia, mass.
    fn inertia<S: Over<Self::Given>>(&self, time: S) -> S;

    /// The losses w(y, y', t): wear, rejection of known information, disturbing torques, resistance.
    fn loss<S: Over<Self::Given> + Analytic>(&self, time: S, y: S, speed: S) -> S;

    /// The control u(y, y', t): new funds, potential information, torque of the motor, reaction force.
    fn control<S: Over<Self::Given> + Analytic>(&self, time: S, y: S, speed: S) -> S;

    /// The residual d/dt(m y') + w - u along y(t), with y' = `speed` and y'' = `acceleration`.
    fn residual<S: Over<Self::Given> + Analytic>(&self, time: S, [y, speed, acceleration]: [S; 3]) -> S {
        let momentum = self.inertia(Tangent::variable(time)) * Tangent::moving(speed, acceleration);
        momentum.slope + self.loss(time, y, speed) - self.control(time, y, speed)
    }

    /// The acceleration y'' by the law; the inertia must not be zero.
    fn acceleration<S: Over<Self::Given> + Analytic>(&self, time: S, y: S, speed: S) -> S {
        -self.residual(time, [y, speed, S::zero()]) / self.inertia(time)
    }
}

/// A production plant: m is the funds per capacity; a constant fraction of the funds wears out per unit of time; new
/// funds arrive at the rate u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plant<P> {
    /// The funds per capacity m at t = 0.
    pub fund: P,
    /// The rate m'.
    pub fund_rate: P,
    /// The fraction of the funds m y' that is lost per unit of time.
    pub wear: P,
    /// The rate u of new funds.
    pub supply: P,
}

/// A law of learning: (L I')' + (tau - I') I' + I/G = M.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Learning<P> {
    /// The inertia L.
    pub inertia: P,
    /// The coefficient tau.
    pub denial: P,
    /// The coefficient G.
    pub permeability: P,
    /// The potential M.
    pub potential: P,
}

/// A link of a manipulator with a load that moves along it; it rotates about a horizontal axis, and phi is measured
/// from the horizontal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<P> {
    /// The moment of inertia of the link.
    pub link: P,
    /// The mass of the load.
    pub load: P,
    /// The distance of the load from the axis at t = 0.
    pub distance: P,
    /// The constant rate of that distance.
    pub rate: P,
    /// The acceleration of gravity g.
    pub gravity: P,
    /// The torque of the motor.
    pub motor: P,
}

/// A point of variable mass on a line: (m x')' + beta x' + k x = R.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VariablePoint<P> {
    /// The mass m at t = 0.
    pub mass: P,
    /// The rate m'.
    pub mass_rate: P,
    /// The coefficient beta of resistance.
    pub resistance: P,
    /// The stiffness k.
    pub stiffness: P,
    /// The force R.
    pub push: P,
}

impl<P: Base> Growth for Plant<P> {
    type Given = P;

    fn inertia<S: Over<P>>(&self, time: S) -> S {
        S::lift(self.fund) + S::lift(self.fund_rate) * time
    }

    fn loss<S: Over<P> + Analytic>(&self, time: S, _y: S, speed: S) -> S {
        S::lift(self.wear) * self.inertia(time) * speed
    }

    fn control<S: Over<P> + Analytic>(&self, _time: S, _y: S, _speed: S) -> S {
        S::lift(self.supply)
    }
}

impl<P: Base> Growth for Learning<P> {
    type Given = P;

    fn inertia<S: Over<P>>(&self, _time: S) -> S {
        S::lift(self.inertia)
    }

    fn loss<S: Over<P> + Analytic>(&self, _time: S, y: S, speed: S) -> S {
        (S::lift(self.denial) - speed) * speed + y / S::lift(self.permeability)
    }

    fn control<S: Over<P> + Analytic>(&self, _time: S, _y: S, _speed: S) -> S {
        S::lift(self.potential)
    }
}

impl<P: Base> Joint<P> {
    /// The distance of the load from the axis.
    pub fn reach<S: Over<P>>(&self, time: S) -> S {
        S::lift(self.distance) + S::lift(self.rate) * time
    }
}

impl<P: Base> Growth for Joint<P> {
    type Given = P;

    fn inertia<S: Over<P>>(&self, time: S) -> S {
        S::lift(self.link) + S::lift(self.load) * self.reach(time).squared()
    }

    fn loss<S: Over<P> + Analytic>(&self, time: S, angle: S, _speed: S) -> S {
        S::lift(self.load) * S::lift(self.gravity) * self.reach(time) * angle.circle().cos
    }

    fn control<S: Over<P> + Analytic>(&self, _time: S, _angle: S, _speed: S) -> S {
        S::lift(self.motor)
    }
}

impl<P: Base> Growth for VariablePoint<P> {
    type Given = P;

    fn inertia<S: Over<P>>(&self, time: S) -> S {
        S::lift(self.mass) + S::lift(self.mass_rate) * time
    }

    fn loss<S: Over<P> + Analytic>(&self, _time: S, x: S, speed: S) -> S {
        S::lift(self.resistance) * speed + S::lift(self.stiffness) * x
    }

    fn control<S: Over<P> + Analytic>(&self, _time: S, _x: S, _speed: S) -> S {
        S::lift(self.push)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use symbolic::{Hypotheses, Sym, decide};

    #[test]
    fn the_acceleration_that_is_integrated_satisfies_the_law() {
        fn keeps(law: &impl Growth<Given = Sym>) {
            let [time, y, speed] = ["t", "y", "v"].map(Sym::symbol);
            let acceleration = law.acceleration(time, y, speed);
            assert!(decide(law.residual(time, [y, speed, acceleration]), &Hypotheses::none()).is_zero());
        }
        let [a, b, c, d, e, f] = ["a", "b", "c", "d", "e", "f"].map(Sym::symbol);
        keeps(&Plant { fund: a, fund_rate: b, wear: c, supply: d });
        keeps(&Learning { inertia: a, denial: b, permeability: c, potential: d });
        keeps(&Joint { link: a, load: b, distance: c, rate: d, gravity: e, motor: f });
        keeps(&VariablePoint { mass: a, mass_rate: b, resistance: c, stiffness: d, push: e });
    }
}
