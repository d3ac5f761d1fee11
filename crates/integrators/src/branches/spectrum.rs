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
    // pairs that lie symmetrically about zero may turn in a circle: those of A + s I do not
    let mut found = [0.0, matrix.amax()].into_iter().find_map(|shift| shifted(matrix, shift))?;
    found.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    Some(found)
}

/// The eigenvalues of A by those of A + s I.
fn shifted(matrix: &DMatrix<f64>, shift: f64) -> Option<Vec<Complex<f64>>> {
    let n = matrix.nrows();
    let matrix = matrix + DMatrix::from_diagonal_element(n, n, shift);
    let schur =
        NOTHING.iter().find_map(|units| Schur::try_new(matrix.clone(), units * f64::EPSILON, MOST_STEPS * n))?;
    Some(schur.complex_eigenvalues().iter().map(|value| value - shift).collect())
}

#[cfg(test)]
mod tests {
    use super::eigenvalues;
    use nalgebra::DMatrix;

    /// Two unstable directions with gyroscopic coupling, and a coordinate of its own, for every place of this coordinate.
    #[test]
    fn eigenvalues_that_lie_symmetrically_about_zero_are_found() {
        for order in 0..5 {
            let mut matrix = DMatrix::zeros(5, 5);
            let place = |k: usize| (k + order) % 5;
            for (row, column, entry) in [(0, 2, 1.0), (1, 3, 1.0), (2, 0, 4.0), (3, 1, 4.0), (2, 3, -2.0), (3, 2, 2.0)]
            {
                matrix[(place(row), place(column))] = entry;
            }
            let found = eigenvalues(&matrix).expect("eigenvalues of five rows");
            // p^4 - 4 p^2 + 16 = 0: p = +-sqrt(3) +- i
            let unstable = found.iter().filter(|value| (value.re - 3.0_f64.sqrt()).abs() < 1e-12);
            assert_eq!(unstable.count(), 2, "{order}: {found:?}");
        }
    }
}
