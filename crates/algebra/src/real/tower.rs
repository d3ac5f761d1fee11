//! Numbers a + b sqrt(e), where a and b have a common square root of their own.

use super::{Ordered, Surd};
use field::Rational;
use num_traits::Zero;

/// The number a + b sqrt(e) with a positive fraction e. Operations on numbers with different e are undefined unless one
/// of them has no such root.
#[derive(Clone, Copy, Debug)]
pub struct Tower {
    base: Surd,
    factor: Surd,
    square: Rational,
}

impl From<Surd> for Tower {
    fn from(base: Surd) -> Self {
        Tower { base, factor: Rational::zero().into(), square: Rational::zero() }
    }
}

impl Tower {
    /// A number for use together with another one: equal square roots are represented equally, so that equal numbers
    /// are equal.
    pub fn beside(value: Surd, other: &Surd) -> Self {
        let (own, known) = (value.square, other.square);
        if value.factor.is_zero() || known.is_zero() {
            return value.into();
        }
        match (own / known).root() {
            // sqrt(own) = ratio sqrt(known)
            Some(ratio) => Surd { factor: value.factor * ratio, square: known, ..value }.into(),
            None => Tower { base: value.rational.into(), factor: value.factor.into(), square: own },
        }
    }

    /// A float close to the value, for display.
    pub fn to_f64(&self) -> f64 {
        self.base.to_f64() + self.factor.to_f64() * self.square.to_f64().sqrt()
    }

    fn is_simple(&self) -> bool {
        self.factor.sign() == Some(0)
    }

    /// The common e of two numbers; undefined where they differ.
    fn common(&self, b: &Self) -> Rational {
        match (self.is_simple(), b.is_simple()) {
            (true, _) => b.square,
            (_, true) => self.square,
            _ if self.square == b.square => self.square,
            _ => Rational::UNDEFINED,
        }
    }

    fn with(base: Surd, factor: Surd, square: Rational) -> Self {
        let base = if square.is_defined() { base } else { Rational::UNDEFINED.into() };
        Tower { base, factor, square }
    }
}

impl Ordered for Tower {
    fn fraction(&self, value: Rational) -> Option<Self> {
        value.is_defined().then(|| Surd::from(value).into())
    }

    fn integer(&self, n: i64) -> Self {
        Surd::from(Rational::new(n, 1)).into()
    }

    fn plus(&self, b: &Self) -> Self {
        Tower::with(self.base.plus(&b.base), self.factor.plus(&b.factor), self.common(b))
    }

    fn minus(&self, b: &Self) -> Self {
        Tower::with(self.base.minus(&b.base), self.factor.minus(&b.factor), self.common(b))
    }

    fn times(&self, b: &Self) -> Self {
        let square = self.common(b);
        let both = self.factor.times(&b.factor).times(&square.into());
        let mixed = self.base.times(&b.factor).plus(&self.factor.times(&b.base));
        Tower::with(self.base.times(&b.base).plus(&both), mixed, square)
    }

    fn over(&self, b: &Self) -> Option<Self> {
        // multiplication with the conjugate
        let norm = b.base.times(&b.base).minus(&b.factor.times(&b.factor).times(&b.square.into()));
        let turned = Tower { factor: norm.integer(0).minus(&b.factor), ..*b };
        let product = self.times(&turned);
        Some(Tower::with(product.base.over(&norm)?, product.factor.over(&norm)?, product.square))
    }

    fn root(&self) -> Option<Self> {
        self.is_simple().then(|| self.base.root().map(Tower::from)).flatten()
    }

    fn sign(&self) -> Option<i32> {
        let (a, b) = (self.base.sign()?, self.factor.sign()?);
        if a == b || b == 0 {
            return Some(a);
        }
        if a == 0 {
            return Some(b);
        }
        // the parts differ in sign: the larger square decides
        let other = self.factor.times(&self.factor).times(&self.square.into());
        let larger = self.base.times(&self.base).minus(&other).sign()?;
        Some(match larger {
            0 => 0,
            1 => a,
            _ => b,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(n: i64) -> Surd {
        Surd::root_of(Rational::new(n, 1)).unwrap()
    }

    #[test]
    fn signs_with_two_roots_are_exact() {
        let (a, b) = (Tower::from(root(2)), Tower::beside(root(3), &root(2)));
        // (sqrt(2) + sqrt(3))^2 - 5 - 2 sqrt(6) = 0, and sqrt(2) + sqrt(3) = 3.14626437
        let sum = a.plus(&b);
        let mixed = a.times(&b);
        let rest = sum.times(&sum).minus(&a.integer(5)).minus(&mixed.plus(&mixed));
        assert_eq!(rest.sign(), Some(0));
        let near = |n: i64| sum.minus(&sum.fraction(Rational::new(n, 10_000_000)).unwrap()).sign();
        assert_eq!((near(31_462_643), near(31_462_644)), (Some(1), Some(-1)));
        let back = a.over(&sum).unwrap().times(&sum).minus(&a);
        assert_eq!(back.sign(), Some(0));
    }

    #[test]
    fn a_root_that_is_a_multiple_of_another_is_written_with_it() {
        // sqrt(8) = 2 sqrt(2)
        let (a, b) = (Tower::from(root(2)), Tower::beside(root(8), &root(2)));
        assert_eq!(a.plus(&a).minus(&b).sign(), Some(0));
        assert!(a.over(&b.minus(&a)).is_some());
    }
}
