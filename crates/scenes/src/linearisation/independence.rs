//! Choice of independent coordinates and speeds under constraints, by elimination with pivoting.

use nalgebra::DMatrix;

/// A pivot is acceptable if it is at least this part of the largest in its row; the last acceptable column is chosen.
const FAIR: f64 = 0.1;

/// Pivots below this part of the largest entry of a row count as zero.
const ZERO: f64 = 1e-10;

/// The pivot columns of linear equations, one for each row. The choice for the first rows does not depend on later rows.
///
/// # Errors
/// The index of the first row that depends on those before it.
pub fn dependent(rows: &DMatrix<f64>) -> Result<Vec<usize>, usize> {
    let (m, n) = rows.shape();
    let mut rest = rows.clone();
    let mut taken: Vec<usize> = Vec::new();
    for row in 0..m {
        let original = rows.row(row).amax();
        let size = |column: usize, rest: &DMatrix<f64>| rest[(row, column)].abs();
        let free: Vec<usize> = (0..n).filter(|column| !taken.contains(column)).collect();
        let largest = free.iter().map(|&column| size(column, &rest)).fold(0.0, f64::max);
        if largest.is_nan() || largest <= ZERO * original || largest == 0.0 {
            return Err(row);
        }
        let Some(&pivot) = free.iter().rev().find(|&&column| size(column, &rest) >= FAIR * largest) else {
            return Err(row);
        };
        let own = rest.row(row) / rest[(row, pivot)];
        for below in (row + 1)..m {
            let factor = rest[(below, pivot)];
            let mut line = rest.row_mut(below);
            line -= &own * factor;
            line[pivot] = 0.0;
        }
        taken.push(pivot);
    }
    Ok(taken)
}

/// The columns among 0..n that are not in `dependent`.
pub fn others(n: usize, dependent: &[usize]) -> Vec<usize> {
    (0..n).filter(|column| !dependent.contains(column)).collect()
}
