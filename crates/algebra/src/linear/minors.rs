//! Determinants without division.
//!
//! Minors are expanded row by row, each computed once and shared: (n + 1) 2^n products. For symbolic expressions this
//! is shorter than elimination, whose divisions do not cancel, and it needs no pivots: one expression is valid for all
//! values.

use field::Scalar;

/// The largest number of unknowns; the number of minors is 2^n.
pub const LARGEST: usize = 14;

/// The determinant of a square matrix given by its rows; `None` if it is not square or larger than [`LARGEST`].
pub fn determinant<S: Scalar, Row: AsRef<[S]>>(rows: &[Row]) -> Option<S> {
    let size = rows.len();
    let square = size <= LARGEST && rows.iter().all(|row| row.as_ref().len() == size);
    square.then(|| minors(size, |row, column| rows[row].as_ref()[column], size)[(1 << size) - 1])
}

/// For every set of columns, as a bit set, the minor of these columns and as many of the last rows.
pub fn minors<S: Scalar>(rows: usize, entry: impl Fn(usize, usize) -> S, columns: usize) -> Vec<S> {
    let mut minors = vec![S::one(); 1 << columns];
    for set in 1usize..1 << columns {
        let size = set.count_ones() as usize;
        if size > rows {
            continue;
        }
        // expansion along the first of these rows, with alternating signs
        let mut sum = S::zero();
        for (place, column) in (0..columns).filter(|column| set >> column & 1 == 1).enumerate() {
            let factor = entry(rows - size, column);
            if !factor.is_zero() {
                let term = factor * minors[set & !(1 << column)];
                if place.is_multiple_of(2) { sum += term } else { sum -= term }
            }
        }
        minors[set] = sum;
    }
    minors
}
