//! The synchronous motor without currents.

use super::{Catalogued, Datum, Machine, RotorState, Source};
use field::{Base, Circle, Over};

crate::quantities! {
    /// A magnetised rotor in the turning field: U = -b0 cos g; friction m = -f phi'.
    pub struct Synchronous {
        /// speed of the stator's field
        field_speed: "rad/s",
        /// greatest moment of the field on the rotor
        b0: "N m",
        /// viscous friction in the bearings
        f: "N m s" in friction,
    }
}

impl<P: Base> Machine<P> for Synchronous<P> {
    const ROTOR: RotorState = RotorState::AngleAndSpeed;

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.field_speed
    }

    #[inline(always)]
    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        -S::lift(self.b0) * angle.cos
    }

    #[inline(always)]
    fn moment_law<S: Over<P>>(&self, _slip: S, speed: S) -> S {
        -S::lift(self.f) * speed
    }
}

impl Catalogued for Synchronous<f64> {
    const SUMMARY: &'static str = "synchronous without currents";
    type Over<P: Datum> = Synchronous<P>;

    fn read<P: Datum, E>(source: &mut impl Source<P, Error = E>) -> Result<Synchronous<P>, E> {
        Synchronous::read(|quantity| source.quantity(quantity))
    }
}
