//! The asynchronous motor without currents, moment linear in the slip.

use super::{Catalogued, Datum, Machine, RotorState, Source};
use field::{Base, Over};

crate::quantities! {
    /// m = -k (phi' - W) - f phi'.
    pub struct Asynchronous {
        /// speed of the stator's field
        field_speed: "rad/s",
        /// slope of the moment against slip
        k: "N m s" in friction,
        /// viscous friction in the bearings
        f: "N m s" in friction,
    }
}

impl<P: Base> Machine<P> for Asynchronous<P> {
    const ROTOR: RotorState = RotorState::Speed;

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.field_speed
    }

    #[inline(always)]
    fn moment_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        let Asynchronous { k, f, .. } = self.map(S::lift);
        -(k * slip + f * speed)
    }
}

impl Catalogued for Asynchronous<f64> {
    const SUMMARY: &'static str = "asynchronous without currents, moment linear in the slip";
    type Over<P: Datum> = Asynchronous<P>;

    fn read<P: Datum, E>(source: &mut impl Source<P, Error = E>) -> Result<Asynchronous<P>, E> {
        Asynchronous::read(|quantity| source.quantity(quantity))
    }
}
