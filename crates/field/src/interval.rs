//! Interval arithmetic in `f64`, rounded outwards: a result contains the values for all numbers in the operands.
//!
//! The value of an expression over intervals encloses its range: it can prove that the expression does not vanish, or
//! bound a derivative. Enclosures with higher precision are [`algebra`'s enclosures].
//!
//! [`algebra`'s enclosures]: https://docs.rs/dalembert-algebra

use crate::{Analytic, Base, Circle, Elementary, Over, Scalar};
use num_traits::{One, Zero};
use std::f64::consts::PI;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

/// A closed interval. Two intervals are equal if both ends are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    /// The whole real line: the result where nothing is known, such as a quotient by an interval that contains zero.
    pub const EVERYTHING: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// The interval between two numbers, in any order; the whole line where one is NaN.
    pub fn new(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() { Self::EVERYTHING } else { Interval { low: a.min(b), high: a.max(b) } }
    }

    /// The interval of one number.
    pub fn point(value: f64) -> Self {
        Interval::new(value, value)
    }

    pub fn low(self) -> f64 {
        self.low
    }

    pub fn high(self) -> f64 {
        self.high
    }

    /// A number near the midpoint.
    pub fn middle(self) -> f64 {
        let middle = 0.5 * self.low + 0.5 * self.high;
        if middle.is_finite() { middle } else { 0.0 }
    }

    /// An upper bound of the width.
    pub fn width(self) -> f64 {
        if self.low == self.high { 0.0 } else { (self.high - self.low).next_up() }
    }

    /// The largest absolute value.
    pub fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    pub fn contains(self, value: f64) -> bool {
        self.low <= value && value <= self.high
    }

    /// Whether the interval lies in the interior of another.
    pub fn is_inside(self, other: Interval) -> bool {
        other.low < self.low && self.high < other.high
    }

    /// Whether the interval is a subset of another.
    pub fn is_part_of(self, other: Interval) -> bool {
        other.low <= self.low && self.high <= other.high
    }

    /// The intersection; `None` where it is empty.
    pub fn and(self, other: Interval) -> Option<Interval> {
        let [low, high] = [self.low.max(other.low), self.high.min(other.high)];
        (low <= high).then_some(Interval { low, high })
    }

    /// The smallest interval that contains both.
    pub fn hull(self, other: Interval) -> Interval {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// All x with x b in this interval for some b in `by`, as one or two intervals; both `None` without such x.
    pub fn factors(self, by: Interval) -> [Option<Interval>; 2] {
        if !by.contains(0.0) {
            return [Some(self / by), None];
        }
        if self.contains(0.0) {
            return [Some(Self::EVERYTHING), None];
        }
        let nearest = Interval::point(if self.low > 0.0 { self.low } else { self.high });
        [by.low, by.high].map(|end| {
            let farthest = (end != 0.0).then(|| nearest / Interval::point(end))?;
            Some(match (self.low > 0.0) == (end > 0.0) {
                true => Interval { low: farthest.low.max(0.0), high: f64::INFINITY },
                false => Interval { low: f64::NEG_INFINITY, high: farthest.high.min(0.0) },
            })
        })
    }

    /// The sign of all numbers, 1, -1 or 0; `None` where they differ in sign.
    pub fn sign(self) -> Option<i32> {
        match self {
            Interval { low: 0.0, high: 0.0 } => Some(0),
            Interval { low, .. } if low > 0.0 => Some(1),
            Interval { high, .. } if high < 0.0 => Some(-1),
            _ => None,
        }
    }

    /// The interval with its ends moved outwards by `steps` floats.
    fn widened(self, steps: usize) -> Self {
        (0..steps).fold(self, |it, _| Interval { low: it.low.next_down(), high: it.high.next_up() })
    }

    /// The range of an increasing function whose computed values are wrong by less than two units in the last place.
    fn through(self, rising: impl Fn(f64) -> f64) -> Self {
        let range = Interval::new(rising(self.low), rising(self.high));
        if range == Self::EVERYTHING { range } else { range.widened(3) }
    }

    /// The range of the cosine.
    fn cosine(self) -> Self {
        // for large arguments the spacing of floats is not small compared with a turn
        if !(self.size() < FARTHEST && self.width() < 2.0 * PI) {
            return Interval { low: -1.0, high: 1.0 };
        }
        let ends = [self.low, self.high].map(|end| Interval::point(end.circle().cos).widened(3));
        let hull = ends[0].hull(ends[1]);
        let mut range = Interval { low: hull.low.max(-1.0), high: hull.high.min(1.0) };
        // multiples of pi inside, or within the rounding error
        let slack = 1e-15 * (1.0 + self.size());
        let (first, last) = (((self.low - slack) / PI).floor() as i64, ((self.high + slack) / PI).ceil() as i64);
        for turn in first..=last {
            let at = turn as f64 * PI;
            if at >= self.low - slack && at <= self.high + slack {
                if turn % 2 == 0 { range.high = 1.0 } else { range.low = -1.0 }
            }
        }
        range
    }
}

/// Larger arguments give the range [-1, 1].
const FARTHEST: f64 = 1e6;

/// The sum rounded down; zero is exact.
fn down(sum: f64) -> f64 {
    if sum == 0.0 { 0.0 } else { sum.next_down() }
}

fn up(sum: f64) -> f64 {
    if sum == 0.0 { 0.0 } else { sum.next_up() }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        Interval { low: down(self.low + b.low), high: up(self.high + b.high) }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        Interval { low: down(self.low - b.high), high: up(self.high - b.low) }
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Interval { low: -self.high, high: -self.low }
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let one = Interval::point(1.0);
        if self == one {
            return b;
        }
        if b == one {
            return self;
        }
        let all = [(self.low, b.low), (self.low, b.high), (self.high, b.low), (self.high, b.high)].map(product);
        let low = all.iter().fold(f64::INFINITY, |least, each| least.min(*each));
        let high = all.iter().fold(f64::NEG_INFINITY, |most, each| most.max(*each));
        Interval { low: down(low), high: up(high) }
    }
}

/// The product of two ends, with 0 times infinity as zero: infinite ends represent large numbers.
fn product((a, b): (f64, f64)) -> f64 {
    match a * b {
        _ if a == 0.0 || b == 0.0 => 0.0,
        0.0 if (a < 0.0) == (b < 0.0) => f64::from_bits(1),
        0.0 => -f64::from_bits(1),
        other => other,
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        if b.contains(0.0) {
            return Self::EVERYTHING;
        }
        if b == Interval::point(1.0) {
            return self;
        }
        let all = [self.low / b.low, self.low / b.high, self.high / b.low, self.high / b.high];
        if all.iter().any(|each| each.is_nan()) {
            return Self::EVERYTHING;
        }
        let low = all.iter().fold(f64::INFINITY, |least, each| least.min(*each));
        let high = all.iter().fold(f64::NEG_INFINITY, |most, each| most.max(*each));
        if self.low == 0.0 && self.high == 0.0 { self } else { Interval { low: low.next_down(), high: high.next_up() } }
    }
}

/// Required by the trait; expressions do not use it.
impl Rem for Interval {
    type Output = Self;
    fn rem(self, _: Self) -> Self {
        Self::EVERYTHING
    }
}

macro_rules! assigned {
    ($($trait:ident $method:ident $sign:tt),*) => {$(
        impl $trait for Interval {
            fn $method(&mut self, b: Self) {
                *self = *self $sign b;
            }
        }
    )*};
}
assigned!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /, RemAssign rem_assign %);

impl Zero for Interval {
    fn zero() -> Self {
        Interval { low: 0.0, high: 0.0 }
    }

    /// Whether the interval is the point zero.
    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl One for Interval {
    fn one() -> Self {
        Interval { low: 1.0, high: 1.0 }
    }
}

impl Scalar for Interval {
    fn ratio(numerator: i64, denominator: i64) -> Self {
        let whole = |n: i64| {
            let near = n as f64;
            let is_exact = near.abs() < 9_007_199_254_740_992.0;
            if is_exact { Interval::point(near) } else { Interval::point(near).widened(1) }
        };
        let quotient = whole(numerator) / whole(denominator);
        // a quotient that is exactly a float is a point
        let [n, d] = [numerator as f64, denominator as f64];
        let is_exact =
            whole(numerator).width() == 0.0 && whole(denominator).width() == 0.0 && (n / d).mul_add(d, -n) == 0.0;
        if is_exact && (n / d).is_normal() { Interval::point(n / d) } else { quotient }
    }

    fn squared(self) -> Self {
        let square = self * self;
        Interval { low: if self.contains(0.0) { 0.0 } else { square.low.max(0.0) }, high: square.high }
    }
}

impl Base for Interval {}

impl Over<Interval> for Interval {
    fn lift(parameter: Interval) -> Self {
        parameter
    }
}

impl Over<f64> for Interval {
    fn lift(parameter: f64) -> Self {
        Interval::point(parameter)
    }
}

impl Analytic for Interval {
    fn circle(self) -> Circle<Self> {
        // sin x = cos(x - pi/2)
        let quarter = Interval { low: FRAC_PI_2_BELOW, high: FRAC_PI_2_BELOW.next_up() };
        Circle { cos: self.cosine(), sin: (self - quarter).cosine() }
    }

    /// The whole line where part of the argument is negative: the function is undefined there.
    fn sqrt(self) -> Self {
        if self.low < 0.0 {
            return Self::EVERYTHING;
        }
        let [low, high] = [self.low, self.high].map(f64::sqrt);
        Interval { low: low.next_down().max(0.0), high: high.next_up() }
    }

    fn elementary(self, function: Elementary, other: Self) -> Self {
        let of = |a: f64| function.of(a, a);
        match function {
            Elementary::Exp => {
                let range = self.through(of);
                Interval { low: range.low.max(0.0), high: range.high }
            }
            Elementary::Ln if self.low <= 0.0 => Self::EVERYTHING,
            Elementary::Ln => self.through(of),
            Elementary::Tanh => {
                let range = self.through(of);
                Interval { low: range.low.max(-1.0), high: range.high.min(1.0) }
            }
            // the branch cut is the half line where the second argument is negative and the first is zero
            Elementary::Atan2 if self.contains(0.0) && other.low <= 0.0 => {
                Interval::point(PI).hull(Interval::point(-PI)).widened(1)
            }
            Elementary::Atan2 => {
                // without the pole inside, the extremes are at the corners
                let corners =
                    [(self.low, other.low), (self.low, other.high), (self.high, other.low), (self.high, other.high)];
                let all = corners.map(|(a, b)| Interval::point(function.of(a, b)).widened(3));
                all.into_iter().fold(all[0], Interval::hull)
            }
        }
    }
}

/// pi/2 rounded down; the next float is above it.
const FRAC_PI_2_BELOW: f64 = std::f64::consts::FRAC_PI_2;

#[cfg(test)]
mod tests {
    use super::*;

    /// Pseudo-random numbers, equal in every run.
    fn numbers() -> impl Iterator<Item = f64> {
        (1..400).map(|k| 8.0 * (f64::from(k) * 12.9898).sin() * (f64::from(k) * 0.37).cos())
    }

    #[test]
    fn every_operation_holds_what_it_gives_at_points_inside() {
        let all: Vec<f64> = numbers().collect();
        for k in 0..all.len() - 4 {
            let [a, b] = [Interval::new(all[k], all[k + 1]), Interval::new(all[k + 2], all[k + 3])];
            for part in 0..=8 {
                let at = |of: Interval, part: f64| (of.low + part * (of.high - of.low)).clamp(of.low, of.high);
                let (x, y) = (at(a, f64::from(part) / 8.0), at(b, f64::from((part * 3) % 9) / 8.0));
                assert!((a + b).contains(x + y) && (a - b).contains(x - y) && (a * b).contains(x * y));
                assert!((a / b).contains(x / y) && a.squared().contains(x * x));
                assert!(a.circle().cos.contains(x.circle().cos), "{a:?} {x}");
                assert!(a.circle().sin.contains(x.circle().sin), "{a:?} {x}");
                for function in Elementary::ALL {
                    let value = function.of(x, y);
                    assert!(
                        value.is_nan() || a.elementary(function, b).contains(value),
                        "{function:?} {a:?} {b:?} {x} {y}"
                    );
                }
                assert!(x < 0.0 || a.sqrt().contains(x.sqrt()));
            }
        }
    }

    #[test]
    fn ranges_are_not_much_wider_than_they_have_to_be() {
        let quarter = Interval::new(0.0, 1.0).circle();
        assert!(
            quarter.cos.low > 0.540 && quarter.cos.high == 1.0 && quarter.sin.high < 0.842 && quarter.sin.low > -1e-14
        );
        let narrow = Interval::point(0.3).circle();
        assert!(narrow.cos.width() < 1e-14 && narrow.sin.width() < 1e-14);
        assert_eq!(Interval::ratio(1, 4), Interval::point(0.25));
        assert!(Interval::ratio(1, 3).width() < 1e-15 && Interval::ratio(1, 3).width() > 0.0);
        assert_eq!(Interval::new(-1.0, 2.0) / Interval::new(-1.0, 1.0), Interval::EVERYTHING);
        assert_eq!(Interval::new(-2.0, 1.0).squared().low, 0.0);
    }

    #[test]
    fn signs_are_those_of_all_numbers_inside() {
        assert_eq!(
            [Interval::new(1.0, 2.0), Interval::new(-2.0, -1.0), Interval::zero()].map(Interval::sign),
            [Some(1), Some(-1), Some(0)]
        );
        assert_eq!(Interval::new(-1.0, 1.0).sign(), None);
        assert!(
            Interval::point(1.0).is_inside(Interval::new(0.0, 2.0))
                && !Interval::new(0.0, 1.0).is_inside(Interval::new(0.0, 2.0))
        );
    }
}
