//! A motor that is written in a scene file: its laws are expressions, evaluated over any field like those of the others.
//!
//! [`Letters`] says what an expression may be made of, [`Laws`] holds the expressions as straight-line programs, [`Text`]
//! is the machine. What is derived from energies and laws of force is derived from these in the same way.

mod laws;
mod letters;

pub use laws::{FIELD_SPEED, Laws, TooLong, Winding};
pub use letters::{ANGLE, INDUCED, Letters, Motion, SLIP, SPEED, is_taken};

use super::{Catalogued, Datum, Machine, Quantity, RotorState, Source};
use field::{Base, Circle, Over};
use std::fmt::Debug;
use std::marker::PhantomData;
use std::sync::Arc;

/// The name of the model in scene files.
pub const NAME: &str = "text";

/// What the laws of a written motor know of its rotor.
pub trait Knows: Copy + Debug + Send + Sync + 'static {
    const ROTOR: RotorState;
}

/// Laws of slip and speed alone.
#[derive(Clone, Copy, Debug)]
pub struct OfSpeed;

/// Laws of the angle to the field too.
#[derive(Clone, Copy, Debug)]
pub struct OfAngle;

impl Knows for OfSpeed {
    const ROTOR: RotorState = RotorState::Speed;
}

impl Knows for OfAngle {
    const ROTOR: RotorState = RotorState::AngleAndSpeed;
}

/// A motor with laws from a text. `K` is what they know, as [`Laws::rotor`] says.
#[derive(Clone, Debug)]
pub struct Text<P, K> {
    laws: Arc<Laws>,
    /// The parameters in their order, then what the laws need of them alone.
    numbers: Vec<P>,
    knows: PhantomData<K>,
}

impl<P: Datum, K: Knows> Text<P, K> {
    /// With the parameters from a source.
    ///
    /// # Errors
    /// Those of the source.
    pub fn new<E>(laws: Arc<Laws>, source: impl FnMut(&Quantity) -> Result<P, E>) -> Result<Self, E> {
        let given = laws.parameters().iter().map(source).collect::<Result<Vec<P>, E>>()?;
        Ok(Text { numbers: laws.numbers(given), laws, knows: PhantomData })
    }
}

impl<P: Base, K: Knows> Machine<P> for Text<P, K> {
    const ROTOR: RotorState = K::ROTOR;
    const WRITTEN: bool = true;

    fn frame_speed(&self) -> P {
        self.laws.field_speed(&self.numbers)
    }

    fn windings(&self) -> usize {
        self.laws.windings()
    }

    fn current_name(&self, winding: usize) -> String {
        self.laws.current(winding)
    }

    fn inductance(&self, winding: usize) -> P {
        self.laws.inductance(winding, &self.numbers)
    }

    fn resistance(&self, winding: usize) -> P {
        self.laws.resistance(winding, &self.numbers)
    }

    fn linkage<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> S {
        self.laws.flux(winding, angle, &self.numbers)
    }

    fn supply<S: Over<P>>(&self, winding: usize, angle: Circle<S>) -> Option<S> {
        self.laws.supply(winding, angle, &self.numbers)
    }

    fn motional<S: Over<P>>(&self, winding: usize, currents: &[S]) -> Option<S> {
        self.laws.motional(winding, currents, &self.numbers)
    }

    fn field_energy<S: Over<P>>(&self, angle: Circle<S>) -> S {
        self.laws.energy(angle, &self.numbers)
    }

    fn moment_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        self.laws.moment(slip, speed, &self.numbers)
    }
}

impl<K: Knows> Catalogued for Text<f64, K> {
    const SUMMARY: &'static str = "its laws are written in the scene";
    type Over<P: Datum> = Text<P, K>;

    /// From a source without laws: a rotor that is left alone.
    fn read<P: Datum, E>(source: &mut impl Source<P, Error = E>) -> Result<Text<P, K>, E> {
        let laws = source.laws().unwrap_or_default();
        Text::new(laws, |quantity| source.quantity(quantity))
    }
}
