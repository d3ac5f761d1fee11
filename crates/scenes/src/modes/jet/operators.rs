//! Field operations on truncated Taylor series with bounds of rounding errors.

use super::{Jet, ROUNDING};
use field::Scalar;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

impl<const N: usize> Add for Jet<N> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        self.plus(b.terms, b.doubts)
    }
}

impl<const N: usize> Sub for Jet<N> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self.plus(b.terms.map(|term| -term), b.doubts)
    }
}

impl<const N: usize> Neg for Jet<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.by_terms(|term| -term)
    }
}

impl<const N: usize> Mul for Jet<N> {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let mut product = Jet::zero();
        for order in 0..N {
            for (own, other) in (0..=order).map(|own| (own, order - own)) {
                let part = self.terms[own] * b.terms[other];
                product.terms[order] += part;
                product.doubts[order] += self.terms[own].abs() * b.doubts[other]
                    + self.doubts[own] * (b.terms[other].abs() + b.doubts[other])
                    + ROUNDING * part.abs();
            }
        }
        product
    }
}

impl<const N: usize> Div for Jet<N> {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        let (mut quotient, divisor) = (Jet::<N>::zero(), b.terms[0]);
        for order in 0..N {
            let (mut rest, mut doubt) = (self.terms[order], self.doubts[order]);
            for (later, earlier) in (1..=order).map(|later| (later, order - later)) {
                let part = b.terms[later] * quotient.terms[earlier];
                rest -= part;
                doubt += b.terms[later].abs() * quotient.doubts[earlier]
                    + b.doubts[later] * quotient.terms[earlier].abs()
                    + ROUNDING * part.abs();
            }
            let term = rest / divisor;
            quotient.terms[order] = term;
            quotient.doubts[order] = (doubt + term.abs() * b.doubts[0]) / divisor.abs() + ROUNDING * term.abs();
        }
        quotient
    }
}

/// In a field every remainder is zero (num-traits asks for the operator).
impl<const N: usize> Rem for Jet<N> {
    type Output = Self;
    fn rem(self, _: Self) -> Self {
        Jet::zero()
    }
}

macro_rules! assign {
    ($($op:ident $method:ident $sign:tt),*) => {$(
        impl<const N: usize> $op for Jet<N> {
            fn $method(&mut self, b: Self) {
                *self = *self $sign b;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /, RemAssign rem_assign %);

impl<const N: usize> Zero for Jet<N> {
    fn zero() -> Self {
        Jet { terms: [0.0; N], doubts: [0.0; N] }
    }

    fn is_zero(&self) -> bool {
        *self == Jet::zero()
    }
}

impl<const N: usize> One for Jet<N> {
    fn one() -> Self {
        Jet::constant(1.0, 0.0)
    }
}

impl<const N: usize> Scalar for Jet<N> {
    fn ratio(numerator: i64, denominator: i64) -> Self {
        let value = f64::ratio(numerator, denominator);
        Jet::constant(value, ROUNDING * value.abs())
    }
}
