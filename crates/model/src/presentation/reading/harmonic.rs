//! Angles as linear combinations of terms with rational coefficients, such as 2*a - b/2, and sums and differences of such angles.

use field::Rational;

/// A rational number in lowest terms, with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Multiple {
    pub numerator: i64,
    pub denominator: i64,
}

impl Multiple {
    /// Returns `None` if numerator or denominator is too large.
    pub fn of(value: Rational) -> Option<Self> {
        let big = value.to_big()?;
        let (numerator, denominator) = (i64::try_from(big.numerator()).ok()?, i64::try_from(big.denominator()).ok()?);
        let is_small = numerator.abs() < 1 << 30 && denominator < 1 << 30;
        is_small.then_some(Multiple { numerator, denominator })
    }

    pub fn value(self) -> Rational {
        Rational::new(self.numerator, self.denominator)
    }
}

/// An angle, as (index of the term, coefficient) sorted by index. Coefficients are nonzero, and the first one is positive.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Harmonic {
    pub multiples: Vec<(u32, Multiple)>,
    /// Whether the sign of the angle was reversed to make the first coefficient positive.
    pub is_turned: bool,
}

impl Harmonic {
    /// Creates an angle from terms in any order.
    pub fn of(mut multiples: Vec<(u32, Multiple)>) -> Self {
        multiples.sort_by_key(|(atom, _)| *atom);
        let is_turned = multiples.first().is_some_and(|(_, multiple)| multiple.numerator < 0);
        if is_turned {
            for (_, multiple) in &mut multiples {
                multiple.numerator = -multiple.numerator;
            }
        }
        Harmonic { multiples, is_turned }
    }

    /// Returns the sum of two angles, the second multiplied by `sign`; `None` if a coefficient is too large.
    pub fn combined(a: &[(u32, Multiple)], b: &[(u32, Multiple)], sign: i64) -> Option<Self> {
        let mut all: Vec<(u32, Multiple)> = a.to_vec();
        for (atom, multiple) in b {
            let multiple = Multiple { numerator: sign * multiple.numerator, ..*multiple };
            match all.iter_mut().find(|(known, _)| known == atom) {
                Some((_, sum)) => *sum = Multiple::of(sum.value() + multiple.value())?,
                None => all.push((*atom, multiple)),
            }
        }
        all.retain(|(_, multiple)| multiple.numerator != 0);
        Some(Harmonic::of(all))
    }
}
