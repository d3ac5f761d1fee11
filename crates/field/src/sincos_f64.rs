//! Cosine and sine for moderate angles, inlined into the law, for single numbers and batches. Independent of the
//! version of any library.

use crate::Circle;

/// Whether the angle is small enough for an exact count of quarter turns.
#[inline(always)]
pub(crate) fn is_near(angle: f64) -> bool {
    angle.abs() <= 1e6
}

/// 1.5 2^52: added to a number below 2^51 it leaves the nearest integer in the last bits.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// pi/2 in three parts: the first two have 33 bits, so that products with integers up to 2^20 are exact (Sun's fdlibm).
const QUARTER: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

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

/// Cosine and sine of an angle with [`is_near`], with an error below 0.8 units in the last place.
#[inline(always)]
pub(crate) fn near<const FUSED: bool>(angle: f64) -> Circle<f64> {
    let sum = plus::<FUSED>;
    let counted = sum(ROUNDER, angle, std::f64::consts::FRAC_2_PI);
    let quarters = counted - ROUNDER;
    // the remainder of the angle is r + tail
    let first = sum(angle, quarters, -QUARTER[0]);
    let second = sum(first, quarters, -QUARTER[1]);
    let r = sum(second, quarters, -QUARTER[2]);
    let tail = sum(second - r, quarters, -QUARTER[2]) + sum(first - second, quarters, -QUARTER[1]);
    let z = r * r;
    let z2 = z * z;
    // in pairs, to reduce latency
    let series = |c: &[f64; 6]| sum(sum(c[0], c[1], z), sum(sum(c[2], c[3], z), sum(c[4], c[5], z), z2), z2);
    let half = 0.5 * z;
    let most = 1.0 - half;
    let sine = r + sum(tail * most, r * z, series(&SINE));
    let cosine = most + sum(sum((1.0 - most) - half, -r, tail), z2, series(&COSINE));
    let turned = counted.to_bits();
    let (cos, sin) = if turned & 1 == 0 { (cosine, sine) } else { (sine, cosine) };
    Circle {
        cos: if turned.wrapping_add(1) & 2 == 0 { cos } else { -cos },
        sin: if turned & 2 == 0 { sin } else { -sin },
    }
}

/// c + a b.
#[inline(always)]
pub(crate) fn plus<const FUSED: bool>(c: f64, a: f64, b: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { c + a * b }
}

/// Cosine and sine of a large angle, or one that is not finite.
#[cold]
#[inline(never)]
pub(crate) fn far(angle: f64) -> Circle<f64> {
    let (sin, cos) = angle.sin_cos();
    Circle { cos, sin }
}
