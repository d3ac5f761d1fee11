//! A motor for runs: its laws as programs over any scalar type, and its data.

use super::{Datum, Laws, Machine, RotorState};
use field::{Base, Circle, Over, Rational};
use reader::{Allowed, Quantity};
use std::sync::Arc;
use symbolic::Sym;

/// A motor of the catalogue, or with laws from a text, with its data.
#[derive(Clone, Debug)]
pub struct Motor<P = f64> {
    laws: Arc<Laws>,
    /// The data in order, then the numbers that depend on them only.
    numbers: Vec<P>,
    /// The kinds of data outside bounds that the file explicitly allows.
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

    /// The motor with data in another scalar type.
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

    /// The programs of its laws.
    pub fn laws(&self) -> &Arc<Laws> {
        &self.laws
    }

    /// The data with their quantities.
    pub fn data(&self) -> impl Iterator<Item = (&Quantity, P)> {
        self.laws.data().iter().zip(self.values().iter().copied())
    }

    /// The values of the data, in order.
    pub fn values(&self) -> &[P] {
        &self.numbers[..self.laws.data().len()]
    }

    /// The value of a datum by name.
    pub fn datum(&self, name: &str) -> Option<P> {
        self.data().find(|(quantity, _)| quantity.name == name).map(|(_, value)| value)
    }

    /// The value of a count by name, such as the number of bars.
    pub fn count(&self, name: &str) -> Option<usize> {
        self.laws.counts().iter().find(|(count, _)| count.name == name).map(|(_, number)| *number)
    }
}

impl Motor {
    /// The motor with another value of a datum, without a check of its bound; `None` where there is no such datum.
    pub fn with(&self, name: &str, value: f64) -> Option<Self> {
        let place = self.laws.data().iter().position(|quantity| quantity.name == name)?;
        let mut data = self.values().to_vec();
        data[place] = value;
        Some(self.with_data(data))
    }

    /// The motor with its data as exact constants, from their shortest decimals.
    pub fn decimals(&self) -> Motor<Sym> {
        self.over(|_, value| Sym::constant(Rational::decimal(value)))
    }

    /// The motor with its data as symbols.
    pub fn letters(&self) -> Motor<Sym> {
        self.over(|quantity, _| Sym::symbol(&quantity.name))
    }

    /// The synchronous speed W of a motor whose laws depend on the angle to the stator's field, rad/s; `None` for other
    /// motors.
    pub fn synchronous_speed(&self) -> Option<f64> {
        (self.rotor() == RotorState::AngleAndSpeed).then(|| self.frame_speed())
    }

    /// The prescribed speed of a rotor, rad/s; `None` for other motors.
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
