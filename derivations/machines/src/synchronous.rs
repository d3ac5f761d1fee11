//! A synchronous motor without currents.

use field::{Base, Circle, Over};
use motor::{Entry, Machine, RotorState, letter};
use symbolic::Sym;

reader::quantities! {
    /// A magnetised rotor in the rotating field: U = -b0 cos g; friction m = -f phi'.
    pub struct Synchronous {
        /// speed of the stator's field
        field_speed: "rad/s",
        /// greatest torque of the field on the rotor
        b0: "N m",
        /// coefficient of viscous friction in the bearings
        f: "N m s" in friction,
    }
}

impl<P: Base> Machine<P> for Synchronous<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::AngleAndSpeed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.field_speed
    }

    #[inline(always)]
    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        -S::lift(self.b0) * angle.cos
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, _slip: S, speed: S) -> S {
        -S::lift(self.f) * speed
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "synchronous",
    summary: "synchronous without currents",
    data: Synchronous::<Sym>::QUANTITIES,
    counts: &[],
    write: |given| given.laws(&Synchronous::read(letter)?),
};
