//! Regions in which constraints may be dependent, such as the stretched position of a linkage; reactions are unbounded there.

use super::equations::{SteadyEquations, Unknown};
use super::search::independent;
use field::Interval;
use nalgebra::DMatrix;

/// A region is small if its width is below this fraction of the range along every unknown.
const SMALL: f64 = 1e-2;

/// Whether a small region may contain positions with linearly dependent gradients of constraints.
///
/// The gradients are proved independent if |1 - C J^T| < 1 all over the region, with C an approximate inverse of a square part of J^T.
pub(super) fn may_be_dependent(equations: &SteadyEquations, hull: &[Interval]) -> bool {
    let m = equations.reactions;
    let is_small = |(at, unknown): (&Interval, &Unknown)| at.width() <= SMALL * unknown.range.interval().width();
    if m == 0 || !hull.iter().zip(&equations.unknowns).all(is_small) {
        return false;
    }
    let mut loads = vec![Interval::EVERYTHING; equations.tapes.loads.outputs()];
    equations.tapes.loads.over::<Interval>().evaluate(hull, &mut loads);
    let rows = loads.len() / (m + 1);
    let entry = |row: usize, column: usize| loads[row * m + column];
    let Some(chosen) = independent(rows, m, |row, column| entry(row, column).middle()) else { return true };
    let middle = DMatrix::from_fn(m, m, |k, column| entry(chosen[k], column).middle());
    let Some(inverse) = middle.try_inverse() else { return true };
    let defect = |row: usize, column: usize| {
        let one = Interval::point(if row == column { 1.0 } else { 0.0 });
        (0..m).fold(one, |rest, k| rest - Interval::point(inverse[(row, k)]) * entry(chosen[k], column)).size()
    };
    // a NaN from entries without bounds must not count as a proof
    !(0..m).all(|row| (0..m).map(|column| defect(row, column)).sum::<f64>() < 1.0)
}
