//! Coefficient types of Taylor models: rounded numbers with a bound of the rounding error.

use super::functions::SMALL;
use field::{Analytic, DoubleDouble, Over, Rational};

/// A scalar type with a known rounding error.
pub trait Rounded: Analytic + Over<f64> {
    /// An upper bound of the relative error of one operation.
    const ROUNDING: f64;
    /// The number of terms of the series of exponentials, cosines and sines, which is even; and twice the next term at
    /// the largest argument, a bound of the truncation error.
    const TERMS: i32;
    const LEFT: f64;

    /// The nearest float; infinite or NaN where the number is.
    fn near(self) -> f64;

    /// The number nearest to a fraction, and whether it is exact.
    fn nearest(value: Rational) -> (Self, bool);

    /// The magnitude |x|, up to the rounding of a float.
    fn size(self) -> f64 {
        self.near().abs()
    }
}

impl Rounded for f64 {
    const ROUNDING: f64 = f64::EPSILON;
    const TERMS: i32 = 12;
    const LEFT: f64 = twice_the_term(13);

    fn near(self) -> f64 {
        self
    }

    fn nearest(value: Rational) -> (Self, bool) {
        let near = value.to_f64();
        (near, Rational::exactly(near) == value)
    }
}

/// The arithmetic of Joldes, Muller, Popescu (2017): with u = 2^-53 a sum has the relative error 3 u^2, a product 5
/// u^2. A reciprocal and a square root take the result of the high part, with the error u, and one Newton step, whose
/// correction is rounded to u relative to itself: 2.3 u^2 and 2 u^2, and at most 2 u^2 more where two residues below u
/// are added in the wrong order. A quotient is a reciprocal and a product. The bound used is 256 u^2.
impl Rounded for DoubleDouble {
    const ROUNDING: f64 = 64.0 * f64::EPSILON * f64::EPSILON;
    const TERMS: i32 = 22;
    const LEFT: f64 = twice_the_term(23);

    fn near(self) -> f64 {
        self.hi() + self.lo()
    }

    fn nearest(value: Rational) -> (Self, bool) {
        let high = value.to_f64();
        let rest = value - Rational::exactly(high);
        let low = rest.to_f64();
        (DoubleDouble::from(high) + DoubleDouble::from(low), Rational::exactly(low) == rest)
    }
}

/// 2 x^k/k! at the largest x, slightly increased.
const fn twice_the_term(k: i32) -> f64 {
    let (mut term, mut factor) = (2.0 + 1e-12, 1);
    while factor <= k {
        term *= SMALL / factor as f64;
        factor += 1;
    }
    term
}
