//! A real root of a polynomial, with an isolating interval.

use super::{Enclosure, Number, Polynomial};
use dashu_int::IBig;
use dashu_ratio::RBig;
use field::Rational;
use std::cmp::Ordering;
use std::sync::Arc;

/// The number of bisections after which equality is tested.
const SUSPECT: usize = 256;

/// The only root, and a simple one, of a polynomial in the open interval (at, at + 1) / 2^scale; or at / 2^scale
/// itself.
#[derive(Clone, Debug)]
pub struct Root {
    polynomial: Arc<Polynomial>,
    at: IBig,
    scale: isize,
    exact: bool,
    /// The sign of the polynomial just above the lower end.
    below: i32,
}

impl Root {
    pub(super) fn point(polynomial: Arc<Polynomial>, at: IBig, scale: isize) -> Self {
        Root { polynomial, at, scale, exact: true, below: 0 }
    }

    /// The root in an interval, bisected until neither end is a root.
    pub(super) fn between(polynomial: Arc<Polynomial>, at: IBig, scale: isize) -> Self {
        // if the end is another root, the sign next to it is that of the derivative
        let mut below = sign_at(&polynomial, &at, scale);
        if below == 0 {
            below = sign_at(&polynomial.derivative(), &at, scale);
        }
        let mut root = Root { polynomial, at, scale, exact: false, below };
        while !root.exact
            && (sign_at(&root.polynomial, &root.at, root.scale) == 0
                || sign_at(&root.polynomial, &(&root.at + IBig::ONE), root.scale) == 0)
        {
            root.halve();
        }
        root
    }

    /// A rational number as a root; `None` where it is undefined.
    pub fn rational(value: Rational) -> Option<Self> {
        let big = value.to_big()?;
        let (numerator, denominator) = big.into_parts();
        let polynomial = Polynomial::from_integers([-numerator, IBig::from(denominator)]);
        polynomial.real_roots().pop()
    }

    /// The polynomial that has this root as a simple one.
    pub fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }

    /// The root times n, n not zero.
    pub(super) fn times(&self, n: &IBig) -> Self {
        // the coefficients of p(x/n) n^degree
        let degree = self.polynomial.degree().unwrap_or(0);
        let scaled = self.polynomial.map(|power, c| c * &Number::from(n.pow(degree - power)));
        let near = |other: &Root| {
            let value = |bits: usize| &self.enclosure(bits) * &Enclosure::integer(n.clone(), bits);
            let apart = |bits: usize| other.enclosure(bits).is_apart_from(&value(bits));
            [64, 256, 1024].into_iter().any(apart)
        };
        let roots = scaled.real_roots();
        roots.into_iter().find(|other| !near(other)).unwrap_or_else(|| self.clone())
    }

    /// The sign of another polynomial at this root: -1, 0 or 1.
    pub fn sign_of(&self, other: &Polynomial) -> i32 {
        match other.degree() {
            None => return 0,
            Some(0) => return other.lead().sign(),
            Some(_) => {}
        }
        let mut root = self.clone();
        let mut common = None;
        let mut bits = 64;
        loop {
            if root.exact {
                return sign_at(other, &root.at, root.scale);
            }
            root.refine(bits);
            if let Some(sign) = other.enclosure(&root.interval(bits), bits).sign() {
                return sign;
            }
            if bits >= SUSPECT {
                let common = common.get_or_insert_with(|| self.polynomial.gcd(other));
                if root.is_root_of_factor(common) {
                    return 0;
                }
            }
            bits *= 2;
        }
    }

    /// Whether this is a root of a divisor of its polynomial, which can have no other root in the interval.
    fn is_root_of_factor(&self, factor: &Polynomial) -> bool {
        if factor.degree().is_none_or(|degree| degree == 0) {
            return false;
        }
        if self.exact {
            return sign_at(factor, &self.at, self.scale) == 0;
        }
        sign_at(factor, &self.at, self.scale) * sign_at(factor, &(&self.at + IBig::ONE), self.scale) < 0
    }

    /// Compares two roots, exactly.
    pub fn compare(&self, other: &Self) -> Ordering {
        let mut bits = 32;
        loop {
            let (a, b) = (self.enclosure(bits), other.enclosure(bits));
            if let Some(sign) = (&a - &b).sign()
                && sign != 0
            {
                return sign.cmp(&0);
            }
            if bits >= SUSPECT && self.equals(other, bits) {
                return Ordering::Equal;
            }
            bits *= 2;
        }
    }

    /// Whether two roots that agree to this precision are equal.
    fn equals(&self, other: &Self, bits: usize) -> bool {
        if self.sign_of(&other.polynomial) != 0 {
            return false;
        }
        // the root is also a root of the other's polynomial: equal if it lies in the other's isolating interval
        let mut finer = self.clone();
        finer.refine(bits.max(usize::try_from(other.scale).unwrap_or(0)));
        let Ok(finesse) = usize::try_from(finer.scale - other.scale) else {
            return other.equals(self, bits);
        };
        let (low, high) = (&other.at << finesse, (&other.at + IBig::ONE) << finesse);
        match (finer.exact, other.exact) {
            (true, true) => finer.at == low,
            (true, false) => finer.at > low && finer.at < high,
            (false, true) => finer.at < low && low <= finer.at + IBig::ONE,
            (false, false) => finer.at >= low && finer.at < high,
        }
    }

    /// Narrows the interval to a width of at most 2^-bits.
    pub fn refine(&mut self, bits: usize) {
        while !self.exact && self.scale < bits as isize {
            if !self.leap(bits) {
                self.halve();
            }
        }
    }

    /// Narrows the interval by Newton's method to about twice the bits, if exact signs at the new ends prove that the
    /// root lies within. Returns whether it succeeded.
    fn leap(&mut self, most: usize) -> bool {
        let Ok(scale) = usize::try_from(self.scale) else { return false };
        let work = 2 * scale.max(16) + 64;
        let middle = (&self.at << 1) + IBig::ONE;
        let middle = Enclosure::new(middle.clone(), middle, scale + 1).finer(work);
        let value = self.polynomial.enclosure(&middle, work);
        let slope = self.polynomial.derivative().enclosure(&middle, work);
        let Some(step) = value.over(&slope) else { return false };
        let guess = &middle - &step;
        let bits = (2 * scale).max(scale + 4).min(most.max(scale + 1));
        for at in guess.cells(bits) {
            let low = sign_at(&self.polynomial, &at, bits as isize);
            let high = sign_at(&self.polynomial, &(&at + IBig::ONE), bits as isize);
            let shift = bits - scale;
            let inside = (&at >> shift) == self.at;
            if inside && low == self.below && high == -self.below {
                (self.at, self.scale) = (at, bits as isize);
                return true;
            }
        }
        false
    }

    fn halve(&mut self) {
        self.at <<= 1;
        self.scale += 1;
        let middle = &self.at + IBig::ONE;
        match sign_at(&self.polynomial, &middle, self.scale) {
            0 => (self.at, self.exact) = (middle, true),
            sign if sign == self.below => self.at = middle,
            _ => {}
        }
    }

    /// An enclosure of width 2^-bits, or 2^(1 - bits) where an end is rounded.
    pub fn enclosure(&self, bits: usize) -> Enclosure {
        let mut finer = self.clone();
        finer.refine(bits);
        finer.interval(bits)
    }

    /// The present isolating interval, rounded outwards to multiples of 2^-bits.
    pub fn interval(&self, bits: usize) -> Enclosure {
        let shift = bits as isize - self.scale;
        let end = if self.exact { self.at.clone() } else { &self.at + IBig::ONE };
        match usize::try_from(shift) {
            Ok(up) => Enclosure::new(&self.at << up, end << up, bits),
            Err(_) => {
                let down = shift.unsigned_abs();
                Enclosure::new(&self.at >> down, -(-end >> down), bits)
            }
        }
    }

    /// The ends of the isolating interval; equal for an exact root.
    pub fn bounds(&self) -> [Rational; 2] {
        let end = if self.exact { self.at.clone() } else { &self.at + IBig::ONE };
        [&self.at, &end].map(|n| {
            let value = match usize::try_from(self.scale) {
                Ok(scale) => RBig::from_parts_signed(n.clone(), IBig::ONE << scale),
                Err(_) => RBig::from(n << self.scale.unsigned_abs()),
            };
            Rational::from(value)
        })
    }

    /// The value, if it is rational and its polynomial is linear or the bisection has hit it.
    pub fn as_rational(&self) -> Option<Rational> {
        if self.exact {
            return self.bounds().first().copied();
        }
        match &self.polynomial.integers()?[..] {
            [constant, slope] => Some(Rational::from(RBig::from_parts_signed(-constant, slope.clone()))),
            _ => None,
        }
    }

    /// A float within one unit in the last place.
    pub fn to_f64(&self) -> f64 {
        let mut bits = 64;
        loop {
            let near = self.enclosure(bits);
            let value = near.to_f64();
            if near.radius() <= 1e-17 * value.abs() || self.exact || bits > 2048 {
                return if self.exact { self.bounds()[0].to_f64() } else { value };
            }
            bits *= 2;
        }
    }
}

/// The sign of a polynomial at n / 2^scale.
fn sign_at(p: &Polynomial, n: &IBig, scale: isize) -> i32 {
    let down = usize::try_from(scale).unwrap_or(0);
    let n = Number::from(if scale < 0 { n << scale.unsigned_abs() } else { n.clone() });
    let mut sum = Number::zero();
    for (steps, c) in p.coefficients().iter().rev().enumerate() {
        sum = &(&sum * &n) + &c.map(|part| part << (steps * down));
    }
    sum.sign()
}
