//! The reach of inputs: modes of constant equations (Hautus 1969), directions of those that change with the time (Kalman 1960).

use super::riccati::Stage;
use nalgebra::{Complex, DMatrix};

/// A singular value below this part of the largest one is zero.
const RANK: f64 = 1e-10;

/// The reach of the inputs.
#[derive(Clone, Debug, PartialEq)]
pub enum Controllability {
    /// Eigenvalues of A that no input changes; none of a controllable system.
    Modes(Vec<Complex<f64>>),
    /// The rank of the Gramian over the time of a motion, beside the number of states.
    Directions { rank: usize, of: usize },
}

impl Controllability {
    /// Eigenvalues w of A at which (A - w, B) loses rank.
    pub fn of_constant(stage: &Stage) -> Self {
        let (n, k) = stage.b.shape();
        let size = stage.a.norm().max(1e-300);
        let columns = stage.b.norm().max(1e-300);
        let is_out_of_reach = |value: &Complex<f64>| {
            let both = DMatrix::from_fn(n, n + k, |row, column| match column.checked_sub(n) {
                Some(input) => Complex::new(stage.b[(row, input)] / columns, 0.0),
                None => {
                    let shift = if row == column { *value } else { Complex::new(0.0, 0.0) };
                    (Complex::new(stage.a[(row, column)], 0.0) - shift) / size
                }
            });
            let singular = both.singular_values();
            singular.min() <= RANK * singular.max()
        };
        let values = stage.a.complex_eigenvalues();
        Controllability::Modes(values.iter().copied().filter(is_out_of_reach).collect())
    }

    /// Of stages at the ends and in the middles of equal steps: the Gramian W' = A W + W A^T + B B^T from zero, by the classical method.
    pub fn along(stages: &[Stage], step: f64) -> Self {
        let n = stages.first().map_or(0, |stage| stage.a.nrows());
        let rate = |stage: &Stage, gramian: &DMatrix<f64>| {
            let moved = &stage.a * gramian;
            &moved + moved.transpose() + &stage.b * stage.b.transpose()
        };
        let mut gramian = DMatrix::zeros(n, n);
        for three in stages.windows(3).step_by(2) {
            let first = rate(&three[0], &gramian);
            let second = rate(&three[1], &(&gramian + &first * (0.5 * step)));
            let third = rate(&three[1], &(&gramian + &second * (0.5 * step)));
            let last = rate(&three[2], &(&gramian + &third * step));
            gramian += (first + (second + third) * 2.0 + last) * (step / 6.0);
        }
        // units of states do not count
        let scale: Vec<f64> = (0..n).map(|k| gramian[(k, k)].max(0.0).sqrt()).collect();
        let scaled = DMatrix::from_fn(n, n, |row, column| {
            let both = scale[row] * scale[column];
            if both > 0.0 { gramian[(row, column)] / both } else { 0.0 }
        });
        let values = scaled.symmetric_eigenvalues();
        let largest = values.max();
        Controllability::Directions { rank: values.iter().filter(|value| **value > RANK * largest).count(), of: n }
    }
}
