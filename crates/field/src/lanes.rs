//! Many numbers side by side: one law evaluated for as many systems at once as a register is wide.

use crate::{Analytic, Base, Circle, Divisor, Over, Scalar};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

/// L numbers, each a field for itself: what one lane holds never depends on another. Equality is that of all lanes.
///
/// Plain loops that are always inlined, so that whoever is compiled for wide registers uses them here too. Where `FUSED`,
/// a product and a sum are rounded once, which is fast only where the processor can, and slow elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Lanes<const L: usize, const FUSED: bool = false>(pub [f64; L]);

impl<const L: usize, const FUSED: bool> Lanes<L, FUSED> {
    /// The same number in every lane.
    #[inline(always)]
    pub fn all(number: f64) -> Self {
        Lanes([number; L])
    }

    /// self + a b, rounded once where `fused`: for numbers that are kept and computed on by either kind of processor.
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
        impl<const L: usize, const FUSED: bool> $trait for Lanes<L, FUSED> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, b: Self) -> Self {
                self $sign b;
                self
            }
        }

        impl<const L: usize, const FUSED: bool> $assign for Lanes<L, FUSED> {
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

impl<const L: usize, const FUSED: bool> Neg for Lanes<L, FUSED> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for lane in 0..L {
            self.0[lane] = -self.0[lane];
        }
        self
    }
}

impl<const L: usize, const FUSED: bool> Zero for Lanes<L, FUSED> {
    #[inline(always)]
    fn zero() -> Self {
        Self::all(0.0)
    }

    fn is_zero(&self) -> bool {
        self.0.iter().all(|number| *number == 0.0)
    }
}

impl<const L: usize, const FUSED: bool> One for Lanes<L, FUSED> {
    #[inline(always)]
    fn one() -> Self {
        Self::all(1.0)
    }
}

impl<const L: usize, const FUSED: bool> Scalar for Lanes<L, FUSED> {
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

impl<const L: usize, const FUSED: bool> Base for Lanes<L, FUSED> {}

impl<const L: usize, const FUSED: bool> Over<Lanes<L, FUSED>> for Lanes<L, FUSED> {
    #[inline(always)]
    fn lift(parameter: Self) -> Self {
        parameter
    }

    #[inline(always)]
    fn divided_by(self, divisor: Divisor<Self>) -> Self {
        self * divisor.reciprocal()
    }
}

impl<const L: usize, const FUSED: bool> Over<f64> for Lanes<L, FUSED> {
    #[inline(always)]
    fn lift(parameter: f64) -> Self {
        Self::all(parameter)
    }

    #[inline(always)]
    fn divided_by(self, divisor: Divisor<f64>) -> Self {
        self * Self::all(divisor.reciprocal())
    }
}

impl<const L: usize, const FUSED: bool> Analytic for Lanes<L, FUSED> {
    #[inline(always)]
    fn circle(self) -> Circle<Self> {
        let mut point = near_quarters(self);
        let mut all_near = true;
        for angle in self.0 {
            all_near &= angle.abs() <= FARTHEST;
        }
        if !all_near {
            one_by_one(self, &mut point);
        }
        point
    }

    #[inline(always)]
    fn sqrt(mut self) -> Self {
        for lane in 0..L {
            self.0[lane] = self.0[lane].sqrt();
        }
        self
    }
}

/// Beyond it the quarter turns are no longer counted exactly.
const FARTHEST: f64 = 1e6;

/// 1.5 2^52: added to a number below 2^51 it leaves the nearest integer in the last bits.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// pi/2 in three parts: the first two have 33 bits, so that 2^20 times each is exact.
const QUARTER: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21];

/// (sin r - r)/r^3 and (cos r - 1 + r^2/2)/r^4 in powers of r^2, for |r| <= pi/4 (Sun's fdlibm, errors below 2^-57).
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_007e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Cosine and sine to about one unit of rounding, for angles that are not too far from zero, without a branch.
#[inline(always)]
fn near_quarters<const L: usize, const FUSED: bool>(angle: Lanes<L, FUSED>) -> Circle<Lanes<L, FUSED>> {
    let mut point = Circle { cos: angle, sin: angle };
    for lane in 0..L {
        let x = angle.0[lane];
        let sum = |c: f64, a: f64, b: f64| plus::<FUSED>(c, a, b);
        let counted = sum(ROUNDER, x, std::f64::consts::FRAC_2_PI);
        let quarters = counted - ROUNDER;
        let r = sum(sum(sum(x, quarters, -QUARTER[0]), quarters, -QUARTER[1]), quarters, -QUARTER[2]);
        let z = r * r;
        let series = |c: &[f64; 6]| c[..5].iter().rev().fold(c[5], |s, c| sum(*c, s, z));
        let sine = sum(r, r * z, series(&SINE));
        let half = 0.5 * z;
        let near = 1.0 - half;
        let cosine = near + sum((1.0 - near) - half, z * z, series(&COSINE));
        let turned = counted.to_bits();
        let (cos, sin) = if turned & 1 == 0 { (cosine, sine) } else { (sine, cosine) };
        point.cos.0[lane] = if (turned + 1) & 2 == 0 { cos } else { -cos };
        point.sin.0[lane] = if turned & 2 == 0 { sin } else { -sin };
    }
    point
}

/// The lanes whose angles are far away, or not finite.
#[cold]
#[inline(never)]
fn one_by_one<const L: usize, const FUSED: bool>(angle: Lanes<L, FUSED>, point: &mut Circle<Lanes<L, FUSED>>) {
    for lane in (0..L).filter(|lane| angle.0[*lane].abs() > FARTHEST || angle.0[*lane].is_nan()) {
        (point.sin.0[lane], point.cos.0[lane]) = angle.0[lane].sin_cos();
    }
}

/// c + a b.
#[inline(always)]
fn plus<const FUSED: bool>(c: f64, a: f64, b: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { c + a * b }
}
