//! Narrowing of a box in which some unknowns are still unbounded, by a subsystem of equations that do not depend on
//! them.

use super::Equations;
use super::newton::Local;
use field::Interval;
use nalgebra::DMatrix;

/// The part of a box that may contain zeros, for any values of the unknowns from index `bounded` on; `None` where there
/// is none.
pub(super) fn narrowed(equations: &mut dyn Equations, at: &[Interval], bounded: usize) -> Option<Vec<Interval>> {
    let n = at.len();
    let mut slopes = vec![Interval::EVERYTHING; n * n];
    equations.slopes(at, &mut slopes);
    let zero = Interval::point(0.0);
    let is_bounded = |row: &usize| {
        let (own, others) = slopes[row * n..(row + 1) * n].split_at(bounded);
        own.iter().all(|slope| slope.size().is_finite()) && others.iter().all(|slope| *slope == zero)
    };
    let rows: Vec<usize> = (0..n).filter(is_bounded).collect();
    let Some(columns) = pivots(&rows, bounded, |row, column| slopes[row * n + column].middle()) else {
        return Some(at.to_vec());
    };
    // the unbounded unknowns do not enter, the others keep their ranges
    let mut about = at.to_vec();
    columns.iter().for_each(|&column| about[column] = Interval::point(at[column].middle()));
    let mut values = vec![Interval::EVERYTHING; n];
    equations.values(&about, &mut values);
    let part = |row: usize, column: usize| slopes[rows[row] * n + columns[column]];
    let values: Vec<Interval> = rows.iter().map(|&row| values[row]).collect();
    let own: Vec<Interval> = columns.iter().map(|&column| at[column]).collect();
    let Some(local) = Local::new(&own, &values, part) else { return Some(at.to_vec()) };
    let left = local.narrowed(&own)?;
    let mut all = at.to_vec();
    columns.iter().zip(left).for_each(|(&column, left)| all[column] = left);
    Some(all)
}

/// Assigns to each row a column with the largest remaining pivot; `None` where a pivot is zero.
fn pivots(rows: &[usize], columns: usize, entry: impl Fn(usize, usize) -> f64) -> Option<Vec<usize>> {
    let m = rows.len();
    if m == 0 || m > columns {
        return None;
    }
    let mut left = DMatrix::from_fn(m, columns, |row, column| entry(rows[row], column));
    let mut chosen = Vec::new();
    for row in 0..m {
        let size = |column: &usize| left[(row, *column)].abs();
        let free = (0..columns).filter(|column| !chosen.contains(column));
        let pivot = free.max_by(|a, b| size(a).total_cmp(&size(b)))?;
        let value = left[(row, pivot)];
        if value == 0.0 || !value.is_finite() {
            return None;
        }
        for below in row + 1..m {
            let factor = left[(below, pivot)] / value;
            (0..columns).for_each(|column| left[(below, column)] -= factor * left[(row, column)]);
        }
        chosen.push(pivot);
    }
    Some(chosen)
}
