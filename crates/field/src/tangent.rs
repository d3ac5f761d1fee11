//! First derivatives in any field, forward mode.
//!
//! num-dual's duals need an ordered base with a value in `f64`; a proof runs over a field that has neither. A tangent
//! asks for the field operations alone, so the same derivation runs over `f64`, exact rationals, double-double and
//! expressions. Nested once it gives second derivatives. Over `f64` num-dual is the second route that checks it.

use crate::{Analytic, Base, Circle, Divisor, Over, Scalar};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

/// value + slope e with e^2 = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangent<S> {
    pub value: S,
    pub slope: S,
}

impl<S: Scalar> Tangent<S> {
    /// A number that does not move.
    #[inline(always)]
    pub fn fixed(value: S) -> Self {
        Tangent { value, slope: S::zero() }
    }

    /// A number that moves at the rate `slope`.
    #[inline(always)]
    pub fn moving(value: S, slope: S) -> Self {
        Tangent { value, slope }
    }

    /// The variable of differentiation: slope 1.
    #[inline(always)]
    pub fn variable(value: S) -> Self {
        Tangent { value, slope: S::one() }
    }
}

impl<S: Scalar> Add for Tangent<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        Tangent { value: self.value + b.value, slope: self.slope + b.slope }
    }
}

impl<S: Scalar> Sub for Tangent<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        Tangent { value: self.value - b.value, slope: self.slope - b.slope }
    }
}

impl<S: Scalar> Mul for Tangent<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Tangent { value: self.value * b.value, slope: (self.slope * b.value).and_product(self.value, b.slope) }
    }
}

impl<S: Scalar> Div for Tangent<S> {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        let value = self.value / b.value;
        Tangent { value, slope: (self.slope - value * b.slope) / b.value }
    }
}

/// In a field every remainder is zero (nalgebra and num-traits ask for the operator).
impl<S: Scalar> Rem for Tangent<S> {
    type Output = Self;
    fn rem(self, b: Self) -> Self {
        Tangent { value: self.value % b.value, slope: S::zero() }
    }
}

impl<S: Scalar> Neg for Tangent<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Tangent { value: -self.value, slope: -self.slope }
    }
}

macro_rules! assign {
    ($($op:ident $method:ident $sign:tt),*) => {$(
        impl<S: Scalar> $op for Tangent<S> {
            #[inline]
            fn $method(&mut self, b: Self) {
                *self = *self $sign b;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /, RemAssign rem_assign %);

impl<S: Scalar> Zero for Tangent<S> {
    fn zero() -> Self {
        Self::fixed(S::zero())
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope.is_zero()
    }
}

impl<S: Scalar> One for Tangent<S> {
    fn one() -> Self {
        Self::fixed(S::one())
    }
}

impl<S: Scalar> Scalar for Tangent<S> {
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::fixed(S::ratio(numerator, denominator))
    }
}

impl<P: Base, S: Over<P>> Over<P> for Tangent<S> {
    #[inline(always)]
    fn lift(parameter: P) -> Self {
        Self::fixed(S::lift(parameter))
    }

    #[inline(always)]
    fn divided_by(self, divisor: Divisor<P>) -> Self {
        Tangent { value: self.value.divided_by(divisor), slope: self.slope.divided_by(divisor) }
    }
}

impl<S: Analytic> Analytic for Tangent<S> {
    #[inline]
    fn circle(self) -> Circle<Self> {
        self.value.circle().moving(self.slope)
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Tangent { value: root, slope: self.slope / (root + root) }
    }
}
