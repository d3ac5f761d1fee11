//! Batches of numbers: a law is evaluated for as many systems at once as fit in a SIMD register.

use crate::sincos_f64::{far, is_near, near, plus};
use crate::{Analytic, Base, Circle, Divisor, Elementary, Over, Scalar};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

/// L independent numbers, one in each lane. Two batches are equal if all lanes are.
///
/// Operations are plain loops that are always inlined, so that they are compiled for the registers of the caller. With
/// `FUSED` a product and a sum are rounded once, which is fast only on processors with fused multiply-add.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Batch<const L: usize, const FUSED: bool = false>(pub [f64; L]);

impl<const L: usize, const FUSED: bool> Batch<L, FUSED> {
    /// A number in every lane.
    #[inline(always)]
    pub fn all(number: f64) -> Self {
        Batch([number; L])
    }

    /// self + a b, rounded once if `fused`: for data shared between both kinds of processors.
    #[inline(always)]
    pub fn plus_product(mut self, a: Self, b: Self, fused: bool) -> Self {
        for lane in 0..L {
            self.0[lane] = if fused {
                plus::<true>(self.0[lane], a.0[lane], b.0[lane])
            } else {
                plus::<false>(self.0[lane], a.0[lane], b.0[lane])
            };
        }
        self
    }
}

macro_rules! by_lane {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $sign:tt),*) => {$(
        impl<const L: usize, const FUSED: bool> $trait for Batch<L, FUSED> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, b: Self) -> Self {
                self $sign b;
                self
            }
        }

        impl<const L: usize, const FUSED: bool> $assign for Batch<L, FUSED> {
            #[inline(always)]
            fn $assign_method(&mut self, b: Self) {
                for lane in 0..L {
                    self.0[lane] $sign b.0[lane];
                }
            }
        }
    )*};
}
by_lane!(
    Add add AddAssign add_assign +=,
    Sub sub SubAssign sub_assign -=,
    Mul mul MulAssign mul_assign *=,
    Div div DivAssign div_assign /=,
    Rem rem RemAssign rem_assign %=
);

impl<const L: usize, const FUSED: bool> Neg for Batch<L, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for lane in 0..L {
            self.0[lane] = -self.0[lane];
        }
        self
    }
}

impl<const L: usize, const FUSED: bool> Zero for Batch<L, FUSED> {
    #[inline(always)]
    fn zero() -> Self {
        Self::all(0.0)
    }

    fn is_zero(&self) -> bool {
        self.0.iter().all(|number| *number == 0.0)
    }
}

impl<const L: usize, const FUSED: bool> One for Batch<L, FUSED> {
    #[inline(always)]
    fn one() -> Self {
        Self::all(1.0)
    }
}

impl<const L: usize, const FUSED: bool> Scalar for Batch<L, FUSED> {
    #[inline(always)]
    fn ratio(numerator: i64, denominator: i64) -> Self {
        Self::all(f64::ratio(numerator, denominator))
    }

    #[inline(always)]
    fn and_product(mut self, a: Self, b: Self) -> Self {
        for lane in 0..L {
            self.0[lane] = plus::<FUSED>(self.0[lane], a.0[lane], b.0[lane]);
        }
        self
    }

    #[inline(always)]
    fn less_product(self, a: Self, b: Self) -> Self {
        self.and_product(-a, b)
    }
}

impl<const L: usize, const FUSED: bool> From<f64> for Batch<L, FUSED> {
    fn from(number: f64) -> Self {
        Self::all(number)
    }
}

impl<const L: usize, const FUSED: bool> Base for Batch<L, FUSED> {}

impl<const L: usize, const FUSED: bool> Over<Batch<L, FUSED>> for Batch<L, FUSED> {
    #[inline(always)]
    fn lift(parameter: Self) -> Self {
        parameter
    }

    #[inline(always)]
    fn divided_by(self, divisor: Divisor<Self>) -> Self {
        self * divisor.reciprocal()
    }
}

impl<const L: usize, const FUSED: bool> Over<f64> for Batch<L, FUSED> {
    #[inline(always)]
    fn lift(parameter: f64) -> Self {
        Self::all(parameter)
    }

    #[inline(always)]
    fn divided_by(self, divisor: Divisor<f64>) -> Self {
        self * Self::all(divisor.reciprocal())
    }
}

impl<const L: usize, const FUSED: bool> Analytic for Batch<L, FUSED> {
    #[inline(always)]
    fn circle(self) -> Circle<Self> {
        let mut all_near = true;
        for angle in self.0 {
            all_near &= is_near(angle);
        }
        if all_near { each(self, near::<FUSED>) } else { one_by_one(self) }
    }

    #[inline(always)]
    fn sqrt(mut self) -> Self {
        for lane in 0..L {
            self.0[lane] = self.0[lane].sqrt();
        }
        self
    }

    fn elementary(mut self, function: Elementary, other: Self) -> Self {
        for lane in 0..L {
            self.0[lane] = function.of(self.0[lane], other.0[lane]);
        }
        self
    }
}

/// Evaluates each lane separately, for large angles or angles that are not finite.
#[cold]
#[inline(never)]
fn one_by_one<const L: usize, const FUSED: bool>(angle: Batch<L, FUSED>) -> Circle<Batch<L, FUSED>> {
    each(angle, |angle| if is_near(angle) { near::<FUSED>(angle) } else { far(angle) })
}

#[inline(always)]
fn each<const L: usize, const FUSED: bool>(
    angle: Batch<L, FUSED>,
    point: impl Fn(f64) -> Circle<f64>,
) -> Circle<Batch<L, FUSED>> {
    let mut points = Circle { cos: Batch::all(0.0), sin: Batch::all(0.0) };
    for lane in 0..L {
        let Circle { cos, sin } = point(angle.0[lane]);
        (points.cos.0[lane], points.sin.0[lane]) = (cos, sin);
    }
    points
}
