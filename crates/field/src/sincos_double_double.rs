//! Cosine and sine in double-double: reduction to the nearest multiple of pi/16, then the addition theorem. All
//! products are fused, so that results are bitwise equal on every processor.

use crate::{Circle, DoubleDouble};

/// A number and its rounding error, not necessarily normalised.
type Double = [f64; 2];

/// pi/16 as the sum of three numbers. Integer multiples up to 2^51 are subtracted with an absolute error below 2^-108.
const SIXTEENTH: [f64; 3] = [0.196_349_540_849_362_07, 7.654_042_494_670_958e-18, -1.871_731_131_073_962_3e-34];

/// cos(j pi/16).
const COSINES: [Double; 9] = [
    [1.0, 0.0],
    [0.980_785_280_403_230_4, 1.854_693_999_782_500_6e-17],
    [0.923_879_532_511_286_7, 1.764_504_708_433_667_7e-17],
    [0.831_469_612_302_545_2, 1.407_385_698_472_802_4e-18],
    [std::f64::consts::FRAC_1_SQRT_2, -4.833_646_656_726_457e-17],
    [0.555_570_233_019_602_2, 4.709_410_940_561_677e-17],
    [0.382_683_432_365_089_8, -1.005_077_269_646_158_8e-17],
    [0.195_090_322_016_128_28, -7.991_079_068_461_731e-18],
    [0.0, 0.0],
];

/// (sin r - r)/r^3 in powers of r^2: Taylor coefficients in double-double, then those for which `f64` suffices.
const SINE: ([Double; 4], [f64; 4]) = (
    [
        [-1.0 / 6.0, -9.251_858_538_542_97e-18],
        [1.0 / 120.0, 1.156_482_317_317_871_4e-19],
        [-1.0 / 5040.0, -1.720_955_829_342_070_5e-22],
        [1.0 / 362_880.0, -1.858_393_274_046_472e-22],
    ],
    [-2.505_210_838_544_172e-8, 1.605_904_383_682_161_3e-10, -7.647_163_731_819_816e-13, 2.811_457_254_345_520_6e-15],
);

/// (cos r - 1)/r^2 in powers of r^2, likewise.
const COSINE: ([Double; 5], [f64; 4]) = (
    [
        [-0.5, 0.0],
        [1.0 / 24.0, 2.312_964_634_635_742_7e-18],
        [-1.0 / 720.0, 5.300_543_954_373_577e-20],
        [1.0 / 40_320.0, 2.151_194_786_677_588_3e-23],
        [-1.0 / 3_628_800.0, -2.376_771_462_225_029_7e-23],
    ],
    [2.087_675_698_786_81e-9, -1.147_074_559_772_972_5e-11, 4.779_477_332_387_385e-14, -1.561_920_696_858_622_6e-16],
);

/// Cosine and sine of an angle below 2^47 in magnitude (rad), with an absolute error below 2^-104; for a sine near zero
/// also the relative error.
#[inline(always)]
pub(crate) fn point(angle: DoubleDouble) -> Circle<DoubleDouble> {
    let (r, sixteenths) = remainder([angle.hi(), angle.lo()]);
    let square = plus_product([0.0; 2], r, r);
    let sine = plus_product(r, r, plus_product([0.0; 2], square, series(&SINE, square)));
    let less = plus_product([0.0; 2], square, series(&COSINE, square));
    let step = (sixteenths & 7) as usize;
    let [c, s] = [COSINES[step], COSINES[8 - step]];
    let cosine = plus_product(plus_product(c, [-s[0], -s[1]], sine), c, less);
    let sine = plus_product(plus_product(s, c, sine), s, less);
    let (cos, sin) = if sixteenths & 8 == 0 { (cosine, sine) } else { (sine, cosine) };
    Circle { cos: whole(cos, sixteenths.wrapping_add(8) & 16 != 0), sin: whole(sin, sixteenths & 16 != 0) }
}

/// 1.5 2^52: added to a number below 2^51 it leaves the nearest integer in the last bits.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// The remainder of an angle modulo the nearest multiple of pi/16, and the integer multiple in the last bits.
#[inline(always)]
fn remainder([angle, rest]: Double) -> (Double, u64) {
    let counted = angle.mul_add(16.0 * std::f64::consts::FRAC_1_PI, ROUNDER);
    let count = counted - ROUNDER;
    let ([most, lost], [next, last]) = (product(count, SIXTEENTH[0]), product(count, SIXTEENTH[1]));
    // the first difference is exact: its terms are within a factor of two, or the multiple is zero
    let [r, first] = sum(angle - most, -lost);
    let [r, second] = sum(r, rest);
    let [r, third] = sum(r, -next);
    let rest = first + second + third - last - count * SIXTEENTH[2];
    (sum(r, rest), counted.to_bits())
}

/// The polynomial a_0 + a_1 x + ..., the later terms in `f64`.
#[inline(always)]
fn series<const N: usize>((fine, [a, b, c, d]): &([Double; N], [f64; 4]), x: Double) -> Double {
    let coarse = x[0].mul_add(x[0].mul_add(x[0].mul_add(*d, *c), *b), *a);
    fine.iter().rev().fold([coarse, 0.0], |later, &term| plus_product(term, x, later))
}

/// c + a b, for a c that is zero or no smaller than the product.
#[inline(always)]
fn plus_product(c: Double, a: Double, b: Double) -> Double {
    let [most, lost] = product(a[0], b[0]);
    let sum = c[0] + most;
    let rounded = most - (sum - c[0]);
    [sum, c[1] + (rounded + a[0].mul_add(b[1], a[1].mul_add(b[0], lost)))]
}

#[inline(always)]
fn product(a: f64, b: f64) -> Double {
    let most = a * b;
    [most, a.mul_add(b, -most)]
}

#[inline(always)]
fn sum(a: f64, b: f64) -> Double {
    let most = a + b;
    let of_b = most - a;
    [most, (a - (most - of_b)) + (b - of_b)]
}

#[inline(always)]
fn whole([most, rest]: Double, turned: bool) -> DoubleDouble {
    let sign = if turned { -1.0 } else { 1.0 };
    let [hi, lo] = sum(sign * most, sign * rest);
    DoubleDouble::new_full(hi, lo)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The unit of rounding of a number of 106 bits.
    const UNIT: f64 = 1.232_595_164_407_831e-32;

    /// Angles of both signs and all magnitudes and sixteenths, with low parts of all sizes.
    fn angles() -> impl Iterator<Item = DoubleDouble> {
        let bits = |i: u64| i.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 12;
        let unit = move |i: u64| bits(i) as f64 / (1_u64 << 52) as f64;
        (1..20_000_u64).map(move |i| {
            let size = 10.0_f64.powf(8.0 * unit(i) - 6.0);
            let angle = if i % 2 == 0 { size } else { -size };
            DoubleDouble::new_full(angle, angle * 1e-16 * (unit(i + 50_000) - 0.5))
        })
    }

    #[test]
    fn points_are_those_of_a_series_about_zero_by_other_steps() {
        let mut most: f64 = 0.0;
        for angle in angles() {
            let (sin, cos) = angle.sin_cos();
            let point = point(angle);
            let off = (point.cos - cos).hi().abs().max((point.sin - sin).hi().abs());
            most = most.max(off / angle.hi().abs().max(1.0) / UNIT);
        }
        assert!(most < 6.0, "{most} units");
    }

    #[test]
    fn points_lie_on_the_circle() {
        let off = |angle: DoubleDouble| point(angle).defect().hi().abs() / UNIT;
        let most = angles().chain(angles().map(|angle| angle * DoubleDouble::from(1e8))).map(off).fold(0.0, f64::max);
        assert!(most < 16.0, "{most} units");
    }

    #[test]
    fn turns_of_a_large_angle_are_counted_to_the_last() {
        let turn = DoubleDouble::new_full(std::f64::consts::TAU, 2.449_293_598_294_706_4e-16);
        for angle in angles().take(1_000) {
            // the product has an error of 2^-106 relative
            let near = point(angle + turn * DoubleDouble::from(1e12));
            let off = (near.cos - point(angle).cos).hi().abs().max((near.sin - point(angle).sin).hi().abs());
            assert!(off < 1e13 * 4.0 * UNIT, "{angle:?}: {off:e}");
        }
    }

    #[test]
    fn small_sines_have_all_their_digits() {
        let exact = |x: f64| {
            DoubleDouble::from(x) - DoubleDouble::from(x) * DoubleDouble::from(x).powi(2) / DoubleDouble::from(6.0)
        };
        for x in [1e-9, -3e-12, 1e-20, 1e-300] {
            let sine = point(DoubleDouble::from(x)).sin;
            assert!(((sine - exact(x)) / exact(x)).hi().abs() < 4.0 * UNIT, "{x}");
        }
    }

    #[test]
    fn the_sine_next_to_whole_turns_is_what_they_leave_out() {
        // 2 pi is the sum of these two, up to 1e-48
        let (turn, left_out) =
            (DoubleDouble::new_full(std::f64::consts::TAU, 2.449_293_598_294_706_4e-16), -5.989_539_619_436_679e-33);
        for doubled in 0..40 {
            let times = 2.0_f64.powi(doubled);
            let point = point(turn * DoubleDouble::from(times));
            let (exact, found) = (-left_out * times, point.sin.hi());
            assert!((found - exact).abs() < 1e-15 * exact, "{times} turns: {found:e}");
            assert!((point.cos - DoubleDouble::from(1.0)).hi().abs() < exact * exact, "{times} turns");
        }
    }
}
