//! A direct-current motor with brushes and permanent magnets at constant voltage.

use field::{Base, Circle, Over};
use motor::{Entry, Machine, RotorState, letter};
use symbolic::Sym;

reader::quantities! {
    /// The equations L i' = v - R i - k phi', M = k i - f phi', where k is the flux. The commutator keeps the armature
    /// current orthogonal to the field of the magnets while the conductors move through it; the laws do not depend on
    /// the angle.
    pub struct Brushed {
        /// voltage at the brushes
        voltage: "V",
        /// flux of the magnets: voltage per speed of the rotor, and torque per current
        flux: "Wb",
        /// inductance of the armature
        inductance: "H" > 0,
        /// resistance of armature and brushes
        resistance: "ohm" in resistance,
        /// coefficient of viscous friction in the bearings
        f: "N m s" in friction,
    }
}

impl<P: Base> Machine<P> for Brushed<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::Speed
    }

    /// The field is fixed in the housing: W = 0.
    #[inline(always)]
    fn frame_speed(&self) -> P {
        P::zero()
    }

    #[inline(always)]
    fn windings(&self) -> usize {
        1
    }

    fn current_name(&self, _winding: usize) -> String {
        "i".into()
    }

    #[inline(always)]
    fn inductance(&self, _winding: usize) -> P {
        self.inductance
    }

    #[inline(always)]
    fn resistance(&self, _winding: usize) -> P {
        self.resistance
    }

    #[inline(always)]
    fn supply<S: Over<P>>(&self, _winding: usize, _angle: Circle<S>) -> Option<S> {
        Some(S::lift(self.voltage))
    }

    #[inline(always)]
    fn motional<S: Over<P>>(&self, _winding: usize, _currents: &[S]) -> Option<S> {
        Some(S::lift(self.flux))
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, _slip: S, speed: S) -> S {
        -S::lift(self.f) * speed
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "brushed",
    summary: "direct current through brushes, with the armature's current",
    data: Brushed::<Sym>::QUANTITIES,
    counts: &[],
    write: |given| given.laws(&Brushed::read(letter)?),
};
