//! Taylor models: functions of one parameter as polynomials with a bound of the remainder.
//!
//! A model of f over tau in [-1, 1] is a polynomial p and a number r with |f - p| <= r throughout. Operations preserve
//! this: terms of a product above the degree, and rounding errors, are added to r. Interval arithmetic loses the
//! dependence between its numbers, so that sums of large cancelling terms stay wide. A model loses only r, a high power
//! of the width, and allows wide ranges of a parameter.

//!
//! A model with one coefficient is an enclosed number; with a double-double coefficient it is a number to thirty
//! digits, for long computations in which rounding errors of floats would grow too much.

mod functions;
mod rounded;
mod scalar;

pub use rounded::Rounded;

use super::{Enclosure, Ordered};
use field::{DoubleDouble, Rational};

/// The polynomial p(tau) with N coefficients, and the remainder [-off, off].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Model<C, const N: usize> {
    coefficients: [C; N],
    off: f64,
}

/// A function over a range of the parameter, of degree eight.
pub type TaylorModel = Model<f64, 9>;
/// One enclosed number, to thirty digits.
pub type Ball = Model<DoubleDouble, 1>;

/// A sum of at most some tens of nonnegative numbers, rounded up.
fn up(sum: f64) -> f64 {
    if sum == 0.0 { 0.0 } else { sum * (1.0 + 64.0 * f64::EPSILON) + f64::MIN_POSITIVE }
}

impl<C: Rounded, const N: usize> Model<C, N> {
    /// A number that does not depend on the parameter, exactly this float.
    pub fn constant(value: f64) -> Self {
        Self::number(C::lift(value))
    }

    /// A constant of the coefficient type, exactly.
    pub fn number(value: C) -> Self {
        let mut coefficients = [C::zero(); N];
        coefficients[0] = value;
        Model { coefficients, off: 0.0 }
    }

    /// A constant within an enclosure.
    pub fn enclosed(value: &Enclosure) -> Self {
        let [low, high] = value.ends();
        let middle = low + 0.5 * (high - low);
        Model { off: up((high - middle).max(middle - low)), ..Self::constant(middle) }
    }

    /// The parameter itself, with the range from `low` to `high`.
    pub fn over_range(low: f64, high: f64) -> Self {
        let middle = low + 0.5 * (high - low);
        let (mut range, reach) = (Self::constant(middle), up((high - middle).max(middle - low)));
        match range.coefficients.get_mut(1) {
            Some(first) => *first = C::lift(reach),
            None => range.off = reach,
        }
        range
    }

    /// The Chebyshev nodes for interpolation by a polynomial of this degree.
    pub fn nodes() -> [f64; N] {
        std::array::from_fn(|k| (std::f64::consts::PI * (2 * k + 1) as f64 / (2 * N) as f64).cos())
    }

    /// The interpolating polynomial through values at these nodes, by Newton's divided differences. It encloses
    /// nothing.
    pub fn through(values: [f64; N]) -> Self {
        let (nodes, mut divided) = (Self::nodes(), values);
        for order in 1..N {
            for k in (order..N).rev() {
                divided[k] = (divided[k] - divided[k - 1]) / (nodes[k] - nodes[k - order]);
            }
        }
        let mut coefficients = [0.0; N];
        for k in (0..N).rev() {
            // times tau - node, plus the next difference
            for place in (0..N).rev() {
                let lower = if place == 0 { divided[k] } else { coefficients[place - 1] };
                coefficients[place] = lower - nodes[k] * coefficients[place];
            }
        }
        Model { coefficients: coefficients.map(C::lift), off: 0.0 }
    }

    /// The value of the polynomial.
    pub fn at(&self, tau: f64) -> f64 {
        self.coefficients.iter().rev().fold(C::zero(), |sum, c| sum * C::lift(tau) + *c).near()
    }

    /// An upper bound of |f|.
    pub fn size(&self) -> f64 {
        up(self.coefficients.iter().map(|c| c.size()).sum::<f64>() + self.off)
    }

    /// A lower bound of |f|; zero where f may vanish, NaN where there is no bound.
    pub fn least(&self) -> f64 {
        let least = (self.coefficients[0].size() - self.spread()) * (1.0 - 8.0 * f64::EPSILON);
        if least < 0.0 { 0.0 } else { least }
    }

    /// The constant term.
    pub fn middle(&self) -> C {
        self.coefficients[0]
    }

    /// The bound of the remainder.
    pub fn left(&self) -> f64 {
        self.off
    }

    /// The largest distance of the values from the constant term.
    fn spread(&self) -> f64 {
        up(self.coefficients[1..].iter().map(|c| c.size()).sum::<f64>() + self.off)
    }

    /// The model without its remainder.
    pub fn polynomial(mut self) -> Self {
        self.off = 0.0;
        self
    }

    fn is_zero(&self) -> bool {
        self.off == 0.0 && self.coefficients == [C::zero(); N]
    }

    /// The model with a remainder increased by `by`.
    pub fn wider(mut self, by: f64) -> Self {
        self.off = up(self.off + by);
        self
    }

    /// 1/f by the geometric series about the constant term; `None` where f may vanish, or nearly so.
    fn reciprocal(&self) -> Option<Self> {
        let middle = self.coefficients[0];
        let about = Model { coefficients: Self::rest(self.coefficients), off: self.off };
        let inverse = Self::number(C::one() / middle).wider(C::ROUNDING / middle.size());
        let part = about.times(&inverse);
        let size = part.size();
        if middle.is_zero() || size.is_nan() || size >= 1.0 {
            return None;
        }
        let one = Self::constant(1.0);
        let (mut sum, mut left) = (one, size);
        for _ in 1..N {
            // the further terms are below rounding
            if left < C::ROUNDING * C::ROUNDING {
                break;
            }
            sum = one.minus(&part.times(&sum));
            left = up(left * size);
        }
        Some(sum.wider(up(left / (1.0 - size).next_down())).times(&inverse))
    }

    fn rest(mut coefficients: [C; N]) -> [C; N] {
        coefficients[0] = C::zero();
        coefficients
    }
}

impl<C: Rounded, const N: usize> Ordered for Model<C, N> {
    fn fraction(&self, value: Rational) -> Option<Self> {
        let (near, exact) = C::nearest(value);
        near.size().is_finite().then(|| Self::number(near).wider(if exact { 0.0 } else { C::ROUNDING * near.size() }))
    }

    fn integer(&self, n: i64) -> Self {
        let exact = n.unsigned_abs() <= 1 << f64::MANTISSA_DIGITS;
        Self::number(C::int(n)).wider(if exact { 0.0 } else { C::ROUNDING * (n as f64).abs() })
    }

    fn plus(&self, b: &Self) -> Self {
        let coefficients = std::array::from_fn(|k| self.coefficients[k] + b.coefficients[k]);
        if self.is_zero() || b.is_zero() {
            return if self.is_zero() { *b } else { *self };
        }
        let rounded: f64 = coefficients.iter().map(|c: &C| c.size()).sum();
        Model { coefficients, off: up(self.off + b.off + C::ROUNDING * rounded) }
    }

    fn minus(&self, b: &Self) -> Self {
        let negative = Model { coefficients: b.coefficients.map(|c| -c), off: b.off };
        self.plus(&negative)
    }

    fn times(&self, b: &Self) -> Self {
        // zero times a model with a finite bound is zero; otherwise an unbounded factor gives an unbounded product
        if (self.is_zero() && b.off.is_finite()) || (b.is_zero() && self.off.is_finite()) {
            return Self::constant(0.0);
        }
        let mut coefficients = [C::zero(); N];
        for (i, x) in self.coefficients.iter().enumerate() {
            for (c, y) in coefficients[i..].iter_mut().zip(&b.coefficients) {
                *c += *x * *y;
            }
        }
        let sizes = |model: &Self| model.coefficients.iter().map(|c| c.size()).sum::<f64>();
        let [own, other] = [sizes(self), sizes(b)];
        // terms above the degree: each coefficient with those whose product is too high
        let (mut high, mut beyond) = (0.0, 0.0);
        for (x, y) in self.coefficients[1..].iter().zip(b.coefficients[1..].iter().rev()) {
            high += y.size();
            beyond += x.size() * high;
        }
        let open = own * b.off + other * self.off + self.off * b.off;
        // coefficient i + j is a sum of i + j + 1 <= (i + 1)(j + 1) products, each rounded with its sum
        let weighed = |model: &Self| (1..).zip(&model.coefficients).map(|(k, c)| f64::from(k) * c.size()).sum::<f64>();
        let rounded = C::ROUNDING * weighed(self) * weighed(b);
        // products that underflow contribute less than the smallest normal float
        let off = up(up(open) + up(beyond) + rounded) + f64::MIN_POSITIVE;
        Model { coefficients, off }
    }

    fn over(&self, b: &Self) -> Option<Self> {
        Some(self.times(&b.reciprocal()?))
    }

    fn root(&self) -> Option<Self> {
        self.square_root()
    }

    fn sign(&self) -> Option<i32> {
        let (middle, spread) = (self.coefficients[0].near(), self.spread());
        if self.is_zero() {
            return Some(0);
        }
        // not by negation: NaN has no sign
        (middle.abs() > spread).then_some(if middle > 0.0 { 1 } else { -1 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares a model with the function in floats at points of the range, and its remainder with `most`.
    pub(super) fn holds(model: &TaylorModel, f: impl Fn(f64) -> f64, [low, high]: [f64; 2], most: f64) {
        for k in 0..=20 {
            let tau = f64::from(k) / 10.0 - 1.0;
            let x = 0.5 * (low + high) + 0.5 * (high - low) * tau;
            let off = (model.at(tau) - f(x)).abs();
            assert!(off <= model.off + 4e-15 * f(x).abs(), "at {x}: {off:e} against {:e}", model.off);
        }
        assert!(model.off <= most * model.size(), "{:e} of {:e}", model.off, model.size());
    }

    #[test]
    fn a_model_holds_its_function_and_hardly_more() {
        let ends = [0.9, 1.1];
        let x = TaylorModel::over_range(ends[0], ends[1]);
        let cube = x.times(&x).times(&x);
        holds(&cube, |x| x * x * x, ends, 1e-14);
        holds(
            &TaylorModel::constant(1.0).over(&cube.plus(&x)).expect("it is positive"),
            |x| 1.0 / (x * x * x + x),
            ends,
            1e-4,
        );
        for rate in [-30.0, -3.0, 1e-3, 0.2, 10.0] {
            let scaled = x.times(&TaylorModel::constant(rate));
            let point = TaylorModel::constant(rate);
            assert!(point.exp().is_some_and(|point| point.off < 1e-14 * (1.0 + rate.abs()) * rate.exp()));
            assert!(point.faded().is_some_and(|point| point.off < 1e-14 * (1.0 + rate.abs()) * point.size()));
            holds(&scaled.exp().expect("it is small"), |x| (rate * x).exp(), ends, 1e-2);
            holds(&scaled.faded().expect("it is small"), |x| -(-rate * x).exp_m1() / (rate * x), ends, 1e-2);
        }
    }

    /// (1 + x)^2 - 1 - 2x - x^2 = 0 over a wide range, where interval arithmetic would return a wide interval.
    #[test]
    fn what_cancels_leaves_rounding_alone() {
        let one = TaylorModel::constant(1.0);
        let x = TaylorModel::over_range(0.0, 10.0);
        let sum = one.plus(&x);
        let left = sum.times(&sum).minus(&one).minus(&x.plus(&x)).minus(&x.times(&x));
        assert!(left.size() < 1e-12 && left.sign().is_none(), "{left:?}");
    }

    #[test]
    fn a_sign_is_told_where_all_values_have_it() {
        let x = TaylorModel::over_range(1.0, 2.0);
        let shifted = |by: f64| x.minus(&TaylorModel::constant(by)).sign();
        assert_eq!([0.999, 1.4, 1.5, 2.001].map(shifted), [Some(1), None, None, Some(-1)]);
        assert_eq!(TaylorModel::constant(0.0).sign(), Some(0));
        assert_eq!(TaylorModel::constant(f64::NAN).sign(), None);
        assert_eq!(
            (x.over(&x.minus(&TaylorModel::constant(1.5))), x.times(&TaylorModel::constant(1e9)).exp()),
            (None, None)
        );
    }

    /// 1/3 is no float, 1/2 is one; an enclosure is contained from end to end.
    #[test]
    fn numbers_that_are_no_floats_are_held() {
        let one = TaylorModel::constant(1.0);
        let third = one.fraction(Rational::new(1, 3)).expect("it is a number");
        let apart = third.times(&one.integer(3)).minus(&one);
        assert!(third.off > 0.0 && apart.sign().is_none() && apart.size() < 1e-15);
        assert_eq!(one.fraction(Rational::new(1, 2)), Some(TaylorModel::constant(0.5)));
        let wide = Enclosure::integer(1, 64).hull(&Enclosure::integer(3, 64));
        let model = TaylorModel::enclosed(&wide);
        assert!((model.at(0.0) - 2.0).abs() < 1e-12 && (1.0..1.001).contains(&model.off));
    }
}
