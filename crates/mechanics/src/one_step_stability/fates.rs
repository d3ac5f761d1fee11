//! Growth or decay of a mode under a one-step method, as a function of the step size.

use super::{HalfPlane, StabilityFunction};
use algebra::complex::{Rectangle, zeros};
use algebra::real::{Enclosure, Polynomial, Root};
use field::{Rational, Scalar};

/// The thresholds of the step size at which the growth of a mode changes, in ascending order, and the sign of the
/// growth before, between and after them: -1 decay, 0 constant amplitude, 1 growth.
#[derive(Clone, Debug)]
pub struct Fates {
    pub cuts: Vec<Enclosure>,
    pub signs: Vec<i32>,
}

/// The error for thresholds of the step size that could not be separated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UndecidedFate;

impl Fates {
    /// The thresholds of a mode under a method, with the signs between them.
    ///
    /// # Errors
    /// [`UndecidedFate`] where two thresholds coincide or nearly do.
    pub fn of(place: &HalfPlane, function: &StabilityFunction) -> Result<Self, UndecidedFate> {
        let (terms, _) = function.balance();
        match place {
            // Re u^m is 1 or (-1)^m
            HalfPlane::Real(mu) => {
                let size = if mu.sign() == Some(-1) { -mu } else { mu.clone() };
                let turn = |m: usize| if mu.sign() == Some(-1) && m % 2 == 1 { -1 } else { 1 };
                Self::exactly(&terms, turn, &size)
            }
            // Re i^m
            HalfPlane::Imaginary(b) => Self::exactly(&terms, |m| [1, 0, -1, 0][m % 4], b),
            HalfPlane::Pair(mu) => Self::enclosed(&terms, mu).ok_or(UndecidedFate),
        }
    }

    /// The sign for a step size; `None` where it lies within the enclosure of a threshold.
    pub fn at(&self, step: &Enclosure) -> Option<i32> {
        let mut passed = 0;
        for cut in &self.cuts {
            match (step - cut).sign()? {
                1 => passed += 1,
                _ => break,
            }
        }
        self.signs.get(passed).copied()
    }

    /// Thresholds along a direction in which Re u^m is an integer: they are algebraic numbers of the method, divided by
    /// |mu|.
    fn exactly(terms: &[Vec<Rational>], turn: impl Fn(usize) -> i64, size: &Enclosure) -> Result<Self, UndecidedFate> {
        let sum = |term: &Vec<Rational>| {
            let parts = term.iter().enumerate().map(|(m, c)| *c * Rational::int(turn(m)));
            parts.fold(Rational::int(0), |sum, part| sum + part)
        };
        let coefficients: Vec<Rational> = terms.iter().map(sum).collect();
        let polynomial = Polynomial::from_rationals(&coefficients).ok_or(UndecidedFate)?;
        let zero = Polynomial::from_integers([0, 1]);
        let roots: Vec<Root> = polynomial.real_roots().into_iter().filter(|root| root.sign_of(&zero) > 0).collect();
        // double roots are kept: the mode has constant amplitude at this step size only
        let bits = size.bits();
        let places: Vec<Enclosure> = roots.iter().map(|root| root.enclosure(bits)).collect();
        let value = |x: &Enclosure| polynomial.enclosure(x, bits).sign();
        Self::between(places, size, value).ok_or(UndecidedFate)
    }

    fn enclosed(terms: &[Vec<Rational>], mu: &Rectangle) -> Option<Self> {
        let bits = mu.re.bits();
        let size = mu.square().sqrt()?;
        let unit = Rectangle { re: mu.re.over(&size)?, im: mu.im.over(&size)? };
        let most = terms.iter().map(Vec::len).max().unwrap_or(0);
        let mut powers = vec![Rectangle::real(Enclosure::integer(1, bits), bits)];
        while powers.len() < most {
            powers.push(powers.last()? * &unit);
        }
        let coefficient = |term: &Vec<Rational>| {
            let mut sum = Enclosure::integer(0, bits);
            for (c, power) in term.iter().zip(&powers) {
                sum = &sum + &(&Enclosure::rational(*c, bits)? * &power.re);
            }
            Some(sum)
        };
        let coefficients: Vec<Enclosure> = terms.iter().map(coefficient).collect::<Option<_>>()?;
        let mut places = Vec::new();
        for zero in zeros(&coefficients)? {
            if zero.real && zero.at.re.sign()? > 0 {
                places.push(zero.at.re);
            }
        }
        places.sort_by(|a, b| a.to_f64().total_cmp(&b.to_f64()));
        let value = |x: &Enclosure| {
            coefficients.iter().rev().fold(Enclosure::integer(0, bits), |sum, c| &(&sum * x) + c).sign()
        };
        Self::between(places, &size, value)
    }

    /// The thresholds x = h |mu| in ascending order as step sizes, with the signs of a polynomial between them.
    fn between(places: Vec<Enclosure>, size: &Enclosure, value: impl Fn(&Enclosure) -> Option<i32>) -> Option<Self> {
        let bits = size.bits();
        let number = |n: i64| Enclosure::integer(n, bits);
        let mut probes = Vec::new();
        let mut before = number(0);
        for place in &places {
            probes.push((&before + place).over(&number(2))?.middle());
            before = place.clone();
        }
        probes.push((&before + &number(1)).middle());
        let signs = probes.iter().map(value).collect::<Option<_>>()?;
        let cuts = places.iter().map(|place| place.over(size)).collect::<Option<_>>()?;
        Some(Fates { cuts, signs })
    }
}
