//! A crank-slider mechanism driven electrically: alternating voltage source, transformer, rectifier and direct-current
//! motor.
//!
//! Charges and currents are treated like displacements and velocities: an inductance corresponds to a mass, a capacitor
//! to a spring, a resistance to viscous friction. The branches are: 1 primary winding, 2 secondary winding, 3 smoothing
//! capacitor, 4 choke behind the diode bridge, 5 armature; 6 crank, 7 slider. Kirchhoff's law at the capacitor,
//! f3 = f4 - f5, is integrable: q3 = q4 - q5. Therefore the Lagrangian L needs no massless coordinate.
//!
//! * By symmetry two of the four diodes of the bridge carry the current (f4 + f2)/2 and two carry (f4 - f2)/2; their
//!   dissipation potentials (contents) are contained in D.
//! * The field of the motor is constant: the energy K q6 f5 gives the voltage -K f6 in the armature and the torque K f5
//!   on the crank. The total power of the two is zero.
//!
//! The rod couples q7 and its rate to q6 by a constraint; all other equations are explicit. Of the charges only q3
//! occurs in the equations, hence there are nine first-order equations in (f1, f2, q3, f4, f5, q6, f6, q7, f7).

use super::crank_slider::CrankSlider;
use field::{Analytic, Base, Over};
use mechanics::constrained::energies::{Energies, Reducible};

reader::quantities! {
    /// The electrical circuit, up to the motor.
    pub struct Circuit {
        /// amplitude of the source
        amplitude: "V",
        /// angular frequency of the source
        frequency: "rad/s",
        /// inductance of the primary winding with the source's
        l1: "H" > 0,
        /// inductance of the secondary winding
        l2: "H" > 0,
        /// mutual inductance; M^2 < L1 L2
        mutual: "H",
        /// resistance of the primary winding with the source's
        r1: "ohm" in resistance,
        /// resistance of the secondary winding
        r2: "ohm" in resistance,
        /// differential resistance of a diode far forwards
        forward: "ohm" > 0,
        /// differential resistance of a diode far backwards
        reverse: "ohm" > 0,
        /// the current over which a diode changes from one to the other
        knee: "A" > 0,
        /// capacitance of the smoothing capacitor
        c3: "A s/V" > 0,
        /// inductance of the choke
        l4: "H" > 0,
        /// resistance of the choke
        r4: "ohm" in resistance,
        /// inductance of the armature
        l5: "H" > 0,
        /// resistance of the armature
        r5: "ohm" in resistance,
        /// moment of the motor by its current
        motor: "N m/A",
        /// viscous friction of what turns
        b6: "N m s" in friction,
        /// viscous friction of what slides
        b7: "N s/m" in friction,
    }
}

/// Circuit and mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrankDrive<P> {
    pub circuit: Circuit<P>,
    pub mechanism: CrankSlider<P>,
}

impl<P: Base> CrankDrive<P> {
    /// The voltage of the source, E(t) = E0 sin(Omega t).
    pub fn source<S: Over<P> + Analytic>(&self, time: S) -> S {
        S::lift(self.circuit.amplitude) * (S::lift(self.circuit.frequency) * time).circle().sin
    }

    /// The content (integral of the voltage over the current) of a diode: 1/2 a i^2 - 1/2 d i (sqrt(i^2 + knee^2) -
    /// knee), where a and d are half the sum and half the difference of its two differential resistances. Its
    /// derivative is the voltage; the differential resistance lies between the two limits.
    pub fn diode<S: Over<P> + Analytic>(&self, current: S) -> S {
        let [forward, reverse, knee] = [self.circuit.forward, self.circuit.reverse, self.circuit.knee].map(S::lift);
        let (mean, half_gap) = ((reverse + forward).half(), (reverse - forward).half());
        let bent = (current.squared() + knee.squared()).sqrt() - knee;
        (mean * current.squared() - half_gap * current * bent).half()
    }

    /// The magnetic energy 1/2 sum L f^2 of the windings, including the mutual term M f1 f2 of the first two.
    pub fn magnetic<S: Over<P>>(&self, [f1, f2, f4, f5]: [S; 4]) -> S {
        let [l1, l2, l4, l5, mutual] =
            [self.circuit.l1, self.circuit.l2, self.circuit.l4, self.circuit.l5, self.circuit.mutual].map(S::lift);
        (l1 * f1.squared() + l2 * f2.squared() + l4 * f4.squared() + l5 * f5.squared()).half() + mutual * f1 * f2
    }
}

impl<P: Base> Energies<6, 1> for CrankDrive<P> {
    type Given = P;

    fn lagrangian<S: Over<P> + Analytic>(
        &self,
        _time: S,
        [_, _, q4, q5, q6, _]: [S; 6],
        [f1, f2, f4, f5, f6, f7]: [S; 6],
    ) -> S {
        let (capacitance, motor) = (S::lift(self.circuit.c3), S::lift(self.circuit.motor));
        let kinetic = self.magnetic([f1, f2, f4, f5]) + self.mechanism.kinetic([f6, f7]);
        let potential = (q4 - q5).squared().half() / capacitance + self.mechanism.potential(q6);
        kinetic - potential + motor * q6 * f5
    }

    fn dissipation<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 6], [f1, f2, f4, f5, f6, f7]: [S; 6]) -> S {
        let Circuit { r1, r2, r4, r5, b6, b7, .. } = self.circuit;
        let linear = [(r1, f1), (r2, f2), (r4, f4), (r5, f5), (b6, f6), (b7, f7)];
        let linear = linear.into_iter().fold(S::zero(), |sum, (r, f)| sum + S::lift(r) * f.squared());
        let bridge = self.diode((f4 + f2).half()) + self.diode((f4 - f2).half());
        linear.half() + bridge + bridge
    }

    fn force<S: Over<P> + Analytic>(&self, time: S, _q: [S; 6], _dq: [S; 6]) -> [S; 6] {
        let none = S::zero();
        [self.source(time), none, none, none, none, none]
    }

    fn constraints<S: Over<P> + Analytic>(&self, _time: S, [.., q6, q7]: [S; 6]) -> [S; 1] {
        [self.mechanism.closure([q6, q7])]
    }
}

impl<P: Base> Reducible<6, 1, 5> for CrankDrive<P> {
    fn place<S: Over<P> + Analytic>(&self, _time: S, [q1, q2, q4, q5, q6]: [S; 5]) -> [S; 6] {
        [q1, q2, q4, q5, q6, self.mechanism.slider(q6)]
    }
}
