//! Solution of the equations of motion for accelerations and multipliers at a point.

use super::equations::{At, Point, VariedEquations};
use nalgebra::{DMatrix, DVector};
use std::fmt;

/// Singular values below this part of the largest count as zero.
const RANK: f64 = 1e-12;

/// The reason for which accelerations and multipliers are not determined at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undetermined {
    /// The matrix of the equations has a rank below the number of unknowns.
    Rank { rank: usize, unknowns: usize },
    /// An equation has no finite value.
    NotFinite,
}

impl fmt::Display for Undetermined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rank { rank, unknowns } => write!(
                f,
                "the equations do not determine accelerations and reactions: {unknowns} unknowns, rank {rank}"
            ),
            Self::NotFinite => write!(f, "the equations have no finite value"),
        }
    }
}

/// The matrix [M, -J^T; J, 0] at a point.
pub fn matrix(at: &At) -> DMatrix<f64> {
    let (n, m) = (at.motion.values.len(), at.acceleration.values.len());
    let mut matrix = DMatrix::zeros(n + m, n + m);
    matrix.view_mut((0, 0), (n, n)).copy_from(&at.motion.by_accelerations);
    matrix.view_mut((0, n), (n, m)).copy_from(&at.motion.by_multipliers);
    matrix.view_mut((n, 0), (m, n)).copy_from(&at.acceleration.by_accelerations);
    matrix
}

/// Solves linear equations with [`matrix`], after scaling its rows and columns, for all columns of `right`.
///
/// # Errors
/// [`Undetermined`] if the matrix is singular or not finite.
pub fn solved(at: &At, right: &DMatrix<f64>) -> Result<DMatrix<f64>, Undetermined> {
    let mut matrix = matrix(at);
    let size = matrix.nrows();
    let mut right = right.clone();
    for row in 0..size {
        let scale = matrix.row(row).amax();
        if scale > 0.0 {
            matrix.row_mut(row).scale_mut(1.0 / scale);
            right.row_mut(row).scale_mut(1.0 / scale);
        }
    }
    let columns: Vec<f64> =
        matrix.column_iter().map(|column| if column.amax() > 0.0 { column.amax() } else { 1.0 }).collect();
    for (mut column, scale) in matrix.column_iter_mut().zip(&columns) {
        column.scale_mut(1.0 / scale);
    }
    let unknown = |rank: usize| Undetermined::Rank { rank, unknowns: size };
    if !matrix.iter().chain(right.iter()).all(|value| value.is_finite()) {
        return Err(Undetermined::NotFinite);
    }
    let singular = matrix.singular_values();
    let rank = singular.iter().filter(|value| **value > RANK * singular.amax()).count();
    if rank < size {
        return Err(unknown(rank));
    }
    let mut solution = matrix.full_piv_lu().solve(&right).ok_or(unknown(rank))?;
    for (mut row, scale) in solution.row_iter_mut().zip(&columns) {
        row.scale_mut(1.0 / scale);
    }
    Ok(solution)
}

impl VariedEquations {
    /// The point with its accelerations and multipliers.
    ///
    /// # Errors
    /// [`Undetermined`] if the equations do not determine them.
    pub fn with_accelerations(&self, mut point: Point) -> Result<Point, Undetermined> {
        let n = point.speeds.len();
        let at = self.at(&point);
        let m = at.acceleration.values.len();
        let open =
            DVector::from_fn(n + m, |i, _| if i < n { -at.motion.values[i] } else { -at.acceleration.values[i - n] });
        let step = solved(&at, &DMatrix::from_columns(&[open]))?;
        for i in 0..n {
            point.accelerations[i] += step[(i, 0)];
        }
        for k in 0..m {
            point.multipliers[k] += step[(n + k, 0)];
        }
        Ok(point)
    }
}
