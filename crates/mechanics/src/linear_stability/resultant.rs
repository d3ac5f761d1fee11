//! The resultant of two polynomials, over any ring.

use super::characteristic;
use algebra::real::Ordered;

/// The resultant of two polynomials, the highest power first: the determinant of Sylvester's matrix up to its sign. It
/// is zero where the polynomials have a common root or both leading coefficients vanish. With the derivative it
/// vanishes where a root is repeated.
pub fn resultant<R: Ordered>(a: &[R], b: &[R], one: &R) -> R {
    let (m, n) = (a.len().saturating_sub(1), b.len().saturating_sub(1));
    let zero = one.integer(0);
    let row = |of: &[R], shift: usize| -> Vec<R> {
        let entry = |column: usize| column.checked_sub(shift).and_then(|place| of.get(place)).unwrap_or(&zero).clone();
        (0..m + n).map(entry).collect()
    };
    let matrix: Vec<Vec<R>> = (0..n).map(|k| row(a, k)).chain((0..m).map(|k| row(b, k))).collect();
    characteristic(&matrix, one).pop().unwrap_or(zero)
}

/// The derivative of a polynomial, the highest power first.
pub fn derivative<R: Ordered>(polynomial: &[R]) -> Vec<R> {
    let degree = polynomial.len().saturating_sub(1);
    let terms = polynomial[..degree].iter().enumerate();
    terms.map(|(k, c)| c.times(&c.integer((degree - k) as i64))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use field::{Rational, Scalar};

    #[test]
    fn it_vanishes_where_a_root_is_shared_or_repeated() {
        let poly = |c: &[i64]| -> Vec<Rational> { c.iter().map(|n| Rational::int(*n)).collect() };
        let (one, zero) = (Rational::int(1), Rational::int(0));
        // (z - 1)(z - 2), (z - 2)(z + 5), z^2 + 1
        let (a, b, c) = (poly(&[1, -3, 2]), poly(&[1, 3, -10]), poly(&[1, 0, 1]));
        assert_eq!(resultant(&a, &b, &one), zero);
        // the product of c at the roots of a
        assert_eq!(resultant(&a, &c, &one), Rational::int(10));
        let cubic = poly(&[1, -4, 5, -2]);
        assert_eq!(resultant(&cubic, &derivative(&cubic), &one), zero);
        assert_ne!(resultant(&a, &derivative(&a), &one), zero);
    }
}
