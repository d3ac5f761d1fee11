//! The field of rational functions of one letter, with rational coefficients.

use super::reduction::Pivot;
use algebra::real::Ordered;
use field::{Rational, Scalar};
use symbolic::{Hypotheses, Sym, normal, univariate};

/// The coefficients of a polynomial from the constant term on, without trailing zeros; empty for zero.
type Coefficients = Vec<Rational>;

/// A rational function in lowest terms; the highest coefficient of the denominator `below` is one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Quotient {
    pub above: Coefficients,
    pub below: Coefficients,
}

impl Quotient {
    pub fn constant(value: Rational) -> Self {
        Quotient { above: trimmed(vec![value]), below: vec![Rational::int(1)] }
    }

    /// The letter itself.
    pub fn letter() -> Self {
        Quotient { above: vec![Rational::int(0), Rational::int(1)], below: vec![Rational::int(1)] }
    }

    /// An expression as a rational function of the letter; `None` if it is not one.
    pub fn of(expression: Sym, letter: Sym) -> Option<Self> {
        if let Some(value) = expression.as_constant() {
            return value.is_defined().then(|| Self::constant(value));
        }
        let form = normal(expression, &Hypotheses::none()).ok()?;
        let above = univariate(form.numerator(), letter).ok()?;
        let below = univariate(form.denominator(), letter).ok()?;
        (!below.is_empty()).then(|| Self::reduced(above, below))
    }

    /// The value at a point; `None` at a pole.
    pub fn at(&self, value: Rational) -> Option<Rational> {
        let horner = |all: &Coefficients| all.iter().rev().fold(Rational::int(0), |sum, c| sum * value + *c);
        Some(horner(&self.above) / horner(&self.below)).filter(|value| value.is_defined())
    }

    fn reduced(above: Coefficients, below: Coefficients) -> Self {
        let (above, below) = (trimmed(above), trimmed(below));
        let divisor = gcd(above.clone(), below.clone());
        let (above, below) = (divided(above, &divisor).0, divided(below, &divisor).0);
        let lead = below.last().copied().unwrap_or(Rational::int(1));
        let scaled = |all: Coefficients| all.into_iter().map(|c| c / lead).collect();
        Quotient { above: scaled(above), below: scaled(below) }
    }
}

impl Ordered for Quotient {
    fn fraction(&self, value: Rational) -> Option<Self> {
        value.is_defined().then(|| Self::constant(value))
    }

    fn integer(&self, n: i64) -> Self {
        Self::constant(Rational::int(n))
    }

    fn plus(&self, b: &Self) -> Self {
        if self.above.is_empty() || b.above.is_empty() {
            return if self.above.is_empty() { b.clone() } else { self.clone() };
        }
        let above = sum(&product(&self.above, &b.below), &product(&b.above, &self.below));
        Self::reduced(above, product(&self.below, &b.below))
    }

    fn minus(&self, b: &Self) -> Self {
        let negative = Quotient { above: b.above.iter().map(|c| -*c).collect(), below: b.below.clone() };
        self.plus(&negative)
    }

    fn times(&self, b: &Self) -> Self {
        Self::reduced(product(&self.above, &b.above), product(&self.below, &b.below))
    }

    fn over(&self, b: &Self) -> Option<Self> {
        let inverse = (!b.above.is_empty()).then(|| Self::reduced(b.below.clone(), b.above.clone()))?;
        Some(self.times(&inverse))
    }

    fn root(&self) -> Option<Self> {
        None
    }

    /// The sign of a constant; `None` if the letter occurs.
    fn sign(&self) -> Option<i32> {
        match (&self.above[..], &self.below[..]) {
            ([], _) => Some(0),
            ([value], [_]) => value.sign(),
            _ => None,
        }
    }
}

impl Pivot for Quotient {
    /// The preference as a pivot: simpler functions have a larger weight.
    fn weight(&self) -> f64 {
        if self.above.is_empty() { 0.0 } else { 1.0 / (self.above.len() + self.below.len()) as f64 }
    }
}

fn trimmed(mut all: Coefficients) -> Coefficients {
    while all.last().is_some_and(|last| last.sign() == Some(0)) {
        all.pop();
    }
    all
}

fn sum(a: &Coefficients, b: &Coefficients) -> Coefficients {
    let of = |all: &Coefficients, k: usize| all.get(k).copied().unwrap_or(Rational::int(0));
    (0..a.len().max(b.len())).map(|k| of(a, k) + of(b, k)).collect()
}

pub(super) fn product(a: &Coefficients, b: &Coefficients) -> Coefficients {
    let mut all = vec![Rational::int(0); (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate() {
        b.iter().enumerate().for_each(|(j, y)| all[i + j] += *x * *y);
    }
    all
}

/// The quotient and the remainder of a polynomial division.
fn divided(mut rest: Coefficients, by: &Coefficients) -> (Coefficients, Coefficients) {
    let Some(&lead) = by.last() else { return (rest, Vec::new()) };
    let mut quotient = vec![Rational::int(0); (rest.len() + 1).saturating_sub(by.len())];
    for place in (0..quotient.len()).rev() {
        let factor = rest[place + by.len() - 1] / lead;
        quotient[place] = factor;
        by.iter().enumerate().for_each(|(k, c)| rest[place + k] -= factor * *c);
    }
    (trimmed(quotient), trimmed(rest))
}

/// The greatest common divisor with leading coefficient one.
fn gcd(mut a: Coefficients, mut b: Coefficients) -> Coefficients {
    while !b.is_empty() {
        let rest = divided(a, &b).1;
        // scaling keeps the coefficients small
        let lead = rest.last().copied().unwrap_or(Rational::int(1));
        (a, b) = (b, rest.into_iter().map(|c| c / lead).collect());
    }
    let lead = a.last().copied().unwrap_or(Rational::int(1));
    a.into_iter().map(|c| c / lead).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_kept_in_lowest_terms() {
        let p = Quotient::letter();
        let one = p.integer(1);
        let square = p.times(&p).minus(&one);
        let quotient = square.over(&p.minus(&one)).expect("it is not zero");
        assert_eq!(quotient, p.plus(&one));
        let back = one.over(&p).and_then(|inverse| inverse.plus(&p).over(&p));
        assert_eq!(back.and_then(|back| back.at(Rational::int(2))), Some(Rational::new(5, 4)));
        assert_eq!(p.minus(&p).sign(), Some(0));
    }
}
