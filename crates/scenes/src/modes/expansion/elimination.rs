//! Linear equations over series with bounds of their errors.

use super::super::jet::Jet;

/// A pivot is zero where it is not so many times its doubt.
const PIVOT: f64 = 64.0;

/// Gauss's elimination with the largest pivots; none where one is zero but for rounding.
pub(in super::super) fn solved<const N: usize>(
    mut rows: Vec<Vec<Jet<N>>>,
    mut right: Vec<Jet<N>>,
) -> Option<Vec<Jet<N>>> {
    let n = right.len();
    for pivot in 0..n {
        let size = |row: usize| rows[row][pivot].terms[0].abs();
        let row = (pivot..n).max_by(|&a, &b| size(a).total_cmp(&size(b)))?;
        let largest = rows[row][pivot];
        // zero, or no number
        if largest.sign_of(0, PIVOT).abs() != 1.0 {
            return None;
        }
        rows.swap(pivot, row);
        right.swap(pivot, row);
        for below in pivot + 1..n {
            let factor = rows[below][pivot] / rows[pivot][pivot];
            let (upper, lower) = rows.split_at_mut(below);
            for (entry, &above) in lower[0].iter_mut().zip(&upper[pivot]).skip(pivot + 1) {
                *entry -= factor * above;
            }
            let part = factor * right[pivot];
            right[below] -= part;
        }
    }
    for row in (0..n).rev() {
        let known = (row + 1..n).fold(right[row], |rest, column| rest - rows[row][column] * right[column]);
        right[row] = known / rows[row][row];
    }
    Some(right)
}
