//! Intervals with ends that are multiples of a power of two.

use dashu_int::IBig;
use dashu_int::ops::{BitTest, SquareRoot, UnsignedAbs};
use field::Rational;
use std::borrow::Cow;
use std::ops::{Add, Mul, Neg, Sub};

/// The interval [low, high] / 2^bits. Operations round outwards: the result contains all values for all operands. The
/// result of operands with different `bits` has the smaller number of bits.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosure {
    low: IBig,
    high: IBig,
    bits: usize,
}

impl Enclosure {
    /// The interval with the given ends, as multiples of 2^-bits.
    pub(super) fn new(low: IBig, high: IBig, bits: usize) -> Self {
        Enclosure { low, high, bits }
    }

    /// The enclosure of an integer.
    pub fn integer(n: impl Into<IBig>, bits: usize) -> Self {
        let at = n.into() << bits;
        Enclosure { low: at.clone(), high: at, bits }
    }

    /// The enclosure of a fraction; `None` where it is undefined.
    pub fn rational(value: Rational, bits: usize) -> Option<Self> {
        let big = value.to_big()?;
        let denominator = Self::integer(IBig::from(big.denominator().clone()), bits);
        Self::integer(big.numerator().clone(), bits).over(&denominator)
    }

    /// The enclosure of the exact value of a float; `None` for infinities and NaN.
    pub fn float(value: f64, bits: usize) -> Option<Self> {
        Self::rational(Rational::exactly(value), bits)
    }

    /// The precision: ends are multiples of 2^-bits.
    pub fn bits(&self) -> usize {
        self.bits
    }

    /// The sign: -1 or 1 where every value has it, 0 for the point zero, `None` where it is undetermined.
    pub fn sign(&self) -> Option<i32> {
        if self.low > IBig::ZERO {
            Some(1)
        } else if self.high < IBig::ZERO {
            Some(-1)
        } else {
            (self.low == IBig::ZERO && self.high == IBig::ZERO).then_some(0)
        }
    }

    /// The quotient; `None` where the divisor may be zero.
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        let (a, b) = self.level(divisor);
        b.sign().filter(|sign| *sign != 0)?;
        let floor = |n: &IBig, d: &IBig| {
            let (n, d) = if *d < IBig::ZERO { (-(n << a.bits), -d) } else { (n << a.bits, d.clone()) };
            let quotient = &n / &d;
            if &quotient * &d > n { quotient - IBig::ONE } else { quotient }
        };
        let ends = [(&a.low, &b.low), (&a.low, &b.high), (&a.high, &b.low), (&a.high, &b.high)];
        let low = ends.iter().map(|(n, d)| floor(n, d)).min()?;
        let high = ends.iter().map(|(n, d)| floor(n, d)).max()? + IBig::ONE;
        Some(Enclosure { low, high, bits: a.bits })
    }

    /// The square root; `None` where the value may be negative.
    pub fn sqrt(&self) -> Option<Self> {
        if self.low < IBig::ZERO {
            return None;
        }
        let root = |n: &IBig| IBig::from((n.unsigned_abs() << self.bits).sqrt());
        Some(Enclosure { low: root(&self.low), high: root(&self.high) + IBig::ONE, bits: self.bits })
    }

    /// The smallest enclosure that contains both.
    pub fn hull(&self, other: &Self) -> Self {
        let (a, b) = self.level(other);
        Enclosure { low: a.low.clone().min(b.low.clone()), high: a.high.clone().max(b.high.clone()), bits: a.bits }
    }

    /// The midpoint, rounded to a multiple of 2^-bits.
    pub fn middle(&self) -> Self {
        let middle = (&self.low + &self.high) >> 1;
        Enclosure { low: middle.clone(), high: middle, bits: self.bits }
    }

    /// The upper end.
    pub fn upper(&self) -> Self {
        Enclosure { low: self.high.clone(), ..self.clone() }
    }

    /// Whether the interval lies in the interior of another.
    pub fn is_inside(&self, other: &Self) -> bool {
        let (a, b) = self.level(other);
        b.low < a.low && a.high < b.high
    }

    /// Whether two intervals are disjoint.
    pub fn is_apart_from(&self, other: &Self) -> bool {
        let (a, b) = self.level(other);
        a.high < b.low || b.high < a.low
    }

    /// Whether the width is at most 2^-bits.
    pub fn is_within(&self, bits: usize) -> bool {
        (&self.high - &self.low) << bits <= IBig::ONE << self.bits
    }

    /// Exponents of two that bound the magnitude of all values; `None` where zero may be among them.
    pub(super) fn magnitude(&self) -> Option<(isize, isize)> {
        self.sign().filter(|sign| *sign != 0)?;
        let (a, b) = (self.low.bit_len(), self.high.bit_len());
        let bits = self.bits as isize;
        Some((a.min(b) as isize - 1 - bits, a.max(b) as isize - bits))
    }

    /// The midpoint, rounded to the nearest float.
    pub fn to_f64(&self) -> f64 {
        let sum = &self.low + &self.high;
        dashu_ratio::RBig::from_parts_signed(sum, IBig::ONE << (self.bits + 1)).to_f64().value()
    }

    /// Both ends as floats, rounded outwards.
    pub fn ends(&self) -> [f64; 2] {
        let float = |n: &IBig| dashu_ratio::RBig::from_parts_signed(n.clone(), IBig::ONE << self.bits).to_f64().value();
        let outwards = |n: &IBig, step: fn(f64) -> f64| if *n == IBig::ZERO { 0.0 } else { step(float(n)) };
        [outwards(&self.low, f64::next_down), outwards(&self.high, f64::next_up)]
    }

    /// The fraction with the smallest denominator in the interval.
    pub fn simplest(&self) -> field::Rational {
        let end = |n: &IBig| dashu_ratio::RBig::from_parts_signed(n.clone(), IBig::ONE << self.bits);
        if self.low == self.high {
            return end(&self.low).into();
        }
        // the search is in an open interval, slightly larger than this closed one
        let (low, high) = (end(&(&self.low - IBig::ONE)), end(&(&self.high + IBig::ONE)));
        dashu_ratio::RBig::simplest_in(low, high).into()
    }

    /// Half of the width, as a float rounded up.
    pub fn radius(&self) -> f64 {
        let width = dashu_ratio::RBig::from_parts_signed(&self.high - &self.low, IBig::ONE << (self.bits + 1));
        width.to_f64().value().next_up()
    }

    /// The interval with a higher precision.
    pub fn finer(self, bits: usize) -> Self {
        let more = bits.saturating_sub(self.bits);
        Enclosure { low: self.low << more, high: self.high << more, bits: self.bits + more }
    }

    /// The two cells of width 2^-bits most likely to contain the midpoint: the one with it, and the nearer neighbour.
    pub(super) fn cells(&self, bits: usize) -> [IBig; 2] {
        let doubled = &self.low + &self.high;
        let halves = match (self.bits).checked_sub(bits) {
            Some(down) => doubled >> down,
            None => doubled << (bits - self.bits),
        };
        // half of the doubled midpoint: the lowest bit gives the side
        let cell = &halves >> 1;
        let upper = &halves - (&cell << 1) == IBig::ONE;
        let beside = if upper { &cell + IBig::ONE } else { &cell - IBig::ONE };
        [cell, beside]
    }

    /// Both enclosures with the lower precision; only the finer one is copied.
    fn level<'a>(&'a self, other: &'a Self) -> (Cow<'a, Self>, Cow<'a, Self>) {
        let bits = self.bits.min(other.bits);
        (self.coarser(bits), other.coarser(bits))
    }

    fn coarser(&self, bits: usize) -> Cow<'_, Self> {
        match self.bits - bits {
            0 => Cow::Borrowed(self),
            off => Cow::Owned(Enclosure { low: &self.low >> off, high: -(-&self.high >> off), bits }),
        }
    }

    fn is_zero(&self) -> bool {
        self.low.is_zero() && self.high.is_zero()
    }
}

impl Add for &Enclosure {
    type Output = Enclosure;
    fn add(self, b: &Enclosure) -> Enclosure {
        let (a, b) = self.level(b);
        Enclosure { low: &a.low + &b.low, high: &a.high + &b.high, bits: a.bits }
    }
}

impl Neg for &Enclosure {
    type Output = Enclosure;
    fn neg(self) -> Enclosure {
        Enclosure { low: -&self.high, high: -&self.low, bits: self.bits }
    }
}

impl Sub for &Enclosure {
    type Output = Enclosure;
    fn sub(self, b: &Enclosure) -> Enclosure {
        self + &-b
    }
}

impl Mul for &Enclosure {
    type Output = Enclosure;
    fn mul(self, b: &Enclosure) -> Enclosure {
        let (a, b) = self.level(b);
        let bits = a.bits;
        if a.is_zero() || b.is_zero() {
            return Enclosure { low: IBig::ZERO, high: IBig::ZERO, bits };
        }
        // signs determine which ends give the extreme products, unless both intervals contain zero
        let side = |x: &Enclosure| i32::from(x.low >= IBig::ZERO) - i32::from(x.high <= IBig::ZERO);
        let (low, high) = match (side(&a), side(&b)) {
            (1, 1) => (&a.low * &b.low, &a.high * &b.high),
            (1, -1) => (&a.high * &b.low, &a.low * &b.high),
            (1, _) => (&a.high * &b.low, &a.high * &b.high),
            (-1, 1) => (&a.low * &b.high, &a.high * &b.low),
            (-1, -1) => (&a.high * &b.high, &a.low * &b.low),
            (-1, _) => (&a.low * &b.high, &a.low * &b.low),
            (_, 1) => (&a.low * &b.high, &a.high * &b.high),
            (_, -1) => (&a.high * &b.low, &a.low * &b.low),
            _ => ((&a.low * &b.high).min(&a.high * &b.low), (&a.low * &b.low).max(&a.high * &b.high)),
        };
        Enclosure { low: low >> bits, high: -(-high >> bits), bits }
    }
}
