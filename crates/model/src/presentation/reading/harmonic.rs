//! Multiple angles: whole and fractional multiples of terms, added.

use field::Rational;

/// A fraction in lowest terms, with a positive denominator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Multiple {
    pub numerator: i64,
    pub denominator: i64,
}

impl Multiple {
    /// None where it is too large.
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

/// An angle: multiples of terms by their places, sorted, none zero, the first positive.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Harmonic {
    pub multiples: Vec<(u32, Multiple)>,
    /// Whether a sign was taken out so that the first is positive.
    pub is_turned: bool,
}

impl Harmonic {
    /// In any order.
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

    /// The sum of two lists of multiples, the second with a sign.
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
