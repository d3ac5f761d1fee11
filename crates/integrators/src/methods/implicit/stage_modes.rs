//! Decoupling of the stages of a collocation method by the eigenvalues and eigenvectors of its matrix.
//!
//! With A^-1 = V Lambda V^-1 the linear system (I - h A (x) J) x = r decouples into one system of the size of the law
//! for each eigenvalue, (lambda / h I - J) w = (lambda / h) V^-1 r, and x = V w (Butcher 1976, Bickart 1977; Hairer and
//! Wanner, Solving ODE II, IV.8). Of each complex conjugate pair only one system is needed.

use nalgebra::{Complex, DMatrix, DVector};

/// A real eigenvalue, or that of a conjugate pair with positive imaginary part, with its vectors.
#[derive(Clone, Debug)]
pub(crate) struct StageMode {
    pub eigenvalue: Complex<f64>,
    /// The column of V, doubled for a pair: the pair contributes the real part of the product with w.
    pub shape: Vec<Complex<f64>>,
    /// The row of V^-1.
    pub part: Vec<Complex<f64>>,
}

impl StageMode {
    pub fn is_real(&self) -> bool {
        self.eigenvalue.im == 0.0
    }
}

/// The number of steps of inverse iteration; each converges up to rounding.
const SHARPENINGS: usize = 3;

/// The largest allowed error in A and in the identity when reassembled from the modes. It limits the digits gained per
/// Newton correction.
const LARGEST_ERROR: f64 = 1e-6;

/// The modes of a method from its matrix A. `None` where rounding makes the eigenvectors dependent, from about 14
/// stages on.
pub(crate) fn stage_modes(matrix: &[Vec<f64>]) -> Option<Vec<StageMode>> {
    let stages = matrix.len();
    let inverse = DMatrix::from_fn(stages, stages, |i, j| matrix[i][j]).try_inverse()?;
    let complex = inverse.map(|entry| Complex::new(entry, 0.0));
    let (values, vectors): (Vec<_>, Vec<_>) = inverse
        .complex_eigenvalues()
        .iter()
        .map(|eigenvalue| sharpened(&complex, *eigenvalue))
        .collect::<Option<_>>()?;
    let parts = DMatrix::from_columns(&vectors).try_inverse()?;
    let found = values.into_iter().zip(vectors).enumerate().filter(|(_, (eigenvalue, _))| eigenvalue.im >= 0.0);
    let mode = |(k, (eigenvalue, vector)): (usize, (Complex<f64>, DVector<Complex<f64>>))| {
        let twice = if eigenvalue.im > 0.0 { 2.0 } else { 1.0 };
        let shape = vector.iter().map(|entry| entry * twice).collect();
        StageMode { eigenvalue, shape, part: parts.row(k).iter().copied().collect() }
    };
    let modes: Vec<StageMode> = found.map(mode).collect();
    (error(matrix, &modes) < LARGEST_ERROR).then_some(modes)
}

/// The largest error in A and in the identity when reassembled from the modes.
fn error(matrix: &[Vec<f64>], modes: &[StageMode]) -> f64 {
    let entry = |i: usize, j: usize, power: i32| -> f64 {
        modes.iter().map(|mode| (mode.shape[i] * mode.part[j] * mode.eigenvalue.powi(power)).re).sum()
    };
    let entries = matrix.iter().enumerate().flat_map(|(i, row)| row.iter().enumerate().map(move |(j, a)| (i, j, *a)));
    let errors = entries.map(|(i, j, a)| {
        let unit = if i == j { 1.0 } else { 0.0 };
        (entry(i, j, 0) - unit).abs().max((entry(i, j, -1) - a).abs())
    });
    errors.fold(0.0, f64::max)
}

/// An eigenvalue near a guess with its unit eigenvector, by inverse iteration.
fn sharpened(matrix: &DMatrix<Complex<f64>>, guess: Complex<f64>) -> Option<(Complex<f64>, DVector<Complex<f64>>)> {
    let stages = matrix.nrows();
    let real = guess.im.abs() <= 1e-7 * guess.norm();
    let mut vector = DVector::from_fn(stages, |i, _| Complex::new(1.0 / (stages + i) as f64, 0.0)).normalize();
    let mut eigenvalue = if real { Complex::new(guess.re, 0.0) } else { guess };
    for _ in 0..SHARPENINGS {
        // exactly at the eigenvalue the matrix would be singular
        let shift = eigenvalue * (1.0 + 1e-10);
        let shifted = matrix - DMatrix::from_diagonal_element(stages, stages, shift);
        let grown = shifted.lu().solve(&vector)?;
        eigenvalue = shift + vector.dotc(&vector) / vector.dotc(&grown);
        if real {
            eigenvalue.im = 0.0;
        }
        vector = grown.normalize();
    }
    Some((eigenvalue, vector))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::implicit::collocation::{Collocation, Family};

    #[test]
    fn radau_iia_with_3_stages_has_the_eigenvalues_of_the_textbook() {
        let modes = stage_modes(&Collocation::<f64>::new(Family::RadauIIA, 3).matrix).unwrap();
        let mut values: Vec<(f64, f64)> = modes.iter().map(|mode| (mode.eigenvalue.re, mode.eigenvalue.im)).collect();
        values.sort_by(|a, b| a.1.total_cmp(&b.1));
        let textbook = [(3.637834252744496, 0.0), (2.681082873627752, 3.050430199247411)];
        for (found, textbook) in values.iter().zip(textbook) {
            assert!((found.0 - textbook.0).abs() + (found.1 - textbook.1).abs() < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn methods_of_up_to_12_stages_fall_into_their_modes() {
        for family in [Family::Gauss, Family::RadauIIA] {
            for stages in 1..=12 {
                let modes = stage_modes(&Collocation::<f64>::new(family, stages).matrix).unwrap();
                assert_eq!(modes.len(), stages.div_ceil(2), "{family:?} with {stages} stages");
                assert_eq!(modes.iter().filter(|mode| mode.is_real()).count(), stages % 2);
            }
        }
    }

    #[test]
    fn a_wrong_eigenvector_is_noticed() {
        let matrix = Collocation::<f64>::new(Family::Gauss, 4).matrix;
        let mut modes = stage_modes(&matrix).unwrap();
        modes[0].shape[1] *= 1.001;
        assert!(error(&matrix, &modes) > 1e-4);
    }
}
