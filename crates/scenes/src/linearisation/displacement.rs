//! Displacements of a point along its speeds, and the rates of small displacements.

use super::equations::{Point, VariedEquations};
use model::turned_further;
use nalgebra::DMatrix;

impl VariedEquations {
    /// Displaces the coordinate of a speed; a free frame is rotated about one of its own axes.
    pub fn displace(&self, point: &mut Point, speed: usize, by: f64) {
        self.layout.displace(point.coordinates.as_mut_slice(), (speed, 0), by);
    }

    /// The size of a coordinate for relative displacements: 1 + |q| in SI units, one radian for a free frame.
    pub(crate) fn size(&self, point: &Point, speed: usize) -> f64 {
        match self.layout.places(speed, 0) {
            own if own.len() == 1 => 1.0 + point.coordinates[own.start].abs(),
            _ => 1.0,
        }
    }

    /// The rates of small displacements as columns, for variations of the speeds. For a free frame with small rotations t in its own axes
    /// and angular velocity w, the rate is dw - w x t.
    pub(super) fn displacement_rates(
        &self,
        point: &Point,
        displacements: &DMatrix<f64>,
        speeds: &DMatrix<f64>,
    ) -> DMatrix<f64> {
        let mut rates = speeds.clone();
        for (first, _) in self.layout.turning() {
            let turning: [f64; 3] = std::array::from_fn(|axis| point.speeds[first + axis]);
            for axis in 0..3 {
                let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                let across =
                    displacements.row(first + last) * turning[next] - displacements.row(first + next) * turning[last];
                let mut own = rates.row_mut(first + axis);
                own -= across;
            }
        }
        rates
    }

    /// The point after the time `later` (s) with constant speeds.
    pub(super) fn straight_on(&self, point: &Point, later: f64) -> Point {
        let plain = self.layout.turning().next().map_or(point.speeds.len(), |(first, _)| first);
        let mut state: Vec<f64> = point.coordinates.iter().chain(point.speeds.iter()).copied().collect();
        (0..plain).for_each(|place| state[place] += point.speeds[place] * later);
        for (speed, coordinate) in self.layout.turning() {
            let quaternion = std::array::from_fn(|part| point.coordinates[coordinate + part]);
            let turn = std::array::from_fn(|axis| point.speeds[speed + axis] * later);
            state[coordinate..coordinate + 4].copy_from_slice(&turned_further(quaternion, turn));
        }
        self.point(point.time + later, &state)
    }
}
