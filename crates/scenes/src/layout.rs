//! Displacements of a state along its speeds: free frames have four coordinates for three speeds, and are rotated.

use model::{Model, quaternion_rates};
use std::ops::Range;

/// The places of coordinates and speeds in a state; free frames have four coordinates for three speeds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    /// The number of coordinates whose rates are speeds.
    plain: usize,
    free: usize,
}

impl Layout {
    pub fn of(model: &Model) -> Self {
        Layout { plain: model.coordinates.len(), free: model.free.len() }
    }

    pub fn positions(self) -> usize {
        self.plain + 4 * self.free
    }

    pub fn speeds(self) -> usize {
        self.plain + 3 * self.free
    }

    /// The places of the coordinates that a speed moves, or of the speed itself.
    pub fn places(self, speed: usize, order: usize) -> Range<usize> {
        match speed.checked_sub(self.plain) {
            _ if order == 1 => self.positions() + speed..self.positions() + speed + 1,
            None => speed..speed + 1,
            Some(turn) => {
                let first = self.plain + 4 * (turn / 3);
                first..first + 4
            }
        }
    }

    /// Changes a speed, or displaces its coordinates; a free frame is rotated about one of its axes.
    pub fn displace(self, state: &mut [f64], (speed, order): (usize, usize), by: f64) {
        let own = self.places(speed, order);
        if own.len() == 1 {
            state[own.start] += by;
            return;
        }
        let mut turning = [0.0; 3];
        turning[(speed - self.plain) % 3] = by;
        let quaternion = std::array::from_fn(|part| state[own.start + part]);
        let moved = quaternion_rates(quaternion, turning);
        own.clone().zip(moved).for_each(|(at, rate)| state[at] += rate);
        let length = own.clone().map(|at| state[at] * state[at]).sum::<f64>().sqrt();
        own.for_each(|at| state[at] /= length);
    }

    /// The first speed and the first coordinate of each free frame.
    pub fn turning(self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.free).map(move |number| (self.plain + 3 * number, self.plain + 4 * number))
    }
}
