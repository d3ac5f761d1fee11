//! An asynchronous motor without currents: the torque is linear in the slip.

use field::{Base, Over};
use motor::{Entry, Machine, RotorState, letter};
use symbolic::Sym;

reader::quantities! {
    /// The torque m = -k (phi' - W) - f phi'.
    pub struct Asynchronous {
        /// speed of the stator's field
        field_speed: "rad/s",
        /// slope of the torque against slip
        k: "N m s" in friction,
        /// coefficient of viscous friction in the bearings
        f: "N m s" in friction,
    }
}

impl<P: Base> Machine<P> for Asynchronous<P> {
    #[inline(always)]
    fn rotor(&self) -> RotorState {
        RotorState::Speed
    }

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.field_speed
    }

    #[inline(always)]
    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        let Asynchronous { k, f, .. } = self.map(S::lift);
        -(k * slip + f * speed)
    }
}

/// The entry in the catalogue of motors.
pub const ENTRY: Entry = Entry {
    name: "asynchronous",
    summary: "asynchronous without currents, torque linear in the slip",
    data: Asynchronous::<Sym>::QUANTITIES,
    counts: &[],
    write: |given| given.laws(&Asynchronous::read(letter)?),
};
