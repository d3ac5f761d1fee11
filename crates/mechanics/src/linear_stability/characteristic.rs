//! The characteristic polynomial det(mu - A), without division.

use algebra::real::Ordered;

/// The coefficients of det(mu - A), beginning with that of the highest power, which is 1. Berkowitz' algorithm: for
/// each row r, column c and diagonal element d next to the leading block B, the coefficients are multiplied by the
/// triangular Toeplitz matrix of 1, -d, -r c, -r B c, -r B^2 c, ...
///
/// `one` is the unit of the ring. Of a matrix that is not square the leading square block is used.
pub fn characteristic<R: Ordered>(matrix: &[Vec<R>], one: &R) -> Vec<R> {
    let one = one.integer(1);
    let zero = one.integer(0);
    let mut coefficients = vec![one.clone()];
    for size in 0..matrix.len() {
        let (row, block) = (&matrix[size][..size], &matrix[..size]);
        let mut column: Vec<R> = block.iter().map(|of_block| of_block[size].clone()).collect();
        let mut toeplitz = vec![one.clone(), zero.minus(&matrix[size][size])];
        for _ in 0..size {
            toeplitz.push(zero.minus(&dot(row, &column, &zero)));
            column = block.iter().map(|of_block| dot(&of_block[..size], &column, &zero)).collect();
        }
        let term = |i: usize| {
            (0..=i.min(size)).fold(zero.clone(), |sum, k| match toeplitz.get(i - k) {
                Some(factor) => sum.plus(&factor.times(&coefficients[k])),
                None => sum,
            })
        };
        coefficients = (0..size + 2).map(term).collect();
    }
    coefficients
}

fn dot<R: Ordered>(a: &[R], b: &[R], zero: &R) -> R {
    a.iter().zip(b).fold(zero.clone(), |sum, (x, y)| sum.plus(&x.times(y)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::{Rational, Scalar};

    #[test]
    fn it_is_that_of_the_static_route() {
        let entries = [[2, -3, 1, 7], [5, 1, -4, 2], [0, 6, 3, -2], [1, -1, 4, 5]].map(|row| row.map(Rational::int));
        let rows: Vec<Vec<Rational>> = entries.iter().map(|row| row.to_vec()).collect();
        let found = characteristic(&rows, &Rational::int(1));
        assert_eq!(found[0], Rational::int(1));
        assert_eq!(found[1..], crate::stability::characteristic(entries));
    }
}
