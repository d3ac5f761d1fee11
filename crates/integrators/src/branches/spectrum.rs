//! All eigenvalues of a small matrix.

use nalgebra::linalg::Schur;
use nalgebra::{Complex, DMatrix};

/// Steps for each eigenvalue, beyond which the iteration counts as lost; it takes two or three.
const MOST_STEPS: usize = 200;
/// Tolerances of the Schur iteration for a subdiagonal entry that counts as zero, in units of the last place. With one unit the
/// rounding of multiple eigenvalues may keep the iteration going for ever; a few are still below the rounding of the matrix by then.
const NOTHING: [f64; 5] = [1.0, 4.0, 16.0, 1024.0, 1_048_576.0];

/// The eigenvalues of an n x n matrix, row after row, the largest real part first; `None` where the iteration is lost, or
/// an entry is not finite.
pub fn spectrum(n: usize, matrix: &[f64]) -> Option<Vec<Complex<f64>>> {
    if matrix.len() != n * n || !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    eigenvalues(&DMatrix::from_row_slice(n, n, matrix))
}

/// The eigenvalues of a square matrix, the largest real part first; `None` where the iteration is lost, or an entry is not finite.
pub fn eigenvalues(matrix: &DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let n = matrix.nrows();
    if n == 0 {
        return Some(Vec::new());
    }
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let schur =
        NOTHING.iter().find_map(|units| Schur::try_new(matrix.clone(), units * f64::EPSILON, MOST_STEPS * n))?;
    let mut found: Vec<Complex<f64>> = schur.complex_eigenvalues().iter().copied().collect();
    found.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    Some(found)
}
