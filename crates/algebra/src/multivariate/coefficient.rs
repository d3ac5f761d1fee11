//! Integer coefficients of polynomials: machine integers, or big integers where necessary.

use super::Limit;
use dashu_int::IBig;
use dashu_int::ops::{Abs, DivRem, Gcd};
use std::fmt::Debug;

/// An integer type. Operations of machine integers report an overflow; the computation is then repeated with big
/// integers.
pub trait Coefficient: Clone + Debug + PartialEq + 'static {
    fn of(value: i64) -> Self;
    fn from_big(value: &IBig) -> Result<Self, Limit>;
    fn to_big(&self) -> IBig;
    fn is_zero(&self) -> bool;
    fn is_negative(&self) -> bool;
    fn plus(&self, other: &Self) -> Result<Self, Limit>;
    fn times(&self, other: &Self) -> Result<Self, Limit>;
    fn negated(&self) -> Self;
    /// The quotient; `None` where the division leaves a remainder.
    fn exact_quotient(&self, divisor: &Self) -> Option<Self>;
    /// The nonnegative greatest common divisor.
    fn common(&self, other: &Self) -> Self;
    /// The residue modulo a prime below 2^62.
    fn modulo(&self, prime: u64) -> u64;
    /// The number as 64 bits; `None` where it is larger.
    fn small(&self) -> Option<i64>;
    /// The conversion of a sum of products of machine integers; `None` for the smallest `i128`.
    fn from_wide(value: i128) -> Option<Self>;

    fn is_one(&self) -> bool {
        *self == Self::of(1)
    }

    fn power(&self, exponent: u32) -> Result<Self, Limit> {
        (0..exponent).try_fold(Self::of(1), |product, _| product.times(self))
    }
}

impl Coefficient for i128 {
    fn of(value: i64) -> Self {
        value.into()
    }

    fn from_big(value: &IBig) -> Result<Self, Limit> {
        // the smallest i128 has no negative and is left to big integers
        i128::try_from(value).ok().filter(|&n| n != i128::MIN).ok_or(Limit::Overflow)
    }

    fn to_big(&self) -> IBig {
        IBig::from(*self)
    }

    fn is_zero(&self) -> bool {
        *self == 0
    }

    fn is_negative(&self) -> bool {
        *self < 0
    }

    #[inline]
    fn plus(&self, other: &Self) -> Result<Self, Limit> {
        self.checked_add(*other).filter(|&n| n != i128::MIN).ok_or(Limit::Overflow)
    }

    /// the product of two factors of 64 bits fits in 128: no check is needed, which would cost more than the product
    #[inline]
    fn times(&self, other: &Self) -> Result<Self, Limit> {
        match (i64::try_from(*self), i64::try_from(*other)) {
            (Ok(a), Ok(b)) => Ok(i128::from(a) * i128::from(b)),
            _ => self.checked_mul(*other).filter(|&n| n != i128::MIN).ok_or(Limit::Overflow),
        }
    }

    #[inline]
    fn negated(&self) -> Self {
        -self
    }

    fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        if *divisor == 1 {
            return Some(*self);
        }
        match (i64::try_from(*self), i64::try_from(*divisor)) {
            (Ok(a), Ok(b)) => (a.wrapping_rem(b) == 0).then(|| i128::from(a) / i128::from(b)),
            _ => (self % divisor == 0).then(|| self / divisor),
        }
    }

    fn common(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.unsigned_abs(), other.unsigned_abs());
        loop {
            if let (Ok(mut a), Ok(mut b)) = (u64::try_from(a), u64::try_from(b)) {
                while b != 0 {
                    (a, b) = (b, a % b);
                }
                return i128::from(a);
            }
            if b == 0 {
                // coefficients are above i128::MIN, so that their magnitudes fit
                return a as i128;
            }
            (a, b) = (b, a % b);
        }
    }

    #[inline]
    fn modulo(&self, prime: u64) -> u64 {
        match i64::try_from(*self) {
            Ok(small) => small.rem_euclid(prime as i64) as u64,
            Err(_) => self.rem_euclid(prime.into()) as u64,
        }
    }

    #[inline]
    fn small(&self) -> Option<i64> {
        i64::try_from(*self).ok()
    }

    fn from_wide(value: i128) -> Option<Self> {
        (value != i128::MIN).then_some(value)
    }
}

impl Coefficient for IBig {
    fn of(value: i64) -> Self {
        value.into()
    }

    fn from_big(value: &IBig) -> Result<Self, Limit> {
        Ok(value.clone())
    }

    fn to_big(&self) -> IBig {
        self.clone()
    }

    fn is_zero(&self) -> bool {
        *self == IBig::ZERO
    }

    fn is_negative(&self) -> bool {
        *self < IBig::ZERO
    }

    fn plus(&self, other: &Self) -> Result<Self, Limit> {
        Ok(self + other)
    }

    fn times(&self, other: &Self) -> Result<Self, Limit> {
        Ok(self * other)
    }

    fn negated(&self) -> Self {
        -self
    }

    fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let (quotient, remainder) = self.div_rem(divisor);
        (remainder == IBig::ZERO).then_some(quotient)
    }

    fn common(&self, other: &Self) -> Self {
        match (self.is_zero(), other.is_zero()) {
            (true, _) => other.clone().abs(),
            (_, true) => self.clone().abs(),
            _ => IBig::from(self.gcd(other)),
        }
    }

    fn modulo(&self, prime: u64) -> u64 {
        let remainder = self % IBig::from(prime);
        let positive = if remainder < IBig::ZERO { remainder + IBig::from(prime) } else { remainder };
        u64::try_from(&positive).unwrap_or(0)
    }

    fn small(&self) -> Option<i64> {
        i64::try_from(self).ok()
    }

    fn from_wide(value: i128) -> Option<Self> {
        Some(value.into())
    }
}
