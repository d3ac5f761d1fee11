//! Corrector of a continuation: Newton's iteration in a plane normal to the predictor, and the tangent of the curve.

use super::Curve;
use crate::newton::Newton;
use nalgebra::{DMatrix, DVector};

/// The largest number of corrections; a trial point that needs more is rejected.
const MOST_CORRECTIONS: u32 = 12;
/// Corrections smaller than this fraction of the unknowns are rounding errors: their growth does not count as
/// divergence.
const ROUNDING: f64 = 1e-9;

/// Computes points and tangents of a curve, in unknowns divided by their sizes.
pub(super) struct Corrector<'a> {
    curve: &'a mut dyn Curve,
    sizes: &'a [f64],
    residual: Vec<f64>,
    matrix: Vec<f64>,
    /// The number of Newton corrections for the last point.
    pub corrections: u32,
}

impl<'a> Corrector<'a> {
    pub fn new(curve: &'a mut dyn Curve, sizes: &'a [f64]) -> Self {
        let unknowns = curve.unknowns();
        let residual = vec![0.0; unknowns.saturating_sub(1)];
        let matrix = vec![0.0; residual.len() * unknowns];
        Corrector { curve, sizes, residual, matrix, corrections: 0 }
    }

    /// The linear equations of Newton's iteration at the scaled point `x` of length n + 1. The matrix has the n rows of the Jacobian, each divided by its
    /// largest entry, and `border` as the last row. The right side has the n residuals, divided by the same numbers, and a zero. `None` if the curve
    /// cannot be evaluated at `x`, or a row or a residual is not finite or a row is zero.
    fn bordered(&mut self, x: &DVector<f64>, border: &DVector<f64>) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let n = self.residual.len();
        let given: Vec<f64> = x.iter().zip(self.sizes).map(|(x, size)| x * size).collect();
        self.curve.evaluate(&given, &mut self.residual, &mut self.matrix).ok()?;
        let mut matrix = DMatrix::from_fn(n + 1, n + 1, |i, j| match i == n {
            true => border[j],
            false => self.matrix[i * (n + 1) + j] * self.sizes[j],
        });
        let mut right = DVector::zeros(n + 1);
        for i in 0..n {
            let largest = matrix.row(i).amax();
            if !(largest > 0.0 && largest.is_finite() && self.residual[i].is_finite()) {
                return None;
            }
            matrix.row_mut(i).iter_mut().for_each(|entry| *entry /= largest);
            right[i] = self.residual[i] / largest;
        }
        Some((matrix, right))
    }

    /// The point of the curve in the plane through `trial` with the normal `across`. All vectors have length n + 1 and are divided by the sizes of the
    /// unknowns. `None` if Newton's iteration finds no such point at a distance of at most `reach` from `trial`.
    pub fn onto(&mut self, trial: &DVector<f64>, across: &DVector<f64>, reach: f64) -> Option<DVector<f64>> {
        let (mut x, mut newton, mut last) = (trial.clone(), Newton::new(), f64::INFINITY);
        for corrections in 1..=MOST_CORRECTIONS {
            let (matrix, mut right) = self.bordered(&x, across)?;
            right[x.len() - 1] = across.dot(&(&x - trial));
            let correction = matrix.lu().solve(&right)?;
            x -= &correction;
            self.corrections = corrections;
            let (size, scale) = (correction.norm(), 1.0 + x.amax());
            let astray = corrections > 2 && size > last && last > ROUNDING * scale;
            if astray || (&x - trial).norm() > reach {
                return None;
            }
            if newton.corrected::<f64>(size, scale).ok()? {
                return Some(x);
            }
            last = size;
        }
        None
    }

    /// The unit tangent of the curve at the scaled point x, oriented such that its product with `along` is positive. `None`
    /// if the equations have no unique solution at x.
    pub fn direction(&mut self, x: &DVector<f64>, along: &DVector<f64>) -> Option<DVector<f64>> {
        let (matrix, mut right) = self.bordered(x, along)?;
        right.fill(0.0);
        right[x.len() - 1] = 1.0;
        let direction = matrix.lu().solve(&right)?;
        let length = direction.norm();
        (length > 0.0 && length.is_finite()).then(|| direction / length)
    }
}
