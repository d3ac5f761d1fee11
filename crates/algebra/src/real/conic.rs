//! Polynomial functions P(x) + y Q(x) on the conic y^2 = c0 - c1 x^2, and their zeros.

use super::{Number, Ordered, Polynomial, Root};
use dashu_int::ops::{Gcd, UnsignedAbs};
use dashu_int::{IBig, UBig};
use field::Rational;
use std::sync::Arc;

/// The function (P + y Q) / below with integer coefficients. The sign is available for constants only.
#[derive(Clone, Debug)]
pub struct Conic {
    plain: Polynomial,
    odd: Polynomial,
    below: Number,
    /// The numbers of y^2 = (first - second x^2) / third, with a positive third.
    square: Arc<[Number; 3]>,
}

/// A point of the conic: x, and the sign of y.
#[derive(Clone, Debug)]
pub struct ConicPoint {
    pub x: Root,
    pub side: i32,
}

impl Conic {
    /// The functions x and y on y^2 = c0 - c1 x^2. `None` where a number is undefined.
    pub fn coordinates(c0: Rational, c1: Rational) -> Option<[Self; 2]> {
        let (whole, third) = Number::over_common(&[c0, c1])?;
        let [first, second]: [Number; 2] = whole.try_into().ok()?;
        let square = Arc::new([first, second, third]);
        let (zero, one) = (Polynomial::default(), Number::from(1));
        let x = Polynomial::from_integers([0, 1]);
        let function = |plain, odd| Conic { plain, odd, below: one.clone(), square: Arc::clone(&square) };
        Some([function(x, zero.clone()), function(zero, Polynomial::from_integers([1]))])
    }

    /// Whether the function is zero on the whole conic.
    pub fn is_zero(&self) -> bool {
        self.plain.is_zero() && self.odd.is_zero()
    }

    /// All real zeros of the function; empty for the zero function.
    pub fn zeros(&self) -> Vec<ConicPoint> {
        // (P + y Q)(P - y Q) times a positive number
        let square = self.squared();
        let [_, _, third] = &*self.square;
        let norm = match (self.plain.is_zero(), self.odd.is_zero()) {
            (true, true) => return Vec::new(),
            (false, true) => self.plain.clone(),
            (true, false) => &self.odd * &square,
            (false, false) => {
                let plain = &(&self.plain * &self.plain) * &Polynomial::constant(third.clone());
                &plain - &(&(&self.odd * &self.odd) * &square)
            }
        };
        let mut zeros = Vec::new();
        for x in norm.real_roots() {
            let sides = match (x.sign_of(&square), x.sign_of(&self.plain), x.sign_of(&self.odd)) {
                (-1, ..) => vec![],
                (0, ..) => vec![0],
                (_, _, 0) => vec![1, -1],
                (_, plain, odd) => vec![-plain * odd],
            };
            zeros.extend(sides.into_iter().map(|side| ConicPoint { x: x.clone(), side }));
        }
        zeros
    }

    /// The polynomial in x that equals y^2 times the third number of the conic.
    fn squared(&self) -> Polynomial {
        let [first, second, _] = &*self.square;
        Polynomial::new(vec![first.clone(), Number::zero(), -second])
    }

    fn with(&self, plain: Polynomial, odd: Polynomial, below: Number) -> Self {
        let all = plain.coefficients().iter().chain(odd.coefficients()).chain([&below]);
        let common = all.flat_map(Number::parts).fold(UBig::ZERO, |common, part| match part.unsigned_abs() {
            part if part == UBig::ZERO => common,
            part if common == UBig::ZERO => part,
            part => common.gcd(part),
        });
        if common <= UBig::ONE {
            return Conic { plain, odd, below, square: Arc::clone(&self.square) };
        }
        let common = IBig::from(common);
        let less = |p: &Polynomial| p.map(|_, c| c.map(|part| part / &common));
        let (plain, odd, below) = (less(&plain), less(&odd), below.map(|part| part / &common));
        Conic { plain, odd, below, square: Arc::clone(&self.square) }
    }

    /// Combines two functions over their common denominator.
    fn joined(&self, b: &Self, join: impl Fn(&Polynomial, &Polynomial) -> Polynomial) -> Self {
        let (up, down) = (Polynomial::constant(b.below.clone()), Polynomial::constant(self.below.clone()));
        let both = |p: &Polynomial, q: &Polynomial| join(&(p * &up), &(q * &down));
        self.with(both(&self.plain, &b.plain), both(&self.odd, &b.odd), &self.below * &b.below)
    }

    fn constant(&self) -> Option<&[Number]> {
        (self.odd.is_zero() && self.plain.degree().is_none_or(|degree| degree == 0)).then(|| self.plain.coefficients())
    }
}

impl Ordered for Conic {
    fn fraction(&self, value: Rational) -> Option<Self> {
        let (whole, below) = Number::over_common(&[value])?;
        Some(self.with(Polynomial::new(whole), Polynomial::default(), below))
    }

    fn integer(&self, n: i64) -> Self {
        self.with(Polynomial::from_integers([n]), Polynomial::default(), Number::from(1))
    }

    fn plus(&self, b: &Self) -> Self {
        self.joined(b, |p, q| p + q)
    }

    fn minus(&self, b: &Self) -> Self {
        self.joined(b, |p, q| p - q)
    }

    fn times(&self, b: &Self) -> Self {
        let third = Polynomial::constant(self.square[2].clone());
        let plain = &(&(&self.plain * &b.plain) * &third) + &(&(&self.odd * &b.odd) * &self.squared());
        let odd = &(&(&self.plain * &b.odd) + &(&self.odd * &b.plain)) * &third;
        self.with(plain, odd, &(&self.below * &b.below) * &self.square[2])
    }

    /// The quotient by a constant; `None` for other divisors.
    fn over(&self, b: &Self) -> Option<Self> {
        let divisor = b.constant()?.first()?;
        let (up, down) = match divisor.sign() {
            0 => return None,
            1 => (b.below.clone(), divisor.clone()),
            _ => (-&b.below, -divisor),
        };
        let up = Polynomial::constant(up);
        Some(self.with(&self.plain * &up, &self.odd * &up, &self.below * &down))
    }

    fn root(&self) -> Option<Self> {
        None
    }

    fn sign(&self) -> Option<i32> {
        self.constant().map(|constant| constant.first().map_or(0, Number::sign))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_vanish_where_they_meet_the_circle() {
        let one = Rational::new(1, 1);
        let [x, y] = Conic::coordinates(one, one).unwrap();
        let places = |f: &Conic| -> Vec<(f64, i32)> { f.zeros().iter().map(|at| (at.x.to_f64(), at.side)).collect() };
        // x = 2 y at two opposite points, x = 1/2 at two, y = 0 at two
        assert_eq!(places(&x.minus(&y.plus(&y))), [(-2.0 / 5f64.sqrt(), -1), (2.0 / 5f64.sqrt(), 1)]);
        let half = x.fraction(Rational::new(1, 2)).unwrap();
        assert_eq!(places(&x.minus(&half)), [(0.5, 1), (0.5, -1)]);
        assert_eq!(places(&y), [(-1.0, 0), (1.0, 0)]);
        // x^2 + y^2 - 1 is zero everywhere, x - 2 nowhere
        let circle = x.times(&x).plus(&y.times(&y)).minus(&x.integer(1));
        assert!(circle.is_zero() && circle.zeros().is_empty() && circle.sign() == Some(0));
        assert!(x.minus(&x.integer(2)).zeros().is_empty());
        assert_eq!(x.over(&half).unwrap().minus(&x.plus(&x)).sign(), Some(0));
    }
}
