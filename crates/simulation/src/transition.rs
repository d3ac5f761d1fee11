//! The state-transition matrix of a scene's run, in the components that a run shows.

use super::Problem;
use integrators::{Failure, Tolerance, transition};
use nalgebra::DMatrix;

impl Problem {
    /// The matrix dy_i(end) / dy_j(start), row by row; for a gyrostat in the axes of the data.
    ///
    /// A row of the run begins with B y, where B rotates the axes of the law into those of the data. The matrix is
    /// therefore B M B^-1.
    ///
    /// # Errors
    /// [`Failure`] where the law has no Taylor series, or the run fails.
    pub fn transition(&self, tolerance: f64) -> Result<Vec<Vec<f64>>, Failure> {
        let n = self.state.len();
        let found = transition(&*self.law, &Tolerance::both(tolerance), (0.0, self.span), &self.state)?;
        let inner = DMatrix::from_row_slice(n, n, &found.matrix);
        let shown = |state: &[f64]| (self.row)(0.0, state);
        let (origin, mut unit) = (shown(&vec![0.0; n]), vec![0.0; n]);
        let mut turn = DMatrix::zeros(n, n);
        for j in 0..n {
            unit[j] = 1.0;
            let column = shown(&unit);
            unit[j] = 0.0;
            for i in 0..n {
                turn[(i, j)] = column[i] - origin[i];
            }
        }
        // B is orthogonal: it consists of rotations of vectors
        let outer = &turn * inner * turn.transpose();
        Ok((0..n).map(|i| outer.row(i).iter().copied().collect()).collect())
    }
}
