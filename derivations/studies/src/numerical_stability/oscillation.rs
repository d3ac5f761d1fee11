//! Oscillations of a linear motion x' = A x: their angular frequencies, and a displacement along each.

use nalgebra::{DMatrix, DVector};

/// Eigenvalues and real parts below this fraction of the largest eigenvalue are rounding.
const ROUNDING: f64 = 1e-9;

/// Frequencies with a smaller relative difference count as one.
const ONE: f64 = 1e-7;

/// The distinct frequencies of the imaginary eigenvalues, rad/s, the lowest first.
pub fn frequencies(eigenvalues: &[[f64; 2]]) -> Vec<f64> {
    let largest = eigenvalues.iter().map(|[re, im]| re.hypot(*im)).fold(0.0, f64::max);
    let is_imaginary = |[re, im]: &&[f64; 2]| re.abs() <= ROUNDING * largest && *im > ROUNDING * largest;
    let mut all: Vec<f64> = eigenvalues.iter().filter(is_imaginary).map(|[_, im]| *im).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, last| (*next - *last).abs() <= ONE * next.abs());
    all
}

/// A displacement that oscillates with one frequency w: a vector in the kernel of A^2 + w^2.
pub fn displaced(a: &DMatrix<f64>, frequency: f64) -> DVector<f64> {
    let n = a.nrows();
    let kernel = a * a + DMatrix::identity(n, n) * (frequency * frequency);
    let svd = kernel.svd(false, true);
    let least = svd.singular_values.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1)).map(|(place, _)| place);
    match (svd.v_t, least) {
        (Some(rows), Some(place)) => rows.row(place).transpose(),
        _ => DVector::zeros(n),
    }
}

#[cfg(test)]
mod tests {
    use super::{displaced, frequencies};
    use nalgebra::DMatrix;

    #[test]
    fn a_displacement_oscillates_with_one_frequency_alone() {
        // x1'' = -x1, x2'' = -9 x2, rotated by 45 degrees
        let a = DMatrix::from_row_slice(4, 4, &[0., 0., 1., 0., 0., 0., 0., 1., -5., 4., 0., 0., 4., -5., 0., 0.]);
        let all = frequencies(&[[0.0, 1.0], [0.0, -1.0], [1e-17, 3.0], [1e-17, -3.0]]);
        assert_eq!(all, [1.0, 3.0]);
        let x = displaced(&a, 3.0);
        assert!((&a * &a * &x + &x * 9.0).norm() < 1e-12 && (x.norm() - 1.0).abs() < 1e-12);
    }
}
