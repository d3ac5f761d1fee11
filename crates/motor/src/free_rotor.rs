//! A rotor without motor and without friction.

use crate::{Entry, Machine, RotorState};
use field::{Base, Over};

/// No torque about the axis: the classical gyrostat of section 8.2. Its frame speed is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeRotor<P> {
    at_rest: P,
}

impl<P: Base> Default for FreeRotor<P> {
    fn default() -> Self {
        FreeRotor { at_rest: P::zero() }
    }
}

impl<P: Base> Machine<P> for FreeRotor<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::Speed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.at_rest
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, _slip: S, _speed: S) -> S {
        S::zero()
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "free_rotor",
    summary: "free rotor: turns by inertia alone, without friction",
    data: &[],
    counts: &[],
    write: |given| given.laws(&FreeRotor::default()),
};
