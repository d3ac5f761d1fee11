//! A rotor that turns by inertia without friction.

use super::{Catalogued, Datum, Machine, RotorState, Source};
use field::{Base, Over};

/// No moment about the axis: the classical gyrostat of section 8.2. Its speed is measured from zero.
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
    const ROTOR: RotorState = RotorState::Speed;

    #[inline(always)]
    fn frame_speed(&self) -> P {
        self.at_rest
    }

    #[inline(always)]
    fn moment_law<S: Over<P>>(&self, _slip: S, _speed: S) -> S {
        S::zero()
    }
}

impl Catalogued for FreeRotor<f64> {
    const SUMMARY: &'static str = "free rotor: by inertia, without friction";
    type Over<P: Datum> = FreeRotor<P>;

    fn read<P: Datum, E>(_source: &mut impl Source<P, Error = E>) -> Result<FreeRotor<P>, E> {
        Ok(FreeRotor::default())
    }
}
