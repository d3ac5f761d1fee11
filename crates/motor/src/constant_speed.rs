//! A rotor at a prescribed constant speed relative to the carrier; its torque is the reaction.

use crate::{Entry, Machine, RotorState, letter};
use field::{Base, Over};
use symbolic::Sym;

reader::quantities! {
    /// The rotor with phi' = W: the classical gyrostat of section 8.1.
    pub struct ConstantSpeed {
        /// relative speed of the rotor
        speed: "rad/s",
    }
}

impl<P: Base> Machine<P> for ConstantSpeed<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::Prescribed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.speed
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, _slip: S, _speed: S) -> S {
        S::zero()
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "constant_speed",
    summary: "constant relative speed",
    data: ConstantSpeed::<Sym>::QUANTITIES,
    counts: &[],
    write: |given| given.laws(&ConstantSpeed::read(letter)?),
};
