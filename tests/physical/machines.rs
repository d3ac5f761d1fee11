//! Every machine of the list, whatever it is called, with random data.

use dalembert_derivations::machines::{AnyMachine, Quantity, Source};
use proptest::prelude::*;
use std::convert::Infallible;

/// Data that are asked for by name, answered with random numbers in their order.
struct Drawn<I>(I);

impl<I: Iterator<Item = f64>> Source for Drawn<I> {
    type Error = Infallible;

    fn quantity(&mut self, _quantity: &Quantity) -> Result<f64, Infallible> {
        Ok(self.0.next().unwrap_or(1.0))
    }

    fn count(&mut self, _name: &'static str, _meaning: &'static str) -> Result<usize, Infallible> {
        Ok(1 + (3.0 * self.0.next().unwrap_or(1.0)) as usize)
    }
}

/// Any machine with so many bars, every other datum the same.
pub struct Bars(pub usize);

impl Source for Bars {
    type Error = Infallible;

    fn quantity(&mut self, _quantity: &Quantity) -> Result<f64, Infallible> {
        Ok(0.7)
    }

    fn count(&mut self, _name: &'static str, _meaning: &'static str) -> Result<usize, Infallible> {
        Ok(self.0)
    }
}

/// Numbers for the data of a machine and for a state, as many as any machine may ask for.
#[derive(Clone, Debug)]
pub struct Sample {
    data: Vec<f64>,
    state: Vec<f64>,
}

/// Data between 1/2 and 2, states between -2 and 2.
pub fn numbers() -> impl Strategy<Value = Sample> {
    (prop::collection::vec(0.5..2.0f64, 24), prop::collection::vec(-2.0..2.0f64, 40))
        .prop_map(|(data, state)| Sample { data, state })
}

/// Each machine of the list with these data.
pub fn every_machine(sample: &Sample) -> impl Iterator<Item = AnyMachine> {
    AnyMachine::LIST.iter().filter_map(|(name, _)| {
        let mut source = Drawn(sample.data.iter().copied().cycle());
        AnyMachine::read(name, &mut source).map(|Ok(machine)| machine)
    })
}

impl Sample {
    /// The first numbers of a state: w, v of length one, then whatever the machine has.
    pub fn state(&self, dimension: usize) -> Vec<f64> {
        let mut state: Vec<f64> = self.state.iter().copied().cycle().take(dimension).collect();
        if let Some(vertical) = state.get_mut(3..6) {
            let length = vertical.iter().map(|v| v * v).sum::<f64>().sqrt();
            vertical.iter_mut().for_each(|v| *v /= length);
        }
        state
    }
}
