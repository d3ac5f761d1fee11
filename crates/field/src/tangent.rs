//! First derivatives in any field, forward mode.
//!
//! num-dual's duals need an ordered base with a value in `f64`; a proof runs over a field that has neither. A tangent
//! asks for the field operations alone, so the same derivation runs over `f64`, exact rationals, double-double and
//! expressions. Nested once it gives second derivatives. Over `f64` num-dual is the second route that checks it.

use crate::{Analytic, Base, Circle, Divisor, Over, Scalar};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

/// value + slope e with e^2 = 0.
///
/// That a number rests is known beside its slope, since over numbers that round no compiler may leave out a product with
/// zero: a law differentiated by one variable costs what is written down by hand, as far as it is inlined.
#[derive(Clone, Copy, Debug)]
pub struct Tangent<S> {
    pub value: S,
    pub slope: S,
    /// Whether the slope may be other than zero.
    moves: bool,
}

impl<S: Scalar> Tangent<S> {
    /// A number that does not move.
    #[inline(always)]
    pub fn fixed(value: S) -> Self {
        Tangent { value, slope: S::zero(), moves: false }
    }

    /// A number that moves at the rate `slope`.
    #[inline(always)]
    pub fn moving(value: S, slope: S) -> Self {
        Tangent { value, slope, moves: true }
    }

    /// The variable of differentiation: slope 1.
    #[inline(always)]
    pub fn variable(value: S) -> Self {
        Tangent::moving(value, S::one())
    }
}

impl<S: PartialEq> PartialEq for Tangent<S> {
    #[inline(always)]
    fn eq(&self, b: &Self) -> bool {
        self.value == b.value && self.slope == b.slope
    }
}

impl<S: Scalar> Add for Tangent<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        let value = self.value + b.value;
        match (self.moves, b.moves) {
            (true, true) => Tangent::moving(value, self.slope + b.slope),
            (true, false) => Tangent::moving(value, self.slope),
            (false, true) => Tangent::moving(value, b.slope),
            (false, false) => Tangent::fixed(value),
        }
    }
}

impl<S: Scalar> Sub for Tangent<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        let value = self.value - b.value;
        match (self.moves, b.moves) {
            (true, true) => Tangent::moving(value, self.slope - b.slope),
            (true, false) => Tangent::moving(value, self.slope),
            (false, true) => Tangent::moving(value, -b.slope),
            (false, false) => Tangent::fixed(value),
        }
    }
}

impl<S: Scalar> Mul for Tangent<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        let value = self.value * b.value;
        match (self.moves, b.moves) {
            (true, true) => Tangent::moving(value, (self.slope * b.value).and_product(self.value, b.slope)),
            (true, false) => Tangent::moving(value, self.slope * b.value),
            (false, true) => Tangent::moving(value, self.value * b.slope),
            (false, false) => Tangent::fixed(value),
        }
    }
}

impl<S: Scalar> Div for Tangent<S> {
    type Output = Self;
    #[inline]
    fn div(self, b: Self) -> Self {
        let value = self.value / b.value;
        match (self.moves, b.moves) {
            (_, true) => Tangent::moving(value, (self.slope - value * b.slope) / b.value),
            (true, false) => Tangent::moving(value, self.slope / b.value),
            (false, false) => Tangent::fixed(value),
        }
    }
}

/// In a field every remainder is zero (nalgebra and num-traits ask for the operator).
impl<S: Scalar> Rem for Tangent<S> {
    type Output = Self;
    fn rem(self, b: Self) -> Self {
        Tangent::fixed(self.value % b.value)
    }
}

impl<S: Scalar> Neg for Tangent<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        if self.moves { Tangent::moving(-self.value, -self.slope) } else { Tangent::fixed(-self.value) }
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
    #[inline(always)]
    fn zero() -> Self {
        Self::fixed(S::zero())
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope.is_zero()
    }
}

impl<S: Scalar> One for Tangent<S> {
    #[inline(always)]
    fn one() -> Self {
        Self::fixed(S::one())
    }
}

impl<S: Scalar> Scalar for Tangent<S> {
    #[inline(always)]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::fixed(S::ratio(numerator, denominator))
    }

    #[inline(always)]
    fn and_product(self, a: Self, b: Self) -> Self {
        let value = self.value.and_product(a.value, b.value);
        let slope = if self.moves { Some(self.slope) } else { None };
        let slope = if a.moves { Some(and(slope, a.slope, b.value)) } else { slope };
        let slope = if b.moves { Some(and(slope, a.value, b.slope)) } else { slope };
        slope.map_or(Tangent::fixed(value), |slope| Tangent::moving(value, slope))
    }

    #[inline(always)]
    fn less_product(self, a: Self, b: Self) -> Self {
        self.and_product(-a, b)
    }
}

/// sum + a b, where nothing was summed yet a b.
#[inline(always)]
fn and<S: Scalar>(sum: Option<S>, a: S, b: S) -> S {
    match sum {
        Some(sum) => sum.and_product(a, b),
        None => a * b,
    }
}

impl<P: Base, S: Over<P>> Over<P> for Tangent<S> {
    #[inline(always)]
    fn lift(parameter: P) -> Self {
        Self::fixed(S::lift(parameter))
    }

    #[inline(always)]
    fn divided_by(self, divisor: Divisor<P>) -> Self {
        let value = self.value.divided_by(divisor);
        if self.moves { Tangent::moving(value, self.slope.divided_by(divisor)) } else { Tangent::fixed(value) }
    }
}

impl<S: Analytic> Analytic for Tangent<S> {
    #[inline]
    fn circle(self) -> Circle<Self> {
        if self.moves { self.value.circle().moving(self.slope) } else { self.value.circle().map(Tangent::fixed) }
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        if self.moves { Tangent::moving(root, self.slope / (root + root)) } else { Tangent::fixed(root) }
    }
}
