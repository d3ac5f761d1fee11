//! Taylor coefficients of the solutions of a law.

use field::Scalar;

/// A source of Taylor coefficients: the recurrences of a system's expression graph.
pub trait TaylorSeries<S: Scalar> {
    /// Expands the solution through (t, y) up to an order.
    fn expand(&mut self, t: S, y: &[S], order: usize);

    /// As [`expand`](Self::expand), where the digits of `f64` suffice for the coefficients after the order `fine`. Returns the
    /// order up to which they have all digits of the field.
    fn expand_rounding(&mut self, t: S, y: &[S], order: usize, _fine: usize) -> usize {
        self.expand(t, y, order);
        order
    }

    /// The coefficients of order k of the last expansion, which are the k-th derivatives over k!, for k up to its order.
    fn coefficients(&self, k: usize) -> &[S];

    /// The sum of the last expansion at h.
    fn sum(&self, h: S, out: &mut [S]);

    /// The longest step over which the terms of the last expansion show the law: far from zero exp(-x) has no terms, and a step to
    /// zero would not see it.
    fn shown(&self) -> f64 {
        f64::INFINITY
    }

    /// Whether the law has roots or angles: the series of one continues along its branch where the law takes another, as the root of x^2
    /// does at x = 0.
    fn has_branches(&self) -> bool {
        false
    }
}

impl<S: Scalar, T: TaylorSeries<S> + ?Sized> TaylorSeries<S> for Box<T> {
    fn expand(&mut self, t: S, y: &[S], order: usize) {
        (**self).expand(t, y, order);
    }

    fn expand_rounding(&mut self, t: S, y: &[S], order: usize, fine: usize) -> usize {
        (**self).expand_rounding(t, y, order, fine)
    }

    fn coefficients(&self, k: usize) -> &[S] {
        (**self).coefficients(k)
    }

    fn sum(&self, h: S, out: &mut [S]) {
        (**self).sum(h, out);
    }

    fn shown(&self) -> f64 {
        (**self).shown()
    }

    fn has_branches(&self) -> bool {
        (**self).has_branches()
    }
}
