//! Numbers with a sign: the laws do not compare, but the choice between regimes must.

use field::{Rational, Scalar};
use std::cmp::Ordering;

/// A field with an order.
pub trait Ordered: Scalar {
    /// The sign of a number that was computed from terms of this size. `Equal` is exact over an exact field, and
    /// "within rounding of zero" over a rounded one: a tie, which the verdict reports.
    fn sign_among(self, size: Self) -> Ordering;

    /// Whether the number is neither infinite nor undefined.
    fn defined(self) -> bool;

    /// |x|.
    fn size(self) -> Self {
        if self.sign_among(Self::zero()) == Ordering::Less { -self } else { self }
    }
}

/// Relative to the terms: the rounding error in double precision at the located state of an event.
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
