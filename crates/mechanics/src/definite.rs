//! Linear equations with a symmetric positive definite matrix, over any scalar type.
//!
//! Elimination needs no pivoting, since all pivots are positive. Pivoting would need comparisons, which symbolic
//! scalars lack.

use crate::differentiate::{along, fixed, unit};
use field::{Scalar, Tangent};

/// The error of a zero pivot: the matrix is not definite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotDefinite {
    /// The index of the first row that depends on those before it.
    pub row: usize,
}

impl std::fmt::Display for NotDefinite {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "row {} of the matrix depends on those before it", self.row + 1)
    }
}

impl std::error::Error for NotDefinite {}

/// The solution x of A x = b, by elimination in the order of the rows.
///
/// # Errors
/// [`NotDefinite`] where a pivot is exactly zero.
pub fn solve<S: Scalar, const N: usize>(mut a: [[S; N]; N], mut b: [S; N]) -> Result<[S; N], NotDefinite> {
    for k in 0..N {
        if a[k][k].is_zero() {
            return Err(NotDefinite { row: k });
        }
        let pivot = a[k];
        for i in k + 1..N {
            let factor = a[i][k] / pivot[k];
            for j in k + 1..N {
                a[i][j] -= factor * pivot[j];
            }
            let known = b[k];
            b[i] -= factor * known;
        }
    }
    for k in (0..N).rev() {
        let rest = (k + 1..N).fold(b[k], |sum, j| sum - a[k][j] * b[j]);
        b[k] = rest / a[k][k];
    }
    Ok(b)
}

/// The root of an affine map whose matrix is symmetric positive definite, from its value at zero and one derivative for
/// each unknown.
///
/// # Errors
/// [`NotDefinite`] where a pivot is exactly zero.
pub fn root<S: Scalar, const N: usize>(
    map: impl Fn([Tangent<S>; N]) -> [Tangent<S>; N],
) -> Result<[S; N], NotDefinite> {
    let origin = [S::zero(); N];
    let columns: [[S; N]; N] = std::array::from_fn(|k| map(along(origin, unit(k))).map(|image| image.slope));
    let matrix = std::array::from_fn(|i| std::array::from_fn(|k| columns[k][i]));
    solve(matrix, map(fixed(origin)).map(|image| -image.value))
}
