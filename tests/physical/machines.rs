//! Every machine of the catalogue with random data.

use motor::{Motor, catalogue};
use proptest::prelude::*;
use reader::Allowed;

/// A machine of the catalogue with a number of bars, and 0.7 for every other datum.
pub fn with_bars(name: &str, bars: usize) -> Motor {
    catalogue::sampled(name, |_| 0.7, bars).unwrap_or_else(|| panic!("{name} is in the catalogue"))
}

/// A machine of the catalogue with these data by name, and with this number of bars (or of other repeated parts).
pub fn with_data(name: &str, data: &[(&str, f64)], count: usize) -> Motor {
    let value = |name: &str| data.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
    let motor = catalogue::sampled(name, |quantity| value(&quantity.name).expect("it is given"), count);
    motor.unwrap_or_else(|| panic!("{name} is in the catalogue"))
}

/// Numbers for the data of a machine and for a state; there are enough of them for any machine.
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

/// Each machine of the catalogue with these data.
pub fn every_machine(sample: &Sample) -> impl Iterator<Item = Motor> {
    catalogue::entries().into_iter().map(|entry| {
        let mut drawn = sample.data.iter().copied().cycle();
        let mut next = || drawn.next().unwrap_or(1.0);
        let data: Vec<f64> = entry.data.iter().map(|_| next()).collect();
        let counts: Vec<usize> = entry.counts.iter().map(|_| 1 + (3.0 * next()) as usize).collect();
        Motor::new(entry.laws(&counts).expect("its laws are short"), data, Allowed::ALL)
    })
}

impl Sample {
    /// A state: w, v of length one, then further components as the machine requires.
    pub fn state(&self, dimension: usize) -> Vec<f64> {
        let mut state: Vec<f64> = self.state.iter().copied().cycle().take(dimension).collect();
        if let Some(vertical) = state.get_mut(3..6) {
            let length = vertical.iter().map(|v| v * v).sum::<f64>().sqrt();
            vertical.iter_mut().for_each(|v| *v /= length);
        }
        state
    }
}
