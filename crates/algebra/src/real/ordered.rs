//! The trait of exact and enclosed numbers with signs.

use super::Enclosure;
use dashu_int::IBig;
use field::Rational;

/// A number that is exact or enclosed.
pub trait Ordered: Clone {
    /// A fraction in the precision of this number; `None` where it is undefined.
    fn fraction(&self, value: Rational) -> Option<Self>;
    /// An integer in the precision of this number.
    fn integer(&self, n: i64) -> Self;
    /// The sum a + b.
    fn plus(&self, b: &Self) -> Self;
    /// The difference a - b.
    fn minus(&self, b: &Self) -> Self;
    /// The product a b.
    fn times(&self, b: &Self) -> Self;
    /// The quotient a / b; `None` where b may be zero.
    fn over(&self, b: &Self) -> Option<Self>;
    /// The square root; `None` where it is not available in this type.
    fn root(&self) -> Option<Self>;
    /// The sign: -1, 0 or 1; `None` where it is unknown.
    fn sign(&self) -> Option<i32>;
}

impl Ordered for Rational {
    fn fraction(&self, value: Rational) -> Option<Self> {
        value.is_defined().then_some(value)
    }

    fn integer(&self, n: i64) -> Self {
        Rational::new(n, 1)
    }

    fn plus(&self, b: &Self) -> Self {
        *self + *b
    }

    fn minus(&self, b: &Self) -> Self {
        *self - *b
    }

    fn times(&self, b: &Self) -> Self {
        *self * *b
    }

    fn over(&self, b: &Self) -> Option<Self> {
        Some(*self / *b).filter(|quotient| quotient.is_defined())
    }

    fn root(&self) -> Option<Self> {
        use dashu_int::ops::SquareRoot;
        let big = self.to_big().filter(|big| *big.numerator() >= IBig::ZERO)?;
        let numerator = dashu_int::UBig::try_from(big.numerator().clone()).ok()?;
        let [n, d] = [numerator, big.denominator().clone()].map(|square| (square.sqrt(), square));
        let exact = [&n, &d].into_iter().all(|(root, square)| root * root == *square);
        exact.then(|| Rational::from(dashu_ratio::RBig::from_parts(IBig::from(n.0), d.0)))
    }

    fn sign(&self) -> Option<i32> {
        Rational::sign(*self)
    }
}

impl Ordered for Enclosure {
    fn fraction(&self, value: Rational) -> Option<Self> {
        Enclosure::rational(value, self.bits())
    }

    fn integer(&self, n: i64) -> Self {
        Enclosure::integer(n, self.bits())
    }

    fn plus(&self, b: &Self) -> Self {
        self + b
    }

    fn minus(&self, b: &Self) -> Self {
        self - b
    }

    fn times(&self, b: &Self) -> Self {
        self * b
    }

    fn over(&self, b: &Self) -> Option<Self> {
        Enclosure::over(self, b)
    }

    fn root(&self) -> Option<Self> {
        self.sqrt()
    }

    fn sign(&self) -> Option<i32> {
        Enclosure::sign(self)
    }
}
