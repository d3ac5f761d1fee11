//! The equations of an equilibrium, and their residuals.

use crate::linearisation::{At, Point, VariedEquations};
use model::equations::Level;
use nalgebra::{DMatrix, DVector};

/// Residuals below this part of the sum of absolute terms are rounding errors.
const MET: f64 = 1e-11;

/// The scale of an equation is at least this part of the largest scale.
const FLOOR: f64 = 1e-3;

impl VariedEquations {
    /// Indices of all position constraints.
    pub(super) fn of_positions(&self) -> Vec<usize> {
        let positions = self.constraints.iter().enumerate().filter(|(_, known)| known.level == Level::Position);
        positions.map(|(place, _)| place).collect()
    }
}

/// The equations of an equilibrium at a point. Unknowns, the columns of the Jacobian: displacements along directions, currents,
/// multipliers. Rows: balances of forces, position constraints, rates of all constraints.
pub(super) struct Balance {
    /// Directions of displacement as columns, over the free coordinates.
    pub directions: DMatrix<f64>,
    /// The number of steady currents.
    pub currents: usize,
    /// Residuals of all rows.
    pub residuals: DVector<f64>,
    /// Derivatives of the residuals by the unknowns.
    pub jacobian: DMatrix<f64>,
    /// Sum of the absolute terms of each row.
    scales: DVector<f64>,
}

impl Balance {
    /// The equations at a point. `free` has the indices of the free coordinates, `currents` the directions of steady currents over all
    /// speeds, as columns.
    pub fn of(
        equations: &VariedEquations,
        point: &Point,
        (free, directions): (&[usize], DMatrix<f64>),
        currents: &DMatrix<f64>,
    ) -> Self {
        let At { motion, zero, rate, .. } = equations.at(point);
        let (n, m) = (motion.values.len(), zero.values.len());
        // constraints of speeds have no row for f(q), only one for the rate
        let places = equations.of_positions();
        let rows = n + places.len() + m;
        let part = |row: usize| match row.checked_sub(n) {
            None => (&motion, row),
            Some(k) => match places.get(k) {
                Some(&place) => (&zero, place),
                None => (&rate, k - places.len()),
            },
        };
        let value = |row: usize| part(row).0.values[part(row).1];
        let along = DMatrix::from_fn(rows, free.len(), |row, column| {
            let (values, row) = part(row);
            values.by_coordinates[(row, free[column])]
        });
        let along = along * &directions;
        let by_speeds = DMatrix::from_fn(rows, n, |row, column| part(row).0.by_speeds[(part(row).1, column)]);
        let by_currents = &by_speeds * currents;
        let moved = directions.ncols() + currents.ncols();
        let jacobian = DMatrix::from_fn(rows, moved + m, |row, column| match column.checked_sub(moved) {
            None if column < directions.ncols() => along[(row, column)],
            None => by_currents[(row, column - directions.ncols())],
            Some(multiplier) => part(row).0.by_multipliers[(part(row).1, multiplier)],
        });
        let size = |row: usize| {
            let (values, at) = part(row);
            let by_place = (0..n).map(|i| values.by_coordinates[(at, i)].abs() * equations.size(point, i));
            let by_reaction = (0..m).map(|k| (values.by_multipliers[(at, k)] * point.multipliers[k]).abs());
            let by_current = (0..n).map(|i| (by_speeds[(row, i)] * point.speeds[i]).abs());
            by_place.chain(by_reaction).chain(by_current).sum::<f64>()
        };
        let scales = DVector::from_fn(rows, |row, _| size(row));
        Balance {
            directions,
            currents: currents.ncols(),
            residuals: DVector::from_fn(rows, |row, _| value(row)),
            jacobian,
            scales,
        }
    }

    /// The parts of a vector of unknowns: displacements, currents, multipliers.
    pub fn parts(&self, of: &DVector<f64>) -> [DVector<f64>; 3] {
        let (places, moved) = (self.directions.ncols(), self.directions.ncols() + self.currents);
        let parts = [(0, places), (places, moved), (moved, of.len())];
        parts.map(|(from, to)| of.rows(from, to - from).into_owned())
    }

    /// True if a displacement changes the equation of this row to first order.
    pub fn is_moved(&self, row: usize) -> bool {
        self.jacobian.row(row).columns(0, self.directions.ncols()).amax() > 0.0
    }

    /// True if residuals and Jacobian are finite.
    pub fn is_finite(&self) -> bool {
        self.residuals.iter().chain(self.jacobian.iter()).all(|value| value.is_finite())
    }

    /// The Euclidean norm of the residuals; infinite for NaN.
    pub fn size(&self) -> f64 {
        let size = self.residuals.norm();
        if size.is_nan() { f64::INFINITY } else { size }
    }

    /// The row with the largest residual among those that exceed rounding; `None` if all equations hold.
    pub fn unmet(&self) -> Option<usize> {
        // a row of zeros in the Jacobian has no scale
        let least = FLOOR * self.scales.iter().copied().fold(0.0, f64::max);
        let excess = |row: usize| self.residuals[row].abs() - MET * self.scales[row].max(least);
        let open = (0..self.residuals.len()).filter(|&row| excess(row).is_nan() || excess(row) > 0.0);
        open.max_by(|&a, &b| self.residuals[a].abs().total_cmp(&self.residuals[b].abs()))
    }
}
