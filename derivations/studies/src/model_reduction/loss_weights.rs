//! Transition matrices along a run whose states and rates are known at points: they weight local errors.
//!
//! By Magnus' expansion to fourth order, with the Jacobians J1, J2 at the two Gauss points,
//!
//!   P = exp(h/2 (J1 + J2) + sqrt(3) h^2/12 (J2 J1 - J1 J2)) ,
//!
//! where the states at these points come from the cubic through both ends. An accuracy of 1/100 suffices for weights; a
//! Taylor series with all directions would cost a hundred times as much.

use integrators::Jacobian;
use nalgebra::DMatrix;

/// A point of a run: time, state and rates.
pub type Knot = (f64, Vec<f64>, Vec<f64>);

/// The largest product of h and the norm of J of a step, and the largest number of steps of an interval.
const SHORT: f64 = 8.0;
const MOST: f64 = 16.0;

/// The transition matrix dy(end)/dy(begin).
pub fn propagator(jacobian: &mut Jacobian<'_>, begin: &Knot, end: &Knot) -> DMatrix<f64> {
    let n = begin.1.len();
    let span = end.0 - begin.0;
    let mut rows = vec![0.0; n * n];
    let mut at = |share: f64| {
        jacobian.matrix(begin.0 + share * span, &cubic(begin, end, share), &mut rows);
        DMatrix::from_row_slice(n, n, &rows)
    };
    let norm = |j: &DMatrix<f64>| j.row_iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    let offset = 3.0_f64.sqrt() / 6.0;
    let points = [0.5 - offset, 0.5 + offset];
    let whole = points.map(&mut at);
    let steps = (span.abs() * norm(&whole[0]).max(norm(&whole[1])) / SHORT).ceil().clamp(1.0, MOST);
    if steps == 1.0 {
        return over(&whole, span);
    }
    (0..steps as usize).fold(DMatrix::identity(n, n), |before, step| {
        over(&points.map(|point| at((step as f64 + point) / steps)), span / steps) * before
    })
}

/// The transition matrix of one step, with the Jacobians at its two Gauss points.
fn over([a, b]: &[DMatrix<f64>; 2], h: f64) -> DMatrix<f64> {
    exponential(&((a + b) * (0.5 * h) + (b * a - a * b) * (3.0_f64.sqrt() * h * h / 12.0)))
}

/// exp(X) by the Pade approximant of order 6, (120 + 12 X^2 + X (60 + X^2)) / (120 + 12 X^2 - X (60 + X^2)), which
/// needs one linear solution and keeps rapidly decaying parts small. Infinite where the solution fails.
fn exponential(x: &DMatrix<f64>) -> DMatrix<f64> {
    let unit = DMatrix::identity(x.nrows(), x.ncols());
    let square = x * x;
    let even = &unit * 120.0 + &square * 12.0;
    let odd = x * (&unit * 60.0 + &square);
    (&even - &odd).lu().solve(&(even + odd)).unwrap_or_else(|| unit * f64::INFINITY)
}

/// The cubic Hermite interpolant through states and rates at both ends, at the fraction s.
pub(super) fn cubic((from, y0, f0): &Knot, (to, y1, f1): &Knot, s: f64) -> Vec<f64> {
    let h = to - from;
    let (a, b) = ((1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s), s * (1.0 - s) * (1.0 - s) * h);
    let (c, d) = (s * s * (3.0 - 2.0 * s), s * s * (s - 1.0) * h);
    (0..y0.len()).map(|i| a * y0[i] + b * f0[i] + c * y1[i] + d * f1[i]).collect()
}
