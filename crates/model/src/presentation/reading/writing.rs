//! Conversion of a sum to an expression: terms with equal symbols and angles are collected, common factors of parameters are outside.

use super::Reading;
use super::circles::{Factor, shorter};
use super::sum::{Monomial, Sum, Wave};
use field::{Rational, Scalar};
use num_traits::{One as _, Zero as _};
use std::collections::BTreeMap;
use symbolic::Sym;

/// For each product of symbols and angles, the terms in the parameters.
type Shared = BTreeMap<(Monomial, Factor), Vec<(Monomial, Rational)>>;

impl Reading {
    pub(super) fn written(&self, sum: &Sum) -> Sym {
        let mut waves: BTreeMap<Monomial, Vec<(Wave, Rational)>> = BTreeMap::new();
        for term in sum.terms() {
            waves.entry(term.monomial).or_default().push((term.wave, term.coefficient));
        }
        let mut shared = Shared::new();
        for (monomial, waves) in waves {
            let (parameters, others): (Monomial, Monomial) =
                monomial.into_iter().partition(|(place, _)| *place < self.parameters);
            for (factor, coefficient) in shorter(&waves) {
                let cancelled = self.cancelled(others.clone(), factor);
                shared.entry(cancelled).or_default().push((parameters.clone(), coefficient));
            }
        }
        let terms = shared.iter().map(|((others, factor), parameters)| self.term(parameters, others, factor));
        terms.fold(Sym::ZERO, |sum, term| sum + term)
    }

    /// Cancels cosines and sines that also occur in a divisor.
    fn cancelled(&self, mut others: Monomial, mut factor: Factor) -> (Monomial, Factor) {
        for (place, exponent) in others.iter_mut().filter(|(_, exponent)| *exponent < 0) {
            let divisor = self.leaves[*place as usize].expression;
            while *exponent < 0
                && let Some(rest) = factor.without(|wave| self.angle(wave) == divisor)
            {
                (factor, *exponent) = (rest, *exponent + 1);
            }
        }
        others.retain(|(_, exponent)| *exponent != 0);
        (others, factor)
    }

    /// Returns a sum of monomials in the parameters, times symbols and angles.
    fn term(&self, parameters: &[(Monomial, Rational)], others: &Monomial, factor: &Factor) -> Sym {
        let outside = common(parameters);
        let [.., last] = parameters else { return Sym::ZERO };
        let is_bare = outside.is_empty() && others.is_empty() && *factor == Factor::Wave(Wave::default());
        if parameters.len() > 1 && is_bare {
            // a sum of parameters only has no common factor outside
            let single = |one: &(Monomial, Rational)| self.term(std::slice::from_ref(one), others, factor);
            return parameters.iter().map(single).fold(Sym::ZERO, |sum, term| sum + term);
        }
        let number = if parameters.len() == 1 { last.1 } else { content(parameters) };
        let (mut above, mut below) = parts(number);
        if parameters.len() > 1 {
            let inside = parameters.iter().map(|(monomial, coefficient)| {
                let (above, below) = parts(*coefficient / number);
                let rest = without(monomial, &outside);
                self.multiplied(above, below, &rest, &[])
            });
            above *= inside.fold(Sym::ZERO, |sum, term| sum + term);
        }
        let angles = self.angles(factor);
        let all: Monomial = outside.into_iter().chain(others.iter().copied()).collect();
        for &(place, exponent) in all.iter().filter(|(_, exponent)| *exponent < 0) {
            below *= self.leaves[place as usize].expression.powi(-exponent);
        }
        let positive: Monomial = all.into_iter().filter(|(_, exponent)| *exponent > 0).collect();
        self.multiplied(above, Sym::ONE, &positive, &angles) / below
    }

    fn multiplied(&self, above: Sym, below: Sym, monomial: &Monomial, more: &[Sym]) -> Sym {
        let (mut above, mut below) = (above, below);
        for &(place, exponent) in monomial {
            let power = self.leaves[place as usize].expression.powi(exponent.abs());
            if exponent < 0 {
                below *= power;
            } else {
                above *= power;
            }
        }
        more.iter().fold(above, |product, factor| product * *factor) / below
    }

    fn angles(&self, factor: &Factor) -> Vec<Sym> {
        factor.waves().into_iter().map(|(wave, exponent)| self.angle(&wave).powi(exponent as i32)).collect()
    }

    /// Returns a cosine or sine as an expression.
    fn angle(&self, wave: &Wave) -> Sym {
        let angle = wave.angle.iter().fold(Sym::ZERO, |sum, (atom, multiple)| {
            let size = Rational::new(multiple.numerator.abs(), multiple.denominator);
            let term = times(size, self.atoms[*atom as usize]);
            if multiple.numerator < 0 { sum - term } else { sum + term }
        });
        let point = angle.circle_as_written();
        if wave.is_sine { point.sin } else { point.cos }
    }
}

/// Returns a multiple of a term: 2*x, x/2, 3*x/4.
fn times(number: Rational, term: Sym) -> Sym {
    let (above, below) = parts(number);
    if term == Sym::ONE { above / below } else { above * term / below }
}

/// Splits a number into numerator and denominator; a number that is printed as a decimal is not split.
fn parts(number: Rational) -> (Sym, Sym) {
    /// The largest denominator of a printed fraction.
    const LARGEST: i64 = 1_000;
    let small = number.to_big().and_then(|big| {
        let below = i64::try_from(big.denominator()).ok().filter(|below| *below <= LARGEST)?;
        // fractions whose denominator contains only the factors 2 and 5 are printed as decimals, except small ones and powers of two
        let mut rest = below;
        for prime in [2, 5] {
            while rest % prime == 0 {
                rest /= prime;
            }
        }
        (below <= 16 || rest > 1 || below.count_ones() == 1).then_some(below)
    });
    match small {
        Some(below) => (Sym::constant(number * Rational::new(below, 1)), Sym::int(below)),
        None => (Sym::constant(number), Sym::ONE),
    }
}

/// Returns the greatest common monomial.
pub(super) fn common(parameters: &[(Monomial, Rational)]) -> Monomial {
    let Some(((first, _), others)) = parameters.split_first() else { return Vec::new() };
    let exponent = |monomial: &Monomial, place: u32| {
        monomial.iter().find(|(known, _)| *known == place).map_or(0, |(_, exponent)| *exponent)
    };
    let mut places: Vec<u32> = parameters.iter().flat_map(|(monomial, _)| monomial).map(|(place, _)| *place).collect();
    places.sort_unstable();
    places.dedup();
    let least = |place: u32| {
        others.iter().map(|(monomial, _)| exponent(monomial, place)).fold(exponent(first, place), i32::min)
    };
    places.into_iter().map(|place| (place, least(place))).filter(|(_, exponent)| *exponent != 0).collect()
}

fn without(monomial: &Monomial, divisor: &Monomial) -> Monomial {
    let mut rest = monomial.clone();
    for &(place, exponent) in divisor {
        match rest.iter_mut().find(|(known, _)| *known == place) {
            Some((_, own)) => *own -= exponent,
            None => rest.push((place, -exponent)),
        }
    }
    rest.retain(|(_, exponent)| *exponent != 0);
    rest.sort_unstable();
    rest
}

/// Returns the greatest common divisor of all coefficients, with the sign of the first one; one if they are large.
pub(super) fn content(parameters: &[(Monomial, Rational)]) -> Rational {
    let one = Rational::one();
    let mut content: Option<(i64, i64)> = None;
    for (_, coefficient) in parameters {
        let Some(big) = coefficient.to_big() else { return one };
        let (Ok(above), Ok(below)) = (i64::try_from(big.numerator()), i64::try_from(big.denominator())) else {
            return one;
        };
        if below > 1_000 || above.abs() > 1_000_000 {
            return one;
        }
        content = Some(match content {
            None => (above.abs(), below),
            Some((a, b)) => (divisor(a, above.abs()), b / divisor(b, below) * below),
        });
    }
    let is_negative = parameters.first().is_some_and(|(_, first)| first.sign() == Some(-1));
    match content {
        Some((above, below)) if below < 1 << 30 && above != 0 => {
            Rational::new(if is_negative { -above } else { above }, below)
        }
        _ => one,
    }
}

fn divisor(a: i64, b: i64) -> i64 {
    if b.is_zero() { a } else { divisor(b, a % b) }
}
