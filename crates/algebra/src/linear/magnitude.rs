//! The size of a number, by which pivots are chosen.

use crate::real::{Model, Rounded};
use field::{Batch, DoubleDouble, Rational, Scalar, Tangent};

/// The meaning of the numbers of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A value up to rounding: a number that is small beside the largest pivot is zero.
    Rounded,
    /// The exact value: a number that is not zero is a pivot.
    Exact,
    /// All values between two ends: an interval without zero is a pivot, and every unknown needs one.
    Enclosed,
}

/// A field whose numbers have a size.
pub trait Magnitude: Scalar {
    const KIND: Kind = Kind::Rounded;

    /// |x| to a few digits, without derivatives; zero for zero alone, NaN where there is no value. For an enclosure the least
    /// size of its values, zero where zero is among them.
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

/// The tangent of numbers with the same value in every lane, each with a slope of its own.
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
