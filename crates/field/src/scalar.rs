//! The scalar traits: the operations that laws may use.

use num_traits::{NumAssignOps, NumOps, One, Zero};
use std::fmt::Debug;
use std::ops::Neg;
use xprec::Df64;

use crate::sincos_double_double;
use crate::sincos_f64::{far, is_near, near, plus};
use crate::{Circle, Elementary};

/// A number of a field: operations and exact constants, without order and without rounding to `f64`.
pub trait Scalar: Copy + Debug + PartialEq + 'static + Zero + One + NumOps + NumAssignOps + Neg<Output = Self> {
    /// Whether operations are function calls: compound code, such as derivatives, is then not inlined either.
    const CALLS: bool = false;

    /// The quotient of two integers, to the precision of the type. `denominator` must not be zero.
    fn ratio(numerator: i64, denominator: i64) -> Self;

    /// An integer.
    fn int(n: i64) -> Self {
        Self::ratio(n, 1)
    }

    /// x + a b; rounding types may round once.
    #[inline(always)]
    fn and_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    /// x - a b; rounding types may round once.
    #[inline(always)]
    fn less_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }

    /// x a + b; `f64` rounds once on every processor, for bitwise equal results on all of them.
    #[inline(always)]
    fn times_and(self, a: Self, b: Self) -> Self {
        b + self * a
    }

    /// x / 2.
    #[inline(always)]
    fn half(self) -> Self {
        self * Self::ratio(1, 2)
    }

    /// x^2.
    #[inline(always)]
    fn squared(self) -> Self {
        self * self
    }
}

/// A scalar type for parameters: not itself an extension by derivatives.
pub trait Base: Over<Self> {}

/// A scalar type that contains the type `P` of the parameters: laws have parameters in `P` and are evaluated over any
/// `S: Over<P>`.
pub trait Over<P: Scalar>: Scalar {
    /// A parameter as a number of this type, with zero derivatives.
    fn lift(parameter: P) -> Self;

    /// x / d, to the precision of this type; a type no finer than `P` multiplies by the reciprocal.
    #[inline(always)]
    fn divided_by(self, divisor: Divisor<P>) -> Self {
        self / Self::lift(divisor.value)
    }
}

/// A parameter used as a divisor, with its reciprocal, which is computed once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Divisor<P> {
    value: P,
    reciprocal: P,
}

impl<P: Base> Divisor<P> {
    /// The divisor `value`, which must not be zero.
    #[inline(always)]
    pub fn new(value: P) -> Self {
        Divisor { value, reciprocal: P::one() / value }
    }

    /// The divisor d.
    #[inline(always)]
    pub fn value(self) -> P {
        self.value
    }

    /// The reciprocal 1/d, rounded if P rounds.
    #[inline(always)]
    pub fn reciprocal(self) -> P {
        self.reciprocal
    }
}

/// A scalar type with square roots, circle points and elementary functions.
pub trait Analytic: Scalar {
    /// (cos x, sin x) of an angle x in rad.
    fn circle(self) -> Circle<Self>;

    /// As [`Analytic::circle`], where `f64` rounds each product with its sum once on every processor: see
    /// [`Scalar::times_and`].
    #[inline(always)]
    fn circle_once(self) -> Circle<Self> {
        self.circle()
    }

    /// The nonnegative square root.
    fn sqrt(self) -> Self;

    /// An elementary function of this number and, for two arguments, of another.
    fn elementary(self, function: Elementary, other: Self) -> Self;
}

impl Scalar for f64 {
    #[inline(always)]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        numerator as f64 / denominator as f64
    }

    #[inline(always)]
    fn and_product(self, a: Self, b: Self) -> Self {
        plus::<FUSED>(self, a, b)
    }

    #[inline(always)]
    fn less_product(self, a: Self, b: Self) -> Self {
        plus::<FUSED>(self, -a, b)
    }

    #[inline(always)]
    fn times_and(self, a: Self, b: Self) -> Self {
        self.mul_add(a, b)
    }
}

/// Whether the compilation target has fused multiply-add instructions.
const FUSED: bool = cfg!(target_feature = "fma");

impl Base for f64 {}

impl Over<f64> for f64 {
    #[inline(always)]
    fn lift(parameter: f64) -> Self {
        parameter
    }

    #[inline(always)]
    fn divided_by(self, divisor: Divisor<f64>) -> Self {
        self * divisor.reciprocal
    }
}

impl Analytic for f64 {
    #[inline(always)]
    fn circle(self) -> Circle<Self> {
        if is_near(self) { near::<FUSED>(self) } else { far(self) }
    }

    #[inline(always)]
    fn circle_once(self) -> Circle<Self> {
        if is_near(self) { near::<true>(self) } else { far(self) }
    }

    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    fn elementary(self, function: Elementary, other: Self) -> Self {
        function.of(self, other)
    }
}

impl Scalar for Df64 {
    fn ratio(numerator: i64, denominator: i64) -> Self {
        exact_integer(numerator) / exact_integer(denominator)
    }
}

impl Base for Df64 {}

impl Over<Df64> for Df64 {
    #[inline]
    fn lift(parameter: Df64) -> Self {
        parameter
    }
}

/// Data in `f64` are exact in double-double.
impl Over<f64> for Df64 {
    #[inline]
    fn lift(parameter: f64) -> Self {
        Df64::from(parameter)
    }
}

impl Analytic for Df64 {
    // always inlined, so that a caller compiled with fused products uses them here too
    #[inline(always)]
    fn circle(self) -> Circle<Self> {
        // beyond this, turns are not counted exactly; results would be lost in rounding anyway
        let countable = self.hi().abs() < MOST_ANGLE;
        if countable { sincos_double_double::point(self) } else { Circle { cos: NONE, sin: NONE } }
    }

    fn sqrt(self) -> Self {
        num_traits::Float::sqrt(self)
    }

    fn elementary(self, function: Elementary, other: Self) -> Self {
        let leading = function.of(self.hi(), other.hi());
        if !leading.is_finite() || leading == 0.0 {
            // outside the range of f64 the low part is meaningless
            return Df64::from(leading);
        }
        match function {
            Elementary::Exp => self.exp(),
            Elementary::Ln => self.ln(),
            Elementary::Tanh => self.tanh(),
            Elementary::Atan2 => self.atan2(other),
        }
    }
}

const MOST_ANGLE: f64 = 1e14;
const NONE: Df64 = Df64::new(f64::NAN);

/// An `i64` has up to 63 bits: its halves are exact in `f64`, and their sum in double-double.
fn exact_integer(n: i64) -> Df64 {
    let low = n & 0xffff_ffff;
    Df64::from((n - low) as f64) + Df64::from(low as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_beyond_reduction_is_no_number() {
        for angle in [1e14, -1e20, f64::INFINITY, f64::NAN] {
            assert!(Df64::from(angle).circle().cos.hi().is_nan(), "{angle}");
        }
        let near = Df64::from(2.9e9).circle();
        assert!((near.cos.hi() - 2.9e9_f64.cos()).abs() < 1e-15 && (near.sin.hi() - 2.9e9_f64.sin()).abs() < 1e-15);
    }
}
