//! Polynomials with rational coefficients, represented by exponents and coefficients of their terms.

use field::Rational;
use std::collections::BTreeMap;
use symbolic::{Hypotheses, Sym, coefficients, normal};

/// The largest number of terms of a polynomial; [`HIGHEST`] is the largest degree.
const MOST_TERMS: usize = 40;
const HIGHEST: u32 = 12;

/// A polynomial: the coefficient of each product of letters, by the exponents of the letters.
pub(crate) type Terms = BTreeMap<Vec<u32>, Rational>;

/// The difference of two polynomials.
pub(crate) fn difference(mut from: Terms, other: &Terms) -> Terms {
    for (exponents, value) in other {
        *from.entry(exponents.clone()).or_insert_with(|| Rational::new(0, 1)) -= *value;
    }
    from.retain(|_, value| value.sign() != Some(0));
    from
}

/// The terms of an expression that is a polynomial in these letters; `None` if it is not, or has too many terms.
pub(crate) fn terms(polynomial: Sym, letters: &[Sym]) -> Option<Terms> {
    let found = coefficients(polynomial, letters).ok().filter(|found| found.len() <= MOST_TERMS)?;
    let number = |value: Sym| {
        let value = normal(value, &Hypotheses::none()).ok()?.to_sym().as_constant()?;
        value.is_defined().then_some(value)
    };
    let all: Terms =
        found.into_iter().map(|(exponents, value)| Some((exponents, number(value)?))).collect::<Option<_>>()?;
    Some(all.into_iter().filter(|(_, value)| value.sign() != Some(0)).collect())
}

/// The product of two polynomials; `None` if its degree or its number of terms is too large.
pub(crate) fn product(one: &Terms, other: &Terms) -> Option<Terms> {
    let mut all = Terms::new();
    for (exponents, value) in one {
        for (others, factor) in other {
            let powers: Vec<u32> = exponents.iter().zip(others).map(|(a, b)| a + b).collect();
            if powers.iter().sum::<u32>() > HIGHEST {
                return None;
            }
            let sum = all.entry(powers).or_insert_with(|| Rational::new(0, 1));
            *sum += *value * *factor;
        }
    }
    all.retain(|_, value| value.sign() != Some(0));
    (all.len() <= MOST_TERMS).then_some(all)
}
