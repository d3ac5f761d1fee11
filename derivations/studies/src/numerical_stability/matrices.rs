//! Linear algebra of a step's matrix in floats: spectral radius, next multiplier, orthogonal complements.

use nalgebra::{DMatrix, DVector};

/// The number of squarings of a matrix.
const SQUARINGS: i32 = 40;
/// A singular value of the power below this fraction of the largest belongs to a smaller multiplier.
const FADED: f64 = 1e-9;

/// The spectral radius by Gelfand's formula with the power 2^40, for which the constant factors are negligible.
/// Multiple eigenvalues, for which iterations for single eigenvalues may not converge, are no exception.
pub(super) fn spectral_radius(mut power: DMatrix<f64>) -> f64 {
    let mut logarithm = 0.0;
    for squaring in 0..SQUARINGS {
        let norm = power.norm();
        if norm == 0.0 {
            return 0.0;
        }
        logarithm += norm.ln() / f64::powi(2.0, squaring);
        power /= norm;
        power = &power * &power;
    }
    logarithm.exp()
}

/// The largest |multiplier| inside the spectral radius. A high power maps onto the invariant space of those on the
/// radius; its orthogonal complement contains the others, whatever their multiplicities.
pub(super) fn next_to(matrix: &DMatrix<f64>) -> Option<f64> {
    let mut power = matrix.clone();
    for _ in 0..SQUARINGS {
        power /= Some(power.norm()).filter(|norm| *norm > 0.0)?;
        power = &power * &power;
    }
    let onto = power.svd(true, false);
    let (space, sizes) = (onto.u?, onto.singular_values);
    let beside: Vec<_> =
        (0..sizes.len()).filter(|k| sizes[*k] < FADED * sizes.max()).map(|k| space.column(k)).collect();
    if beside.is_empty() {
        return Some(0.0);
    }
    let beside = DMatrix::from_columns(&beside);
    Some(spectral_radius(beside.transpose() * matrix * beside))
}

/// An orthonormal basis of the orthogonal complement of the gradients.
pub(super) fn complement(gradients: &[DVector<f64>], n: usize) -> DMatrix<f64> {
    let filler = |row: usize, column: usize| (1.0 + (row * n + column) as f64).sin();
    let whole = DMatrix::from_fn(n, n, |row, column| match gradients.get(column) {
        Some(gradient) => gradient[row] / gradient.norm(),
        None => filler(row, column),
    });
    let orthonormal = whole.qr().q();
    orthonormal.columns(gradients.len(), n - gradients.len()).into_owned()
}
