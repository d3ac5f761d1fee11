//! Null space of a matrix that is built row by row.

use nalgebra::DMatrix;

/// Singular values below this part of the largest count as zero.
const RANK: f64 = 1e-10;

/// Rows of a matrix, each divided by its largest entry, so that the units of equations do not matter. A QR factorisation limits their
/// number to that of the columns.
pub(crate) struct Rows(DMatrix<f64>);

impl Rows {
    /// A matrix with this number of columns and without rows; its null space is the whole space.
    pub fn none(columns: usize) -> Self {
        Rows(DMatrix::zeros(0, columns))
    }

    /// Adds rows; rows of zeros are skipped.
    pub fn add(&mut self, rows: &DMatrix<f64>) {
        let Rows(known) = self;
        let more: Vec<usize> = (0..rows.nrows()).filter(|&row| rows.row(row).amax() > 0.0).collect();
        let mut both = DMatrix::zeros(known.nrows() + more.len(), rows.ncols());
        both.rows_mut(0, known.nrows()).copy_from(known);
        for (place, &row) in more.iter().enumerate() {
            let own = rows.row(row);
            both.row_mut(known.nrows() + place).copy_from(&(own / own.amax()));
        }
        *known = if both.nrows() > both.ncols() { both.qr().r() } else { both };
    }

    /// An orthonormal basis of the null space, as columns. Empty if an entry is not finite.
    pub fn kernel(&self) -> DMatrix<f64> {
        let Rows(rows) = self;
        let n = rows.ncols();
        if rows.is_empty() || rows.amax() == 0.0 {
            return DMatrix::identity(n, n);
        }
        // the singular value decomposition would not terminate for NaN
        if !rows.iter().all(|entry| entry.is_finite()) {
            return DMatrix::zeros(n, 0);
        }
        let mut square = DMatrix::zeros(n, n);
        square.rows_mut(0, rows.nrows()).copy_from(rows);
        let decomposed = square.svd(false, true);
        let largest = decomposed.singular_values.amax();
        let zero: Vec<usize> = (0..n).filter(|&k| decomposed.singular_values[k] <= RANK * largest).collect();
        decomposed.v_t.map_or_else(|| DMatrix::zeros(n, 0), |along| along.select_rows(&zero).transpose())
    }
}
