//! Scalars with a sign, for the choice between regimes.

use field::{Rational, Scalar};
use std::cmp::Ordering;

/// A scalar type with an order.
pub trait Ordered: Scalar {
    /// The sign of a number that was computed from terms of magnitude `size`. `Equal` is exact over exact scalars, and
    /// means "zero within rounding" over rounded ones.
    fn sign_among(self, size: Self) -> Ordering;

    /// Whether the number is neither infinite nor NaN.
    fn defined(self) -> bool;

    /// The magnitude |x|.
    fn size(self) -> Self {
        if self.sign_among(Self::zero()) == Ordering::Less { -self } else { self }
    }
}

/// The relative rounding error, in double precision, at the located state of an event.
const ROUNDING: f64 = 1e-11;

impl Ordered for f64 {
    fn sign_among(self, size: Self) -> Ordering {
        if self.abs() <= ROUNDING * size { Ordering::Equal } else { self.total_cmp(&0.0) }
    }

    fn defined(self) -> bool {
        self.is_finite()
    }
}

impl Ordered for Rational {
    fn sign_among(self, _size: Self) -> Ordering {
        self.sign().unwrap_or(0).cmp(&0)
    }

    fn defined(self) -> bool {
        self.is_defined()
    }
}
