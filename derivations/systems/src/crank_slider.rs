//! A crank-slider mechanism: a crank rotates about a fixed axis and moves, through a connecting rod, a slider on a line
//! through that axis.
//!
//! The coordinates are the angle of the crank and the position of the slider; the constraint fixes the length of the
//! rod. The rod's mass is replaced by point masses at its ends, which preserve its total mass and centre of mass, and
//! is included in the data of crank and slider.

use field::{Analytic, Base, Over};
use mechanics::constrained::energies::{Energies, Reducible};

reader::quantities! {
    /// The coordinates q = (angle of the crank from the slider's line, distance of the slider from the axis).
    pub struct CrankSlider {
        /// J, moment of inertia of what turns, with the rod's mass at the pin
        inertia: "kg m^2" > 0,
        /// m, mass of what slides, with the rod's mass at the slider
        mass: "kg" > 0,
        /// r, length of the crank
        crank: "m" > 0,
        /// l, length of the rod
        rod: "m" > 0,
        /// G, greatest moment of the weight about the axis, the slider's line being horizontal
        weight: "N m",
    }
}

impl<P: Base> CrankSlider<P> {
    /// The kinetic energy T = 1/2 J theta'^2 + 1/2 m x'^2.
    pub fn kinetic<S: Over<P>>(&self, [turning, sliding]: [S; 2]) -> S {
        (S::lift(self.inertia) * turning.squared() + S::lift(self.mass) * sliding.squared()).half()
    }

    /// The potential energy P = G sin theta.
    pub fn potential<S: Over<P> + Analytic>(&self, angle: S) -> S {
        S::lift(self.weight) * angle.circle().sin
    }

    /// The constraint f = (x - r cos theta)^2 + (r sin theta)^2 - l^2.
    pub fn closure<S: Over<P> + Analytic>(&self, [angle, slider]: [S; 2]) -> S {
        let (point, r) = (angle.circle(), S::lift(self.crank));
        (slider - r * point.cos).squared() + (r * point.sin).squared() - S::lift(self.rod).squared()
    }

    /// The position x = r cos theta + sqrt(l^2 - r^2 sin^2 theta) of the slider; the positive root is taken.
    pub fn slider<S: Over<P> + Analytic>(&self, angle: S) -> S {
        let (point, r) = (angle.circle(), S::lift(self.crank));
        r * point.cos + (S::lift(self.rod).squared() - (r * point.sin).squared()).sqrt()
    }
}

impl<P: Base> Energies<2, 1> for CrankSlider<P> {
    type Given = P;

    fn lagrangian<S: Over<P> + Analytic>(&self, _time: S, q: [S; 2], dq: [S; 2]) -> S {
        self.kinetic(dq) - self.potential(q[0])
    }

    fn dissipation<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 2], _dq: [S; 2]) -> S {
        S::zero()
    }

    fn force<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 2], _dq: [S; 2]) -> [S; 2] {
        [S::zero(); 2]
    }

    fn constraints<S: Over<P> + Analytic>(&self, _time: S, q: [S; 2]) -> [S; 1] {
        [self.closure(q)]
    }
}

impl<P: Base> Reducible<2, 1, 1> for CrankSlider<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [angle]: [S; 1]) -> [S; 2] {
        [angle, self.slider(angle)]
    }
}
