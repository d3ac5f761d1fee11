//! A machine with a constant load torque on its rotor.

use super::{Machine, RotorState};
use field::{Base, Circle, Over};

/// A machine with a constant load torque (N m) against the rotation.
#[derive(Clone, Copy, Debug)]
pub struct Loaded<M, P> {
    pub machine: M,
    pub load: P,
}

impl<P: Base, M: Machine<P>> Machine<P> for Loaded<M, P> {
    fn rotor(&self) -> RotorState {
        self.machine.rotor()
    }

    fn frame_speed(&self) -> P {
        self.machine.frame_speed()
    }

    fn windings(&self) -> usize {
        self.machine.windings()
    }

    fn current_name(&self, winding: usize) -> String {
        self.machine.current_name(winding)
    }

    fn inductance(&self, winding: usize) -> P {
        self.machine.inductance(winding)
    }

    fn resistance(&self, winding: usize) -> P {
        self.machine.resistance(winding)
    }

    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        self.machine.linkage(winding, angle)
    }

    fn supply<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> Option<S> {
        self.machine.supply(winding, angle)
    }

    fn motional<S: Over<P>>(&self, winding: usize, currents: &[S]) -> Option<S> {
        self.machine.motional(winding, currents)
    }

    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        self.machine.field_energy(angle)
    }

    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        self.machine.torque_law(slip, speed) - S::lift(self.load)
    }
}
