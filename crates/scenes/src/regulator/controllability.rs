//! Controllability of linear equations: by Hautus' test for constant coefficients (Hautus 1969), by the rank of the controllability Gramian
//! for time-varying ones (Kalman 1960).

use super::riccati::Stage;
use integrators::eigenvalues;
use nalgebra::{Complex, DMatrix};

/// Singular values below this multiple of the largest one count as zero.
const RANK: f64 = 1e-10;

/// The controllability of x' = A x + B u.
#[derive(Clone, Debug, PartialEq)]
pub enum Controllability {
    /// Constant coefficients: the eigenvalues of A (1/s) that no input can change; empty if the system is controllable.
    Modes(Vec<Complex<f64>>),
    /// Time-varying coefficients: the rank of the Gramian over the horizon and the number of states; the system is controllable if they are equal.
    Directions { rank: usize, of: usize },
}

impl Controllability {
    /// Hautus' test: the eigenvalues w of A for which the matrix (A - w I, B) has not full rank.
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
        let values = eigenvalues(&stage.a).unwrap_or_default();
        Controllability::Modes(values.iter().copied().filter(is_out_of_reach).collect())
    }

    /// The rank of the controllability Gramian W along a motion, W' = A W + W A^T + B B^T with W = 0 at the start. `stages` are the equations at
    /// the ends and middles of equal steps of length `step` (s); each step uses those at its middle.
    pub fn along(stages: &[Stage], step: f64) -> Self {
        let n = stages.first().map_or(0, |stage| stage.a.nrows());
        let mut gramian = DMatrix::zeros(n, n);
        for middle in stages.iter().skip(1).step_by(2) {
            let (moved, own) = over(middle, step);
            gramian = &moved * gramian * moved.transpose() + own;
        }
        // scaling to a unit diagonal makes the rank independent of the units of states
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

/// The transition matrix and the Gramian over one step with constant coefficients. The step is halved until A h is small (Van Loan 1978)
/// and the results are doubled, which stays accurate for stiff A.
fn over(stage: &Stage, step: f64) -> (DMatrix<f64>, DMatrix<f64>) {
    let n = stage.a.nrows();
    let doublings = (stage.a.norm() * step).max(1.0).log2().ceil();
    let part = step / doublings.exp2();
    let mut both = DMatrix::zeros(2 * n, 2 * n);
    both.view_mut((0, 0), (n, n)).copy_from(&(&stage.a * -part));
    both.view_mut((0, n), (n, n)).copy_from(&(&stage.b * stage.b.transpose() * part));
    both.view_mut((n, n), (n, n)).copy_from(&(stage.a.transpose() * part));
    let both = both.exp();
    let mut moved = both.view((n, n), (n, n)).transpose();
    let mut gramian = &moved * both.view((0, n), (n, n));
    for _ in 0..doublings as usize {
        gramian += &moved * &gramian * moved.transpose();
        moved = &moved * &moved;
    }
    (moved, gramian)
}

#[cfg(test)]
mod tests {
    use super::over;
    use crate::regulator::Stage;
    use nalgebra::DMatrix;

    /// For x' = -a x + u the Gramian is (1 - exp(-2 a h))/(2 a); for the double integrator it is (h^3/3, h^2/2; h^2/2, h).
    #[test]
    fn gramians_of_a_step_have_their_closed_forms_however_stiff() {
        let stage = |a: &[f64], b: &[f64], n: usize| Stage {
            a: DMatrix::from_row_slice(n, n, a),
            b: DMatrix::from_row_slice(n, 1, b),
            state: DMatrix::zeros(n, n),
            mixed: DMatrix::zeros(n, 1),
            input: DMatrix::identity(1, 1),
        };
        for a in [0.1, 3.0, 1e6] {
            let (moved, gramian) = over(&stage(&[-a], &[1.0], 1), 0.5);
            let known: f64 = (1.0 - (-a).exp()) / (2.0 * a);
            assert!((gramian[(0, 0)] / known - 1.0).abs() < 1e-9 && (moved[(0, 0)] - (-0.5 * a).exp()).abs() < 1e-12);
        }
        let (_, gramian) = over(&stage(&[0.0, 1.0, 0.0, 0.0], &[0.0, 1.0], 2), 3.0);
        let known = [9.0, 4.5, 4.5, 3.0];
        assert!(gramian.iter().zip(known).all(|(entry, known)| (entry - known).abs() < 1e-12), "{gramian}");
    }
}
