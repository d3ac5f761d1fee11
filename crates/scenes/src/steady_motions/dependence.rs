//! Regions in which constraints become dependent, as those of a linkage whose bars lie in one line: no equation bounds reactions there.

use super::equations::{SteadyEquations, Unknown};
use super::search::independent;
use field::Interval;
use nalgebra::DMatrix;

/// The part of a range up to which a region is so small that its bounds say something of a place in it.
const SMALL: f64 = 1e-2;

/// Whether a small region is not shown to be free of places at which the gradients of the constraints are dependent.
///
/// With C about the inverse of a square part of J^T in its middle, |1 - C J^T| < 1 all over a region shows that they are independent there.
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
    // NaN, of entries without bounds, is no bound
    !(0..m).all(|row| (0..m).map(|column| defect(row, column)).sum::<f64>() < 1.0)
}
