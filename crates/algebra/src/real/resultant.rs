//! Subresultants of polynomials with polynomial coefficients.

use super::Polynomial;
use std::collections::BTreeMap;

/// The coefficients, from the constant upwards, of the k-th subresultant of two polynomials in x with coefficients in
/// another unknown. The 0th is the resultant. The first one with a nonzero leading coefficient is the greatest common
/// divisor.
pub fn subresultant(a: &[Polynomial], b: &[Polynomial], k: usize) -> Vec<Polynomial> {
    let (Some(m), Some(n)) = (a.len().checked_sub(1), b.len().checked_sub(1)) else { return Vec::new() };
    if k > m.min(n) {
        return Vec::new();
    }
    let size = m + n - 2 * k;
    // rows x^(n-k-1) a, ..., a, x^(m-k-1) b, ..., b; columns: the powers m + n - k - 1, ..., k + 1, then the power i
    let rows: Vec<(&[Polynomial], usize)> =
        (0..n - k).rev().map(|s| (a, s)).chain((0..m - k).rev().map(|s| (b, s))).collect();
    let entry = |row: usize, power: usize| {
        let (of, shift) = rows[row];
        power.checked_sub(shift).and_then(|place| of.get(place)).cloned().unwrap_or_default()
    };
    let coefficient = |i: usize| {
        let power = |column: usize| if column + 1 == size { i } else { m + n - k - 1 - column };
        determinant(size, |row, column| entry(row, power(column)))
    };
    (0..=k).map(coefficient).collect()
}

/// The determinant by Laplace expansion along the rows, without division; minors are indexed by their columns.
fn determinant(size: usize, entry: impl Fn(usize, usize) -> Polynomial) -> Polynomial {
    let mut minors = BTreeMap::from([(0u32, Polynomial::from_integers([1]))]);
    for row in 0..size {
        let entries: Vec<Polynomial> = (0..size).map(|column| entry(row, column)).collect();
        let mut next: BTreeMap<u32, Polynomial> = BTreeMap::new();
        for (used, minor) in &minors {
            for (column, value) in entries.iter().enumerate() {
                if used & (1 << column) != 0 || value.is_zero() {
                    continue;
                }
                let passed = (used >> column).count_ones();
                let term = value * minor;
                let sum = next.entry(used | 1 << column).or_default();
                *sum = if passed % 2 == 0 { &*sum + &term } else { &*sum - &term };
            }
        }
        minors = next;
    }
    minors.remove(&((1u32 << size) - 1)).unwrap_or_default()
}
