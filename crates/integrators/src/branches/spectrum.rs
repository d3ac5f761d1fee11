//! Eigenvalues of a small dense matrix.

use nalgebra::linalg::Schur;
use nalgebra::{Complex, DMatrix};

/// The largest number of iterations for each eigenvalue; two or three suffice as a rule.
const MOST_STEPS: usize = 200;
/// Tolerances for a subdiagonal entry of the Schur form to count as zero, in units of the last place. With one unit,
/// rounding may prevent convergence for multiple eigenvalues; the larger tolerances are then tried in turn.
const NOTHING: [f64; 5] = [1.0, 4.0, 16.0, 1024.0, 1_048_576.0];

/// The eigenvalues of an n x n matrix in row order, sorted by descending real part. `None` where the iteration does not
/// converge, or an entry is not finite.
pub fn spectrum(n: usize, matrix: &[f64]) -> Option<Vec<Complex<f64>>> {
    if matrix.len() != n * n || !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    eigenvalues(&DMatrix::from_row_slice(n, n, matrix))
}

/// The eigenvalues of a square matrix, sorted by descending real part. `None` where the iteration does not converge, or
/// an entry is not finite.
pub fn eigenvalues(matrix: &DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let n = matrix.nrows();
    if n == 0 {
        return Some(Vec::new());
    }
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let all = disguises(matrix);
    let mut found = NOTHING.iter().find_map(|units| all.iter().find_map(|disguise| disguise.eigenvalues(*units)))?;
    found.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    Some(found)
}

/// A matrix B = A - s I or (A - s I)^-1, whose eigenvalues give those of A.
struct Disguise {
    matrix: DMatrix<f64>,
    shift: f64,
    /// Whether B is (A - s I)^-1 instead of A - s I.
    is_inverse: bool,
}

/// Shifts s in units of the largest entry of A; [`OUTSIDE`] in units of its norm.
const SHIFTS: [f64; 2] = [0.0, -1.0];
const OUTSIDE: [f64; 2] = [1.3, -1.7];

/// Transformed matrices to try in turn. The iteration of A itself may cycle if eigenvalues lie symmetrically about
/// zero, which A - s I avoids, or if two pairs have equal imaginary parts, which (A - s I)^-1 avoids.
fn disguises(matrix: &DMatrix<f64>) -> Vec<Disguise> {
    let n = matrix.nrows();
    let shifted = |part: f64, size: f64| (matrix - DMatrix::from_diagonal_element(n, n, part * size), part * size);
    let plain = SHIFTS.map(|part| shifted(part, matrix.amax()));
    let plain = plain.into_iter().map(|(matrix, shift)| Disguise { matrix, shift, is_inverse: false });
    let inverse = OUTSIDE.into_iter().filter_map(|part| {
        let (matrix, shift) = shifted(part, matrix.norm());
        Some(Disguise { matrix: matrix.try_inverse()?, shift, is_inverse: true })
    });
    plain.chain(inverse).collect()
}

impl Disguise {
    fn eigenvalues(&self, units: f64) -> Option<Vec<Complex<f64>>> {
        let schur = Schur::try_new(self.matrix.clone(), units * f64::EPSILON, MOST_STEPS * self.matrix.nrows())?;
        let own = |value: &Complex<f64>| if self.is_inverse { value.inv() } else { *value } + self.shift;
        Some(schur.complex_eigenvalues().iter().map(own).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::eigenvalues;
    use nalgebra::{Complex, DMatrix};

    /// x'' = 4 x - 2 y', y'' = 4 y + 2 x', and a fifth state that is constant. The matrix of the state x, y, x', y' and the fifth is tested with
    /// its rows and columns in 5 cyclic orders.
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

    /// A rotor in a plane with cross-coupling: two pairs with equal imaginary parts, p^2 + 2 p + 0.1 +- i q = 0.
    #[test]
    fn pairs_with_one_imaginary_part_are_found() {
        for (coupling, damping) in (1..40).flat_map(|k| [0.5, 2.0, 3.0].map(|damping| (0.05 * f64::from(k), damping))) {
            let rows = [
                [0.0, 0.0, 1.0, 0.0],
                [0.0, 0.0, 0.0, 1.0],
                [-0.1, -coupling, -damping, 0.0],
                [coupling, -0.1, 0.0, -damping],
            ];
            let found = eigenvalues(&DMatrix::from_fn(4, 4, |i, j| rows[i][j]))
                .unwrap_or_else(|| panic!("{coupling} {damping}"));
            for value in found {
                let side = |sign: f64| value * value + value * damping + Complex::new(0.1, sign * coupling);
                let off = side(1.0).norm().min(side(-1.0).norm());
                assert!(off < 1e-12, "{coupling} {damping}: {value}, {off}");
            }
        }
    }

    /// Gyroscopic forces on two equal directions: p^4 + (g^2 - 2) p^2 + 1 = 0.
    #[test]
    fn gyroscopic_pairs_are_found() {
        for g in (0..80).map(|k| 0.05 * f64::from(k)) {
            let rows = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, g], [0.0, 1.0, -g, 0.0]];
            let found = eigenvalues(&DMatrix::from_fn(4, 4, |i, j| rows[i][j])).expect("four eigenvalues");
            for p in found {
                let off = (p * p * p * p + p * p * (g * g - 2.0) + Complex::new(1.0, 0.0)).norm();
                assert!(off < 1e-10, "{g}: {p}, {off}");
            }
        }
    }
}
