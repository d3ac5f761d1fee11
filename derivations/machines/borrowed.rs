//! A machine that is looked at is a machine.

use super::{Machine, RotorState};
use field::{Base, Circle, Over};

impl<P: Base, M: Machine<P>> Machine<P> for &M {
    const ROTOR: RotorState = M::ROTOR;
    const WRITTEN: bool = M::WRITTEN;

    #[inline(always)]
    fn frame_speed(&self) -> P {
        M::frame_speed(self)
    }

    #[inline(always)]
    fn windings(&self) -> usize {
        M::windings(self)
    }

    #[inline(always)]
    fn inductance(&self, winding: usize) -> P {
        M::inductance(self, winding)
    }

    #[inline(always)]
    fn resistance(&self, winding: usize) -> P {
        M::resistance(self, winding)
    }

    #[inline(always)]
    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        M::linkage(self, winding, angle)
    }

    #[inline(always)]
    fn supply<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> Option<S> {
        M::supply(self, winding, angle)
    }

    #[inline(always)]
    fn motional<S: Over<P>>(&self, winding: usize, currents: &[S]) -> Option<S> {
        M::motional(self, winding, currents)
    }

    #[inline(always)]
    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        M::field_energy(self, angle)
    }

    #[inline(always)]
    fn moment_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        M::moment_law(self, slip, speed)
    }
}
