//! Taylor coefficients of the solutions of a law.

use field::Scalar;

/// Taylor series of the solutions of a law, by the recurrences of its expression graph.
pub trait TaylorSeries<S: Scalar> {
    /// Computes the Taylor coefficients of the solution through (t, y) up to an order.
    fn expand(&mut self, t: S, y: &[S], order: usize);

    /// As [`expand`](Self::expand), but coefficients above the order `fine` need only the digits of `f64`. Returns the
    /// order up to which the coefficients have the full precision of the type.
    fn expand_rounding(&mut self, t: S, y: &[S], order: usize, _fine: usize) -> usize {
        self.expand(t, y, order);
        order
    }

    /// The coefficients of order k of the last expansion, y^(k) / k!.
    fn coefficients(&self, k: usize) -> &[S];

    /// Evaluates the last series at the time h after the expansion point.
    fn sum(&self, h: S, out: &mut [S]);

    /// The longest step for which the series represents the law. Far from zero, for example, the terms of exp(-x)
    /// vanish, and a step to zero would miss the function.
    fn shown(&self) -> f64 {
        f64::INFINITY
    }

    /// Whether the law has square roots or angles. A series continues their smooth branch, where the law may change to
    /// another: sqrt(x^2) = |x| at x = 0.
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
