//! The laws that determine currents, and their derivative along a motion.

use super::currents::Currents;
use crate::linearisation::{At, Point, Values};
use nalgebra::{DMatrix, DVector};

/// A law is satisfied if its residual is below this fraction of the sum of the absolute values of its terms.
const MET: f64 = 1e-10;

/// The laws at a point. Columns of the Jacobian: open speeds, open accelerations, multipliers.
pub(super) struct Laws {
    /// The residual of each law, in the unit of the law.
    pub residuals: DVector<f64>,
    /// Derivatives of the residuals, one row for each law.
    pub jacobian: DMatrix<f64>,
    /// For each law, the index of the speed of its force balance; `None` for a constraint or a prescribed current.
    pub speeds: Vec<Option<usize>>,
    /// The sum of the absolute terms of each law.
    scales: Vec<f64>,
}

/// A block of equations, and the index of a row in it.
type Row<'a> = (&'a Values, usize);

impl Laws {
    /// The laws at a point whose equations are `at`.
    pub fn of(currents: &Currents<'_>, at: &At, point: &Point) -> Self {
        let rates = currents.rates.iter().map(|&row| ((&at.rate, row), None));
        let (rows, speeds): (Vec<Row<'_>>, Vec<Option<usize>>) = rates.chain(own(currents, at)).unzip();
        let jacobian = by_unknowns(currents, &rows);
        let balanced = |(values, row): &Row<'_>| {
            let parts = [
                (&values.by_speeds, &point.speeds),
                (&values.by_accelerations, &point.accelerations),
                (&values.by_multipliers, &point.multipliers),
            ];
            let size = |(slopes, of): (&DMatrix<f64>, &DVector<f64>)| {
                slopes.row(*row).transpose().component_mul(of).abs().sum()
            };
            parts.into_iter().map(size).sum::<f64>()
        };
        let scales = rows.iter().enumerate().map(|(place, row)| balanced(row) + jacobian.row(place).amax()).collect();
        let residuals = DVector::from_iterator(rows.len(), rows.iter().map(|(values, row)| values.values[*row]));
        Laws { residuals, jacobian, speeds, scales }
    }

    /// The law with the largest scaled residual among those that do not hold.
    pub fn unmet(&self) -> Option<usize> {
        let excess = |row: &usize| self.residuals[*row].abs() - MET * self.scales[*row];
        let open = (0..self.scales.len()).filter(|row| excess(row).is_nan() || excess(row) > 0.0);
        open.max_by(|a, b| self.part(*a).total_cmp(&self.part(*b)))
    }

    /// The Euclidean norm of the scaled residuals; infinite for NaN.
    pub fn size(&self) -> f64 {
        let size = (0..self.scales.len()).map(|row| self.part(row).powi(2)).sum::<f64>().sqrt();
        if size.is_nan() { f64::INFINITY } else { size }
    }

    fn part(&self, row: usize) -> f64 {
        if self.residuals[row] == 0.0 { 0.0 } else { self.residuals[row].abs() / self.scales[row] }
    }

    /// Matrix and right side of the linear equations for open accelerations, their rates, and the rates of multipliers. `third` are the
    /// third derivatives of the prescribed coordinates.
    pub fn rates(
        currents: &Currents<'_>,
        at: &At,
        point: &Point,
        third: &DVector<f64>,
    ) -> (DMatrix<f64>, DVector<f64>) {
        let rows: Vec<Row<'_>> = own(currents, at).map(|(row, _)| row).collect();
        let (held, n) = (currents.held.len(), currents.open.len());
        let by_unknowns = by_unknowns(currents, &rows);
        let mut matrix = DMatrix::zeros(held + rows.len(), by_unknowns.ncols());
        matrix.rows_mut(held, rows.len()).copy_from(&by_unknowns);
        let mut right = DVector::zeros(matrix.nrows());
        for (place, &row) in currents.held.iter().enumerate() {
            let own = at.acceleration.by_accelerations.row(row).select_columns(&currents.open);
            matrix.view_mut((place, 0), (1, n)).copy_from(&own);
            let known = currents.open.iter().zip(own.iter()).map(|(&open, slope)| slope * point.accelerations[open]);
            right[place] = known.sum::<f64>() - at.acceleration.values[row];
        }
        let mut prescribed = point.accelerations.clone();
        currents.open.iter().for_each(|&open| prescribed[open] = 0.0);
        for (place, (values, row)) in rows.iter().enumerate() {
            let parts = [
                (&values.by_coordinates, &point.speeds),
                (&values.by_speeds, &prescribed),
                (&values.by_accelerations, third),
            ];
            let known = parts.map(|(slopes, of)| slopes.row(*row).transpose().dot(of));
            right[held + place] = -known.iter().sum::<f64>() - values.by_time[*row];
        }
        (matrix, right)
    }
}

/// The rows: acceleration constraints, equations of motion, prescribed currents.
fn own<'b>(currents: &'b Currents<'_>, at: &'b At) -> impl Iterator<Item = (Row<'b>, Option<usize>)> {
    let held = currents.held.iter().map(|&row| ((&at.acceleration, row), None));
    let laws = currents.laws.iter().map(|&row| ((&at.motion, row), Some(row)));
    let prescribed = currents.prescribed.iter().map(|&row| ((&at.outputs, row), None));
    held.chain(laws).chain(prescribed)
}

/// Derivatives of rows by open speeds, open accelerations, multipliers.
fn by_unknowns(currents: &Currents<'_>, rows: &[Row<'_>]) -> DMatrix<f64> {
    let (open, reactions) = (&currents.open, &currents.reactions);
    let n = open.len();
    DMatrix::from_fn(rows.len(), 2 * n + reactions.len(), |place, column| {
        let (values, row) = rows[place];
        match column.checked_sub(2 * n) {
            Some(multiplier) => values.by_multipliers[(row, reactions[multiplier])],
            None if column < n => values.by_speeds[(row, open[column])],
            None => values.by_accelerations[(row, open[column - n])],
        }
    })
}
