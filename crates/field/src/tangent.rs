//! First derivatives by forward-mode differentiation over any scalar type.
//!
//! The dual numbers of `num-dual` need an ordered base type with a value in `f64`, which symbolic and exact types lack.
//! A tangent needs field operations only: one derivation is valid over `f64`, exact rationals, double-double and
//! expressions. Nesting gives second derivatives. Over `f64` num-dual is an independent check.

use crate::{Analytic, Base, Circle, Divisor, Elementary, Over, Scalar};
use num_traits::{One, Zero};
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

/// Run-time knowledge of whether the derivative of a number is zero.
///
/// With `()` there is none, and all products with zero derivatives are computed. With `bool` they are skipped, which a
/// compiler may not do in floating point: a short law that is inlined completely then costs as much as derivatives
/// written by hand. (A long law, or one differentiated twice, would be compiled for every combination of constant
/// numbers.)
pub trait DerivativeKnowledge: Copy + Debug + 'static {
    const KNOWN: bool;
    fn of(moves: bool) -> Self;
    fn moves(self) -> bool;
}

impl DerivativeKnowledge for () {
    const KNOWN: bool = false;

    #[inline(always)]
    fn of(_: bool) {}

    #[inline(always)]
    fn moves(self) -> bool {
        true
    }
}

impl DerivativeKnowledge for bool {
    const KNOWN: bool = true;

    #[inline(always)]
    fn of(moves: bool) -> bool {
        moves
    }

    #[inline(always)]
    fn moves(self) -> bool {
        self
    }
}

/// The dual number value + slope e with e^2 = 0.
#[derive(Clone, Copy, Debug)]
pub struct Tangent<S, M = ()> {
    pub value: S,
    pub slope: S,
    motion: M,
}

impl<S: Scalar> Tangent<S> {
    /// A constant: slope 0.
    #[inline(always)]
    pub fn fixed(value: S) -> Self {
        Tangent::at_rest(value)
    }

    /// A number with the derivative `slope`.
    #[inline(always)]
    pub fn moving(value: S, slope: S) -> Self {
        Tangent::at_rate(value, slope)
    }

    /// The variable of differentiation: slope 1.
    #[inline(always)]
    pub fn variable(value: S) -> Self {
        Tangent::moving(value, S::one())
    }
}

impl<S: Scalar, M: DerivativeKnowledge> Tangent<S, M> {
    #[inline(always)]
    fn at_rest(value: S) -> Self {
        Tangent { value, slope: S::zero(), motion: M::of(false) }
    }

    #[inline(always)]
    pub(crate) fn at_rate(value: S, slope: S) -> Self {
        Tangent { value, slope, motion: M::of(true) }
    }

    #[inline(always)]
    fn sum(self, b: Self) -> Self {
        let value = self.value + b.value;
        if M::KNOWN {
            match (self.rests(), b.rests()) {
                (true, true) => return Tangent::at_rest(value),
                (true, false) => return Tangent::at_rate(value, b.slope),
                (false, true) => return Tangent::at_rate(value, self.slope),
                (false, false) => {}
            }
        }
        Tangent::at_rate(value, self.slope + b.slope)
    }

    #[inline(always)]
    fn difference(self, b: Self) -> Self {
        let value = self.value - b.value;
        if M::KNOWN {
            match (self.rests(), b.rests()) {
                (true, true) => return Tangent::at_rest(value),
                (true, false) => return Tangent::at_rate(value, -b.slope),
                (false, true) => return Tangent::at_rate(value, self.slope),
                (false, false) => {}
            }
        }
        Tangent::at_rate(value, self.slope - b.slope)
    }

    #[inline(always)]
    fn product(self, b: Self) -> Self {
        let value = self.value * b.value;
        if M::KNOWN {
            match (self.rests(), b.rests()) {
                (true, true) => return Tangent::at_rest(value),
                (true, false) => return Tangent::at_rate(value, self.value * b.slope),
                (false, true) => return Tangent::at_rate(value, self.slope * b.value),
                (false, false) => {}
            }
        }
        Tangent::at_rate(value, (self.slope * b.value).and_product(self.value, b.slope))
    }

    #[inline]
    fn quotient(self, b: Self) -> Self {
        let value = self.value / b.value;
        if M::KNOWN && b.rests() {
            return if self.rests() { Tangent::at_rest(value) } else { Tangent::at_rate(value, self.slope / b.value) };
        }
        Tangent::at_rate(value, (self.slope - value * b.slope) / b.value)
    }

    #[inline(always)]
    fn rests(&self) -> bool {
        !self.motion.moves()
    }
}

/// The operations as function calls.
mod called {
    use super::{DerivativeKnowledge, Scalar, Tangent};

    macro_rules! calls {
        ($($operation:ident),*) => {$(
            #[inline(never)]
            pub fn $operation<S: Scalar, M: DerivativeKnowledge>(a: Tangent<S, M>, b: Tangent<S, M>) -> Tangent<S, M> {
                a.$operation(b)
            }
        )*};
    }
    calls!(sum, difference, product, quotient);
}

impl<S: PartialEq, M> PartialEq for Tangent<S, M> {
    #[inline(always)]
    fn eq(&self, b: &Self) -> bool {
        self.value == b.value && self.slope == b.slope
    }
}

impl<S: Scalar, M: DerivativeKnowledge> Add for Tangent<S, M> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        if S::CALLS { called::sum(self, b) } else { self.sum(b) }
    }
}

impl<S: Scalar, M: DerivativeKnowledge> Sub for Tangent<S, M> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        if S::CALLS { called::difference(self, b) } else { self.difference(b) }
    }
}

impl<S: Scalar, M: DerivativeKnowledge> Mul for Tangent<S, M> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        if S::CALLS { called::product(self, b) } else { self.product(b) }
    }
}

impl<S: Scalar, M: DerivativeKnowledge> Div for Tangent<S, M> {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        if S::CALLS { called::quotient(self, b) } else { self.quotient(b) }
    }
}

/// In a field every remainder is zero (nalgebra and num-traits ask for the operator).
impl<S: Scalar, M: DerivativeKnowledge> Rem for Tangent<S, M> {
    type Output = Self;
    fn rem(self, b: Self) -> Self {
        Tangent::at_rest(self.value % b.value)
    }
}

impl<S: Scalar, M: DerivativeKnowledge> Neg for Tangent<S, M> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Tangent { value: -self.value, slope: -self.slope, motion: self.motion }
    }
}

macro_rules! assign {
    ($($op:ident $method:ident $sign:tt),*) => {$(
        impl<S: Scalar, M: DerivativeKnowledge> $op for Tangent<S, M> {
            #[inline]
            fn $method(&mut self, b: Self) {
                *self = *self $sign b;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /, RemAssign rem_assign %);

impl<S: Scalar, M: DerivativeKnowledge> Zero for Tangent<S, M> {
    fn zero() -> Self {
        Self::at_rest(S::zero())
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope.is_zero()
    }
}

impl<S: Scalar, M: DerivativeKnowledge> One for Tangent<S, M> {
    fn one() -> Self {
        Self::at_rest(S::one())
    }
}

impl<S: Scalar, M: DerivativeKnowledge> Scalar for Tangent<S, M> {
    const CALLS: bool = S::CALLS;

    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::at_rest(S::ratio(numerator, denominator))
    }
}

impl<S: Scalar + From<f64>, M: DerivativeKnowledge> From<f64> for Tangent<S, M> {
    fn from(number: f64) -> Self {
        Self::at_rest(S::from(number))
    }
}

impl<P: Base, S: Over<P>, M: DerivativeKnowledge> Over<P> for Tangent<S, M> {
    #[inline(always)]
    fn lift(parameter: P) -> Self {
        Self::at_rest(S::lift(parameter))
    }

    #[inline(always)]
    fn divided_by(self, divisor: Divisor<P>) -> Self {
        let [value, slope] = [self.value, self.slope].map(|number| number.divided_by(divisor));
        Tangent { value, slope, motion: self.motion }
    }
}

impl<S: Analytic, M: DerivativeKnowledge> Analytic for Tangent<S, M> {
    #[inline]
    fn circle(self) -> Circle<Self> {
        let Circle { cos, sin } = self.value.circle();
        if M::KNOWN && self.rests() {
            return Circle { cos, sin }.map(Tangent::at_rest);
        }
        Circle { cos: Tangent::at_rate(cos, -sin * self.slope), sin: Tangent::at_rate(sin, cos * self.slope) }
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        if M::KNOWN && self.rests() {
            return Tangent::at_rest(root);
        }
        Tangent::at_rate(root, self.slope / (root + root))
    }

    fn elementary(self, function: Elementary, other: Self) -> Self {
        let value = self.value.elementary(function, other.value);
        if M::KNOWN && self.rests() && other.rests() {
            return Tangent::at_rest(value);
        }
        let [by_first, by_second] = function.slopes(self.value, other.value, value);
        Tangent::at_rate(value, by_first * self.slope + by_second * other.slope)
    }
}
