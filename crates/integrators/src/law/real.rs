//! Ordered scalar types for integration.

use field::{Analytic, Base, DoubleDouble, Over};

/// A type of rounded real numbers. Laws may not compare numbers; step size control must.
pub trait Real: Analytic + Base + Over<f64> + PartialOrd {
    /// The distance from 1 to the next larger number.
    const EPSILON: f64;

    /// The nearest `f64`, for norms, step sizes and reports.
    fn approx(self) -> f64;

    /// e^x.
    fn exp(self) -> Self;

    /// |x|.
    fn magnitude(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }

    /// Whether the number is neither infinite nor NaN.
    fn finite(self) -> bool {
        self.approx().is_finite()
    }
}

impl Real for f64 {
    const EPSILON: f64 = f64::EPSILON;

    #[inline]
    fn approx(self) -> f64 {
        self
    }

    #[inline]
    fn exp(self) -> Self {
        f64::exp(self)
    }
}

impl Real for DoubleDouble {
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON / 2.0;

    #[inline]
    fn approx(self) -> f64 {
        self.hi()
    }

    fn exp(self) -> Self {
        num_traits::Float::exp(self)
    }
}
