//! Numbers a + b sqrt(d) with rational a, b, d.

use super::Ordered;
use field::Rational;
use num_traits::Zero;

/// The number a + b sqrt(d), where d is positive and no square. Operations on numbers with different d are undefined
/// unless one of them is rational.
#[derive(Clone, Copy, Debug)]
pub struct Surd {
    pub(super) rational: Rational,
    pub(super) factor: Rational,
    pub(super) square: Rational,
}

impl From<Rational> for Surd {
    fn from(rational: Rational) -> Self {
        Surd { rational, factor: Rational::zero(), square: Rational::zero() }
    }
}

impl Surd {
    /// The square root of a fraction; `None` where it is negative or undefined.
    pub fn root_of(square: Rational) -> Option<Self> {
        if square.sign()? < 0 {
            return None;
        }
        match square.root() {
            Some(root) => Some(root.into()),
            None => Some(Surd { rational: Rational::zero(), factor: Rational::new(1, 1), square }),
        }
    }

    /// The value as a fraction; `None` where it has a square root.
    pub fn as_fraction(&self) -> Option<Rational> {
        (self.factor.is_zero() && self.rational.is_defined()).then_some(self.rational)
    }

    /// A float close to the value, for display.
    pub fn to_f64(&self) -> f64 {
        self.rational.to_f64() + self.factor.to_f64() * self.square.to_f64().sqrt()
    }

    /// The common d of two numbers; undefined where they differ.
    fn common(&self, b: &Self) -> Rational {
        match (self.factor.is_zero(), b.factor.is_zero()) {
            (true, _) => b.square,
            (_, true) => self.square,
            _ if self.square == b.square => self.square,
            _ => Rational::UNDEFINED,
        }
    }

    fn with(rational: Rational, factor: Rational, square: Rational) -> Self {
        let whole = if square.is_defined() { rational } else { Rational::UNDEFINED };
        Surd { rational: whole, factor, square }
    }
}

impl Ordered for Surd {
    fn fraction(&self, value: Rational) -> Option<Self> {
        value.is_defined().then(|| value.into())
    }

    fn integer(&self, n: i64) -> Self {
        Rational::new(n, 1).into()
    }

    fn plus(&self, b: &Self) -> Self {
        Surd::with(self.rational + b.rational, self.factor + b.factor, self.common(b))
    }

    fn minus(&self, b: &Self) -> Self {
        Surd::with(self.rational - b.rational, self.factor - b.factor, self.common(b))
    }

    fn times(&self, b: &Self) -> Self {
        let square = self.common(b);
        let rational = self.rational * b.rational + self.factor * b.factor * square;
        Surd::with(rational, self.rational * b.factor + self.factor * b.rational, square)
    }

    fn over(&self, b: &Self) -> Option<Self> {
        // multiplication with the conjugate
        let norm = b.rational * b.rational - b.factor * b.factor * b.square;
        let turned = Surd { factor: -b.factor, ..*b };
        let product = self.times(&turned);
        let (rational, factor) = (product.rational / norm, product.factor / norm);
        (rational.is_defined() && factor.is_defined()).then(|| Surd::with(rational, factor, product.square))
    }

    fn root(&self) -> Option<Self> {
        self.factor.is_zero().then(|| Surd::root_of(self.rational)).flatten()
    }

    fn sign(&self) -> Option<i32> {
        let (a, b) = (self.rational.sign()?, self.factor.sign()?);
        if a == b || b == 0 {
            return Some(a);
        }
        if a == 0 {
            return Some(b);
        }
        // the parts differ in sign: the larger square decides
        let larger = (self.rational * self.rational - self.factor * self.factor * self.square).sign()?;
        Some(if larger > 0 { a } else { b })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surd(a: i64, b: i64, d: i64) -> Surd {
        let root = Surd::root_of(Rational::new(d, 1)).unwrap();
        let factor = root.integer(b);
        root.integer(a).plus(&root.times(&factor))
    }

    #[test]
    fn signs_are_exact_however_close_to_zero() {
        // the convergents 99/70 and 239/169 of sqrt(2)
        assert_eq!(surd(99, -70, 2).sign(), Some(1));
        assert_eq!(surd(239, -169, 2).sign(), Some(-1));
        assert_eq!(surd(-99, 70, 2).sign(), Some(-1));
        assert_eq!(surd(0, 3, 2).sign(), Some(1));
        assert_eq!(surd(6, -2, 9).sign(), Some(0));
    }

    #[test]
    fn a_quotient_times_its_divisor_is_the_dividend() {
        let (a, b) = (surd(3, -5, 7), surd(-2, 11, 7));
        let back = a.over(&b).unwrap().times(&b);
        assert_eq!(back.minus(&a).sign(), Some(0));
        assert!(a.over(&surd(0, 0, 7)).is_none());
    }

    #[test]
    fn two_different_roots_have_no_sum_here() {
        assert_eq!(surd(1, 1, 2).plus(&surd(1, 1, 3)).sign(), None);
    }
}
