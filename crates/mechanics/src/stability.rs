//! Asymptotic stability of an equilibrium of x' = A x: characteristic polynomial and Hurwitz' minors, over any scalar
//! type.
//!
//! The equilibrium is asymptotically stable if and only if every root of det(mu - A) has a negative real part, which is
//! equivalent to positive leading minors of Hurwitz' matrix. Both are exact over exact numbers, and formulas over
//! symbolic expressions.

use field::Scalar;

/// The coefficients c of det(mu - A) = mu^N + c_1 mu^(N-1) + ... + c_N, by the Faddeev-Leverrier algorithm, which
/// divides by 1, ..., N only.
pub fn characteristic<S: Scalar, const N: usize>(matrix: [[S; N]; N]) -> [S; N] {
    let mut coefficients = [S::zero(); N];
    let mut power = [[S::zero(); N]; N];
    let mut last = S::one();
    for (k, coefficient) in coefficients.iter_mut().enumerate() {
        for (i, row) in power.iter_mut().enumerate() {
            row[i] += last;
        }
        let previous = power;
        for (row, of_matrix) in power.iter_mut().zip(&matrix) {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = (0..N).fold(S::zero(), |sum, l| sum + of_matrix[l] * previous[l][j]);
            }
        }
        let trace = (0..N).fold(S::zero(), |sum, i| sum + power[i][i]);
        last = -trace / S::int(k as i64 + 1);
        *coefficient = last;
    }
    coefficients
}

/// Hurwitz' leading minors of mu^N + c_1 mu^(N-1) + ...: the entry in row i, column j is c_(2j - i), counted from 1.
pub fn hurwitz<S: Scalar, const N: usize>(coefficients: [S; N]) -> [S; N] {
    let entry = |i: usize, j: usize| match (2 * j + 1).checked_sub(i) {
        Some(0) => S::one(),
        Some(k) if k <= N => coefficients[k - 1],
        _ => S::zero(),
    };
    std::array::from_fn(|size| minor(&entry, size + 1, 0, 0))
}

/// The determinant of the rows from `row` on, without the columns in the bit set `used`, by Laplace expansion.
fn minor<S: Scalar>(entry: &impl Fn(usize, usize) -> S, size: usize, row: usize, used: u32) -> S {
    if row == size {
        return S::one();
    }
    let free = (0..size).filter(|column| used & (1 << column) == 0);
    free.enumerate().fold(S::zero(), |sum, (place, column)| {
        let value = entry(row, column);
        if value.is_zero() {
            return sum;
        }
        let term = value * minor(entry, size, row + 1, used | 1 << column);
        if place % 2 == 0 { sum + term } else { sum - term }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::Rational;

    #[test]
    fn the_companion_matrix_has_its_polynomial_and_hurwitz_sees_its_roots() {
        let int = Rational::int;
        // (mu + 1)(mu + 2)(mu + 3) = mu^3 + 6 mu^2 + 11 mu + 6
        let companion = [[int(0), int(1), int(0)], [int(0), int(0), int(1)], [int(-6), int(-11), int(-6)]];
        let c = characteristic(companion);
        assert_eq!(c, [6, 11, 6].map(int));
        assert_eq!(hurwitz(c), [6, 60, 360].map(int));
        // (mu - 1)(mu + 2)(mu + 3)
        assert!(hurwitz([4, 1, -6].map(int)).iter().any(|minor| minor.sign() != Some(1)));
    }
}
