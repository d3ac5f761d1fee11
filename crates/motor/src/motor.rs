//! A motor in the form in which it runs: its laws as programs over any field, and its data.

use super::{Datum, Laws, Machine, RotorState};
use field::{Base, Circle, Over, Rational};
use reader::{Allowed, Quantity};
use std::sync::Arc;
use symbolic::Sym;

/// A motor with its data, of the catalogue or with laws from a text.
#[derive(Clone, Debug)]
pub struct Motor<P = f64> {
    laws: Arc<Laws>,
    /// The data in their order, then the numbers that follow from them alone.
    numbers: Vec<P>,
    /// The data beyond their bounds that were asked for.
    pub allowed: Allowed,
}

impl<P: Datum> Motor<P> {
    /// A motor with data in the order of its laws.
    pub fn new(laws: Arc<Laws>, data: Vec<P>, allowed: Allowed) -> Self {
        Motor { numbers: laws.numbers(data), laws, allowed }
    }

    /// The motor with other data in their order.
    pub fn with_data(&self, data: Vec<P>) -> Self {
        Motor::new(Arc::clone(&self.laws), data, self.allowed)
    }

    /// The same laws with data in another field.
    pub fn over<Q: Datum>(&self, mut number: impl FnMut(&Quantity, P) -> Q) -> Motor<Q> {
        let data = self.data().map(|(quantity, value)| number(quantity, value)).collect();
        Motor::new(Arc::clone(&self.laws), data, self.allowed)
    }
}

impl<P: Copy> Motor<P> {
    /// The name that scene files use.
    pub fn name(&self) -> &'static str {
        self.laws.name()
    }

    /// The programs.
    pub fn laws(&self) -> &Arc<Laws> {
        &self.laws
    }

    /// The data, each by its quantity.
    pub fn data(&self) -> impl Iterator<Item = (&Quantity, P)> {
        self.laws.data().iter().zip(self.values().iter().copied())
    }

    /// The data in their order.
    pub fn values(&self) -> &[P] {
        &self.numbers[..self.laws.data().len()]
    }

    /// A datum by its name.
    pub fn datum(&self, name: &str) -> Option<P> {
        self.data().find(|(quantity, _)| quantity.name == name).map(|(_, value)| value)
    }

    /// A number of bars or the like by its name.
    pub fn count(&self, name: &str) -> Option<usize> {
        self.laws.counts().iter().find(|(count, _)| count.name == name).map(|(_, number)| *number)
    }
}

impl Motor {
    /// The motor with another value of a datum, without its bound; none where it has no datum of this name.
    pub fn with(&self, name: &str, value: f64) -> Option<Self> {
        let place = self.laws.data().iter().position(|quantity| quantity.name == name)?;
        let mut data = self.values().to_vec();
        data[place] = value;
        Some(self.with_data(data))
    }

    /// The motor with its data as exact constants: the decimals that were written.
    pub fn decimals(&self) -> Motor<Sym> {
        self.over(|_, value| Sym::constant(Rational::decimal(value)))
    }

    /// The motor with its data as letters, by their names.
    pub fn letters(&self) -> Motor<Sym> {
        self.over(|quantity, _| Sym::symbol(&quantity.name))
    }

    /// W of a motor whose rotor follows the stator's field: the speed that a machine of constant speed keeps.
    pub fn synchronous_speed(&self) -> Option<f64> {
        (self.rotor() == RotorState::AngleAndSpeed).then(|| self.frame_speed())
    }

    /// The constant speed of its rotor, for any torque; `None` for other motors.
    pub fn prescribed_speed(&self) -> Option<f64> {
        (self.rotor() == RotorState::Prescribed).then(|| self.frame_speed())
    }
}

impl<P: Base> Machine<P> for Motor<P> {
    fn rotor(&self) -> RotorState {
        self.laws.rotor()
    }

    fn frame_speed(&self) -> P {
        self.laws.frame_speed(&self.numbers)
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

    fn torque_law<S: Over<P>>(&self, slip: S, speed: S) -> S {
        self.laws.torque(slip, speed, &self.numbers)
    }
}
