//! A rotor that is kept at a constant speed relative to the carrier, whatever moment that takes.

use super::{Catalogued, Datum, Machine, RotorState, Source};
use field::{Base, Over};

crate::quantities! {
    /// phi' = W for ever: the classical gyrostat of section 8.1.
    pub struct ConstantSpeed {
        /// relative speed of the rotor
        speed: "rad/s",
    }
}

impl<P: Base> Machine<P> for ConstantSpeed<P> {
    const ROTOR: RotorState = RotorState::Prescribed;

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.speed
    }

    #[inline(always)]
    fn moment_law<S: Over<P>>(&self, _slip: S, _speed: S) -> S {
        S::zero()
    }
}

impl Catalogued for ConstantSpeed<f64> {
    const SUMMARY: &'static str = "constant relative speed";
    type Over<P: Datum> = ConstantSpeed<P>;

    fn read<P: Datum, E>(source: &mut impl Source<P, Error = E>) -> Result<ConstantSpeed<P>, E> {
        ConstantSpeed::read(|quantity| source.quantity(quantity))
    }
}
