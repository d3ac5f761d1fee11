//! Indices of coordinates and speeds in a state, and displacements along speeds. A free frame has four coordinates (a quaternion) for
//! three speeds (its angular velocity).

use model::{Model, quaternion_rates};
use std::ops::Range;

/// The numbers of coordinates and free frames, from which indices in a state follow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    /// The number of coordinates whose rates are speeds.
    plain: usize,
    /// The number of free frames.
    free: usize,
}

impl Layout {
    pub fn of(model: &Model) -> Self {
        Layout { plain: model.coordinates.len(), free: model.free.len() }
    }

    /// The number of coordinates, with four for each free frame.
    pub fn positions(self) -> usize {
        self.plain + 4 * self.free
    }

    /// The number of speeds, with three for each free frame.
    pub fn speeds(self) -> usize {
        self.plain + 3 * self.free
    }

    /// Indices in the state: for `order` 0 those of the coordinates that a speed changes, for `order` 1 that of the speed itself.
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

    /// Adds `by` to a speed (`order` 1) or to its coordinate (`order` 0). A free frame is rotated by the angle `by`, to first order,
    /// about one of its own axes.
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

    /// The indices of the first speed and of the first coordinate of each free frame.
    pub fn turning(self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.free).map(move |number| (self.plain + 3 * number, self.plain + 4 * number))
    }
}
