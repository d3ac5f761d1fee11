//! Exponentials, cosines, sines and square roots of Taylor models.

use super::{Model, Rounded, up};
use crate::real::Ordered;

/// The largest argument for which Taylor series are used directly.
pub(super) const SMALL: f64 = 0.25;
/// Below -MOST the exponential is at most GONE. Larger magnitudes are rejected: no range may extend across this limit.
const MOST: f64 = 600.0;
const GONE: f64 = 3e-261;
/// The largest angle, rad; above, sines would lose their digits.
const MOST_ANGLE: f64 = 1e5;

impl<C: Rounded, const N: usize> Model<C, N> {
    /// The quotient by a nonzero number.
    fn shared(&self, by: f64) -> Self {
        let coefficients = self.coefficients.map(|c| c / C::lift(by));
        let rounded: f64 = coefficients.iter().map(|c| c.size()).sum();
        let open = (self.off / by).abs() + C::ROUNDING * rounded;
        // the bound includes quotients that underflow
        Model { coefficients, off: up(up(open)) + f64::MIN_POSITIVE }
    }

    /// exp f; `None` where f may exceed some hundreds, or where its range extends from there to far below.
    pub fn exp(&self) -> Option<Self> {
        let size = self.size();
        if self.coefficients[0].near() + self.spread() < -MOST {
            return Some(Self::constant(0.0).wider(GONE));
        }
        if size.is_nan() || size > 1.1 * MOST {
            return None;
        }
        let halvings = (size / SMALL).log2().ceil().max(0.0) as i32;
        // a power of two: exact
        let part = self.times(&Self::constant(0.5f64.powi(halvings)));
        let mut sum = Self::constant(1.0);
        for k in (1..=C::TERMS).rev() {
            sum = Self::constant(1.0).plus(&part.times(&sum).shared(k.into()));
        }
        let mut power = sum.wider(C::LEFT);
        for _ in 0..halvings {
            power = power.times(&power);
        }
        Some(power)
    }

    /// The function (1 - exp(-f))/f, also for small or vanishing f.
    pub fn faded(&self) -> Option<Self> {
        let negative = Self::constant(0.0).minus(self);
        if self.size() > SMALL {
            return Self::constant(1.0).minus(&negative.exp()?).over(self);
        }
        // the series sum (-f)^k/(k + 1)!
        let mut sum = Self::constant(1.0);
        for k in (2..=C::TERMS + 1).rev() {
            sum = Self::constant(1.0).plus(&negative.times(&sum).shared(k.into()));
        }
        Some(sum.wider(C::LEFT))
    }

    /// The function (exp(-a) - exp(-b))/(b - a), also for close arguments; `None` where an exponential would overflow.
    pub fn between_decays(a: &Self, b: &Self) -> Option<Self> {
        let gap = b.minus(a);
        // the slower decay times a function of the gap: neither factor grows, in either direction of time
        let [slower, gap] = if gap.coefficients[0].near() < 0.0 { [b, &a.minus(b)] } else { [a, &gap] };
        Some(Self::constant(0.0).minus(slower).exp()?.times(&gap.faded()?))
    }

    /// [cos f, sin f]; `None` where f may be large.
    pub fn cos_sin(&self) -> Option<[Self; 2]> {
        let size = self.size();
        if size.is_nan() || size > MOST_ANGLE {
            return None;
        }
        let halvings = (size / SMALL).log2().ceil().max(0.0) as i32;
        let part = self.times(&Self::constant(0.5f64.powi(halvings)));
        let square = part.times(&part);
        let (mut cos, mut sine) = (Self::constant(1.0), Self::constant(1.0));
        for k in (1..=C::TERMS / 2).rev().map(f64::from) {
            cos = Self::constant(1.0).minus(&square.times(&cos).shared(2.0 * k * (2.0 * k - 1.0)));
            sine = Self::constant(1.0).minus(&square.times(&sine).shared(2.0 * k * (2.0 * k + 1.0)));
        }
        let (mut cos, mut sin) = (cos.wider(C::LEFT), part.times(&sine.wider(C::LEFT)));
        for _ in 0..halvings {
            let half = sin.times(&cos);
            // 1 - 2 sin^2 halves the angle without an error of cos^2 + sin^2
            let square = sin.times(&sin);
            cos = Self::constant(1.0).minus(&square.plus(&square));
            sin = half.plus(&half);
        }
        Some([cos, sin])
    }

    /// The square root; `None` where f may be zero or negative.
    pub(super) fn square_root(&self) -> Option<Self> {
        let middle = self.coefficients[0];
        if !middle.size().is_finite() || middle.near() <= 0.0 {
            return None;
        }
        // the root of the constant, times the binomial series of sqrt(1 + u)
        let part = Self { coefficients: Self::rest(self.coefficients), ..*self }.over(&Self::number(middle))?;
        let size = part.size();
        if size.is_nan() || size >= 1.0 {
            return None;
        }
        let ratio = |k: usize| (1.0 - 2.0 * k as f64, 2.0 * k as f64 + 2.0);
        let mut sum = Self::constant(1.0);
        for (over, under) in (1..N).map(|k| k - 1).rev().map(ratio) {
            sum = Self::constant(1.0).plus(&part.times(&sum).times(&Self::constant(over)).shared(under));
        }
        let left = (0..N).map(ratio).fold(1.0, |left, (over, under)| up(left * size * over.abs() / under));
        let root = middle.sqrt();
        Some(sum.wider(up(left / (1.0 - size).next_down())).times(&Self::number(root).wider(C::ROUNDING * root.size())))
    }
}

#[cfg(test)]
mod tests {
    use super::super::TaylorModel;
    use super::super::tests::holds;
    use super::*;

    #[test]
    fn angles_and_roots_hold_their_functions() {
        for middle in [0.0, 0.1, -3.0, 20.0] {
            let ends = [middle - 0.2, middle + 0.2];
            let x = TaylorModel::over_range(ends[0], ends[1]);
            let [cos, sin] = x.cos_sin().expect("it is small");
            holds(&cos, f64::cos, ends, 1e-8);
            holds(&sin, f64::sin, ends, 1e-8);
            let point = TaylorModel::constant(middle).cos_sin().expect("it is small");
            assert!(point.iter().all(|value| value.off < 1e-12), "{point:?}");
        }
        let x = TaylorModel::over_range(1.8, 2.2);
        holds(&x.square_root().expect("it is positive"), f64::sqrt, [1.8, 2.2], 1e-9);
        let four = TaylorModel::constant(4.0).square_root().expect("it is positive");
        assert!(four.off < 1e-14 && four.at(0.0) == 2.0);
        assert_eq!(TaylorModel::over_range(-0.1, 2.0).square_root(), None);
        assert_eq!(TaylorModel::constant(1e6).cos_sin(), None);
    }

    #[test]
    fn the_quotient_of_decays_does_not_mind_their_order_nor_that_they_meet() {
        let ends = [0.5, 0.6];
        let x = TaylorModel::over_range(ends[0], ends[1]);
        for rate in [0.0, 1.0, 1.0 + 1e-9, 40.0] {
            let other = x.times(&TaylorModel::constant(rate));
            let exact = |x: f64| {
                let gap = (rate - 1.0) * x;
                (-x).exp() * if gap.abs() < 1e-6 { 1.0 - 0.5 * gap } else { -(-gap).exp_m1() / gap }
            };
            for pair in [[x, other], [other, x]] {
                let quotient = TaylorModel::between_decays(&pair[0], &pair[1]).expect("they are small");
                holds(&quotient, exact, ends, 1e-4);
            }
        }
    }
}
