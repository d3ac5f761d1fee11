//! Least-norm solution of linear equations with mixed units: rows and columns are scaled first.

use super::RANK;
use nalgebra::{DMatrix, DVector};

/// The solution with the least norm in scaled unknowns, and the kernel of the matrix.
pub(super) struct Scaled {
    /// The solution in the original units of the unknowns.
    pub solution: DVector<f64>,
    /// An orthonormal basis of the kernel in scaled unknowns: one row per basis vector.
    kernel: DMatrix<f64>,
}

impl Scaled {
    /// For each unknown: true if a basis vector of the kernel has a component above `part`, so that the equations do not determine the
    /// unknown.
    pub fn free(&self, part: f64) -> Vec<bool> {
        self.kernel.column_iter().map(|column| column.amax() > part).collect()
    }
}

/// The solution; `None` if an entry is not finite or there is no unknown.
pub(super) fn scaled(matrix: &DMatrix<f64>, right: &DVector<f64>) -> Option<Scaled> {
    if !matrix.iter().chain(right.iter()).all(|value| value.is_finite()) || matrix.ncols() == 0 {
        return None;
    }
    let size = |amax: f64| if amax > 0.0 { amax } else { 1.0 };
    // rows of zeros: then each column direction has a singular value
    let rows = matrix.nrows().max(matrix.ncols());
    let mut square = DMatrix::zeros(rows, matrix.ncols());
    let mut by = DVector::zeros(rows);
    for (row, own) in matrix.row_iter().enumerate() {
        let scale = size(own.amax());
        square.row_mut(row).copy_from(&(own / scale));
        by[row] = right[row] / scale;
    }
    let columns: Vec<f64> = square.column_iter().map(|column| size(column.amax())).collect();
    for (mut column, scale) in square.column_iter_mut().zip(&columns) {
        column.unscale_mut(*scale);
    }
    let decomposed = square.svd(true, true);
    let least = RANK * decomposed.singular_values.amax();
    let mut solution = decomposed.solve(&by, least).ok()?;
    solution.iter_mut().zip(&columns).for_each(|(part, scale)| *part /= scale);
    let zero: Vec<usize> = (0..columns.len()).filter(|&k| decomposed.singular_values[k] <= least).collect();
    Some(Scaled { solution, kernel: decomposed.v_t?.select_rows(&zero) })
}
