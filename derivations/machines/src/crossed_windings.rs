//! An asynchronous motor with two orthogonal windings on its rotor, after Leonov.

use field::{Base, Circle, Over};
use motor::{Entry, Machine, RotorState, letter};
use symbolic::Sym;

reader::quantities! {
    /// The flux linkages psi_1 = a cos g, psi_2 = a sin g with the flux a: short-circuited windings without magnet and
    /// excitation, whose currents depend on the slip only; m = -f phi'.
    pub struct CrossedWindings {
        /// speed of the stator's field
        field_speed: "rad/s",
        /// greatest flux of the field through a winding
        flux: "Wb",
        /// inductance of a winding
        inductance: "H" > 0,
        /// resistance of a winding
        resistance: "ohm" in resistance,
        /// coefficient of viscous friction in the bearings
        f: "N m s" in friction,
    }
}

impl<P: Base> Machine<P> for CrossedWindings<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::AngleAndSpeed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.field_speed
    }

    #[inline(always)]
    fn windings(&self) -> usize {
        2
    }

    fn current_name(&self, winding: usize) -> String {
        format!("i{}", winding + 1)
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
    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        S::lift(self.flux) * if winding == 0 { angle.cos } else { angle.sin }
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, _slip: S, speed: S) -> S {
        -S::lift(self.f) * speed
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "crossed_windings",
    summary: "asynchronous with the currents of two windings at right angles",
    data: CrossedWindings::<Sym>::QUANTITIES,
    counts: &[],
    write: |given| given.laws(&CrossedWindings::read(letter)?),
};
