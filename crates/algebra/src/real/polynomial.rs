//! Univariate polynomials.

use super::{Enclosure, Number};
use dashu_int::IBig;
use dashu_int::ops::{Gcd, UnsignedAbs};
use field::Rational;
use std::ops::{Add, Mul, Neg, Sub};

/// A polynomial: coefficients from the constant upwards; the last one is nonzero.
#[derive(Clone, Debug, Default)]
pub struct Polynomial(Vec<Number>);

impl Polynomial {
    /// The polynomial with these coefficients, the constant first.
    pub fn new(coefficients: Vec<Number>) -> Self {
        Polynomial(coefficients).trimmed()
    }

    /// The polynomial with these integer coefficients, the constant first.
    pub fn from_integers<N: Into<IBig>>(coefficients: impl IntoIterator<Item = N>) -> Self {
        Self::new(coefficients.into_iter().map(|n| Number::from(n.into())).collect())
    }

    /// The primitive integer polynomial that is a positive multiple of the given one, the constant first. `None` where
    /// a coefficient is undefined.
    pub fn from_rationals(coefficients: &[Rational]) -> Option<Self> {
        let (whole, _) = Number::over_common(coefficients)?;
        Some(Self::new(whole).primitive())
    }

    /// The constant polynomial.
    pub fn constant(value: Number) -> Self {
        Self::new(vec![value])
    }

    /// The coefficients, from the constant upwards.
    pub fn coefficients(&self) -> &[Number] {
        &self.0
    }

    /// The degree; `None` for zero.
    pub fn degree(&self) -> Option<usize> {
        self.0.len().checked_sub(1)
    }

    /// Whether the polynomial is zero.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The leading coefficient; zero for the zero polynomial.
    pub fn lead(&self) -> Number {
        self.0.last().cloned().unwrap_or_else(Number::zero)
    }

    /// The coefficients as integers; `None` where one is no integer.
    pub fn integers(&self) -> Option<Vec<IBig>> {
        self.0.iter().map(Number::as_integer).collect()
    }

    /// The derivative.
    pub fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Polynomial(terms.map(|(power, c)| c * &Number::from(power as i64)).collect())
    }

    /// The polynomial divided by the largest positive integer that divides all coefficients.
    pub fn primitive(&self) -> Self {
        let mut common = dashu_int::UBig::ZERO;
        for part in self.0.iter().flat_map(|c| c.parts()).filter(|part| **part != IBig::ZERO) {
            common = common.gcd(part.unsigned_abs());
            if common == dashu_int::UBig::ONE {
                return self.clone();
            }
        }
        if common == dashu_int::UBig::ZERO {
            return self.clone();
        }
        let common = IBig::from(common);
        Polynomial(self.0.iter().map(|c| c.map(|part| part / &common)).collect())
    }

    /// The remainder of a positive multiple modulo the divisor.
    pub fn remainder(&self, divisor: &Self) -> Self {
        self.divided(divisor, None).1
    }

    /// The quotient by a divisor, exact after multiplication with the divisor's leading coefficient to this power,
    /// which is at least the difference of the degrees plus 1.
    pub fn quotient(&self, divisor: &Self, power: usize) -> Self {
        self.divided(divisor, Some(power)).0
    }

    /// Quotient and remainder of a multiple: by |lead|^k with the smallest k, or by lead^power.
    fn divided(&self, divisor: &Self, power: Option<usize>) -> (Self, Self) {
        let Some(degree) = divisor.degree() else { return (Self::default(), self.clone()) };
        let lead = divisor.lead();
        let factor = if power.is_none() && lead.sign() < 0 { -&lead } else { lead.clone() };
        let negative = power.is_none() && lead.sign() < 0;
        let mut rest = self.clone();
        let mut quotient = vec![Number::zero(); (self.0.len()).saturating_sub(degree)];
        let mut left = power.unwrap_or(0);
        while let Some(high) = rest.degree().filter(|high| *high >= degree) {
            let top = rest.lead();
            let top = if negative { -&top } else { top };
            quotient.iter_mut().for_each(|c| *c = &*c * &factor);
            quotient[high - degree] = &quotient[high - degree] + &top;
            rest.0.pop();
            rest.0.iter_mut().for_each(|c| *c = &*c * &factor);
            for (place, c) in divisor.0[..degree].iter().enumerate() {
                let at = high - degree + place;
                rest.0[at] = &rest.0[at] - &(c * &top);
            }
            rest = rest.trimmed();
            left = left.saturating_sub(1);
        }
        for _ in 0..left {
            quotient.iter_mut().for_each(|c| *c = &*c * &factor);
        }
        (Polynomial(quotient).trimmed(), rest)
    }

    /// The greatest common divisor by Euclid's algorithm, up to a factor; zero where both are zero.
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.primitive(), other.primitive());
        while !b.is_zero() {
            let rest = a.remainder(&b).primitive();
            (a, b) = (b, rest);
        }
        a
    }

    /// The polynomial with simple roots at the roots of this one.
    pub fn square_free(&self) -> Self {
        let repeated = self.gcd(&self.derivative());
        match repeated.degree() {
            Some(0) | None => self.clone(),
            Some(_) => self.quotient(&repeated, self.0.len()).primitive(),
        }
    }

    /// An enclosure of the values on an interval.
    pub fn enclosure(&self, at: &Enclosure, bits: usize) -> Enclosure {
        let mut sum = Enclosure::integer(IBig::ZERO, bits);
        for c in self.0.iter().rev() {
            sum = &(&sum * at) + &c.enclosure(bits);
        }
        sum
    }

    pub(super) fn map(&self, f: impl Fn(usize, &Number) -> Number) -> Self {
        Self::new(self.0.iter().enumerate().map(|(power, c)| f(power, c)).collect())
    }

    fn trimmed(mut self) -> Self {
        while self.0.last().is_some_and(Number::is_zero) {
            self.0.pop();
        }
        self
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, b: &Polynomial) -> Polynomial {
        let (long, short) = if self.0.len() < b.0.len() { (b, self) } else { (self, b) };
        let mut sum = long.clone();
        sum.0.iter_mut().zip(&short.0).for_each(|(a, b)| *a = &*a + b);
        sum.trimmed()
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial(self.0.iter().map(|c| -c).collect())
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, b: &Polynomial) -> Polynomial {
        self + &-b
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, b: &Polynomial) -> Polynomial {
        let mut product = vec![Number::zero(); (self.0.len() + b.0.len()).saturating_sub(1)];
        for (i, x) in self.0.iter().enumerate() {
            for (j, y) in b.0.iter().enumerate() {
                product[i + j] = &product[i + j] + &(x * y);
            }
        }
        Polynomial(product).trimmed()
    }
}
