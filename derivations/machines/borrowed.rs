//! A machine that is looked at is a machine.

use super::{Machine, RotorState};
use field::{Base, Circle, Over};

impl<P: Base, M: Machine<P>> Machine<P> for &M {
    const ROTOR: RotorState = M::ROTOR;
    const WRITTEN: bool = M::WRITTEN;

    fn frame_speed(&self) -> P {
        M::frame_speed(self)
    }

    fn windings(&self) -> usize {
        M::windings(self)
    }

    fn inductance(&self, winding: usize) -> P {
        M::inductance(self, winding)
    }

    fn resistance(&self, winding: usize) -> P {
        M::resistance(self, winding)
    }

    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        M::linkage(self, winding, angle)
    }

    fn supply<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> Option<S> {
        M::supply(self, winding, angle)
    }

    fn motional<S: Over<P>>(&self, winding: usize, currents: &[S]) -> Option<S> {
        M::motional(self, winding, currents)
    }

    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        M::field_energy(self, angle)
    }

    fn moment_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        M::moment_law(self, slip, speed)
    }
}
