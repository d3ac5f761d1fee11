//! Directions of coordinates on which no equation depends, such as charges of windings, found by a test at several points.

use super::{At, Point, VariedEquations};
use crate::kernel::Rows;
use nalgebra::DMatrix;

/// The number of test points.
const POINTS: usize = 4;

/// The largest displacement of a test point, relative to the size of a component, or to one in SI units.
const ASIDE: f64 = 0.3;

/// The golden ratio conjugate: fractional parts of its multiples are evenly distributed.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

impl VariedEquations {
    /// The equations at generic points near `point`, where no derivative is zero by coincidence. Points with values that are not finite
    /// are left out.
    pub(crate) fn around(&self, point: &Point) -> Vec<At> {
        let all = (0..POINTS).map(|number| self.at(&self.beside(point, number)));
        let parts =
            |at: &At| [&at.motion, &at.zero, &at.rate, &at.acceleration].map(|values| values.by_coordinates.clone());
        all.filter(|at| parts(at).iter().all(|part| part.iter().all(|slope| slope.is_finite()))).collect()
    }

    /// Directions of the coordinates `among` along which no equation changes at the given points: orthonormal columns over all speeds.
    pub(crate) fn cyclic(&self, points: &[At], among: &[usize]) -> DMatrix<f64> {
        let [n, ..] = self.sizes;
        let mut rows = Rows::none(among.len());
        for At { motion, zero, rate, acceleration, .. } in points {
            for values in [motion, zero, rate, acceleration] {
                rows.add(&values.by_coordinates.select_columns(among));
            }
        }
        let own = if points.is_empty() { DMatrix::zeros(among.len(), 0) } else { rows.kernel() };
        let mut all = DMatrix::zeros(n, own.ncols());
        for (row, &place) in among.iter().enumerate() {
            all.row_mut(place).copy_from(&own.row(row));
        }
        all
    }

    /// Test point `number` near `about`; number zero has the coordinates of `about`.
    fn beside(&self, about: &Point, number: usize) -> Point {
        let mut point = about.clone();
        let part = |place: usize| ((place + 1 + 31 * number) as f64 * GOLDEN).fract() + 0.5;
        let share = ASIDE * number as f64 / POINTS as f64;
        for place in 0..about.speeds.len() {
            self.displace(&mut point, place, share * self.size(about, place) * part(place));
        }
        point.time += share * part(2);
        let Point { speeds, accelerations, multipliers, inputs, .. } = &mut point;
        for (first, values) in [(3, speeds), (7, accelerations), (11, multipliers), (13, inputs)] {
            values.iter_mut().enumerate().for_each(|(place, value)| *value += part(first + place));
        }
        point
    }
}
