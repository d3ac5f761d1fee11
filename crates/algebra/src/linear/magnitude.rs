//! The magnitude of scalars, for the choice of pivots.

use crate::real::{Model, Rounded};
use field::{Batch, DoubleDouble, Rational, Scalar, Tangent};

/// The precision of a scalar type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Rounded values: a number that is small compared with the largest pivot counts as zero.
    Rounded,
    /// Exact values: every nonzero number is a pivot.
    Exact,
    /// Enclosures: an interval without zero is a pivot, and every unknown needs one.
    Enclosed,
}

/// A scalar type with a magnitude.
pub trait Magnitude: Scalar {
    const KIND: Kind = Kind::Rounded;

    /// |x| to a few digits, without derivatives: zero only for zero, NaN where undefined. For an enclosure the smallest
    /// magnitude of its values, zero if it contains zero.
    fn magnitude(self) -> f64;
}

impl Magnitude for f64 {
    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.abs()
    }
}

impl<const D: usize> Magnitude for num_dual::DualSVec64<D> {
    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.re.abs()
    }
}

/// Dual numbers with one value and a separate derivative in each lane.
impl<const L: usize> Magnitude for Tangent<Batch<L>> {
    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.value.0[0].abs()
    }
}

impl Magnitude for DoubleDouble {
    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.hi().abs()
    }
}

impl Magnitude for Rational {
    const KIND: Kind = Kind::Exact;

    fn magnitude(self) -> f64 {
        match self.sign() {
            Some(0) => 0.0,
            // a fraction below the range of `f64` is not zero
            Some(_) => self.to_f64().abs().clamp(f64::MIN_POSITIVE, f64::MAX),
            None => f64::NAN,
        }
    }
}

impl<C: Rounded, const N: usize> Magnitude for Model<C, N> {
    const KIND: Kind = Kind::Enclosed;

    fn magnitude(self) -> f64 {
        self.least()
    }
}
