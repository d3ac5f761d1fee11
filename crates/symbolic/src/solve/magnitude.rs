//! The size of a number, by which pivots are chosen.

use field::{DoubleDouble, Rational, Scalar};

/// A field whose numbers have a size.
pub trait Magnitude: Scalar {
    /// Whether the field does not round: then what is not zero is a pivot.
    const EXACT: bool = false;

    /// |x| to a few digits, of a number with derivatives that of the number; zero for zero alone, NaN where there is no value.
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

impl Magnitude for DoubleDouble {
    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.hi().abs()
    }
}

impl Magnitude for Rational {
    const EXACT: bool = true;

    fn magnitude(self) -> f64 {
        match self.sign() {
            Some(0) => 0.0,
            // a fraction below the range of `f64` is not zero
            Some(_) => self.to_f64().abs().clamp(f64::MIN_POSITIVE, f64::MAX),
            None => f64::NAN,
        }
    }
}
