//! Taylor models as scalars: laws are evaluated over them as over numbers.
//!
//! A law cannot report that a denominator may vanish. A result that may be undefined is a model without a bound, as are
//! all results computed from it; such a model has no sign.

use super::{Model, Rounded};
use crate::real::Ordered;
use field::{Analytic, Base, Circle, Elementary, Interval, Over, Scalar};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

impl<C: Rounded, const N: usize> Model<C, N> {
    fn none() -> Self {
        Self::constant(0.0).wider(f64::NAN)
    }

    /// An interval that contains all values.
    fn range(&self) -> Interval {
        let middle = Interval::point(self.coefficients[0].near());
        // the constant term has more digits than a float
        let spread = self.spread() + f64::EPSILON * middle.size() + f64::MIN_POSITIVE;
        middle + Interval::new(-spread, spread)
    }
}

impl<C: Rounded, const N: usize> Add for Model<C, N> {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        self.plus(&b)
    }
}

impl<C: Rounded, const N: usize> Sub for Model<C, N> {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self.minus(&b)
    }
}

impl<C: Rounded, const N: usize> Mul for Model<C, N> {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        self.times(&b)
    }
}

impl<C: Rounded, const N: usize> Div for Model<C, N> {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        self.over(&b).unwrap_or_else(Self::none)
    }
}

/// In a field every remainder is zero (nalgebra and num-traits ask for the operator).
impl<C: Rounded, const N: usize> Rem for Model<C, N> {
    type Output = Self;
    fn rem(self, b: Self) -> Self {
        if b.sign().is_some_and(|sign| sign != 0) { Self::zero() } else { Self::none() }
    }
}

impl<C: Rounded, const N: usize> Neg for Model<C, N> {
    type Output = Self;
    fn neg(self) -> Self {
        Model { coefficients: self.coefficients.map(|c| -c), off: self.off }
    }
}

macro_rules! assign {
    ($($op:ident $method:ident $sign:tt),*) => {$(
        impl<C: Rounded, const N: usize> $op for Model<C, N> {
            fn $method(&mut self, b: Self) {
                *self = *self $sign b;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /, RemAssign rem_assign %);

impl<C: Rounded, const N: usize> Zero for Model<C, N> {
    fn zero() -> Self {
        Self::constant(0.0)
    }

    fn is_zero(&self) -> bool {
        Model::is_zero(self)
    }
}

impl<C: Rounded, const N: usize> One for Model<C, N> {
    fn one() -> Self {
        Self::constant(1.0)
    }
}

impl<C: Rounded, const N: usize> Scalar for Model<C, N> {
    const CALLS: bool = true;

    fn ratio(numerator: i64, denominator: i64) -> Self {
        let unit = Self::one();
        unit.integer(numerator) / unit.integer(denominator)
    }

    fn half(self) -> Self {
        // exact, except for underflow
        let halved = Model { coefficients: self.coefficients.map(|c| C::lift(0.5) * c), off: 0.5 * self.off };
        if self.is_zero() { self } else { halved.wider(f64::MIN_POSITIVE) }
    }
}

impl<C: Rounded, const N: usize> Base for Model<C, N> {}

impl<C: Rounded, const N: usize> Over<Model<C, N>> for Model<C, N> {
    fn lift(parameter: Self) -> Self {
        parameter
    }
}

impl<C: Rounded, const N: usize> Over<f64> for Model<C, N> {
    fn lift(parameter: f64) -> Self {
        if parameter.is_finite() { Self::constant(parameter) } else { Self::none() }
    }
}

impl<C: Rounded, const N: usize> Analytic for Model<C, N> {
    fn circle(self) -> Circle<Self> {
        let [cos, sin] = self.cos_sin().unwrap_or_else(|| [Self::none(); 2]);
        Circle { cos, sin }
    }

    fn sqrt(self) -> Self {
        if self.is_zero() { self } else { self.square_root().unwrap_or_else(Self::none) }
    }

    /// Exponentials as models; for other functions the range of values only.
    fn elementary(self, function: Elementary, other: Self) -> Self {
        if function == Elementary::Exp {
            return self.exp().unwrap_or_else(Self::none);
        }
        let range = self.range().elementary(function, other.range());
        match range.size().is_finite() {
            true => Self::constant(range.middle()).wider(range.width()),
            false => Self::none(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::TaylorModel;
    use super::*;

    /// Compares a law over floats and over models, at points of the range.
    #[test]
    fn a_law_over_models_holds_its_values() {
        fn law<S: Analytic>(x: S) -> S {
            let turned = (x * x).half().circle();
            (turned.cos + S::ratio(1, 3)) / (turned.sin + S::int(2)) - (x + S::one()).sqrt()
        }
        let model = law(TaylorModel::over_range(0.9, 1.1));
        for k in -10..=10 {
            let tau = f64::from(k) / 10.0;
            let off = (model.at(tau) - law(1.0 + 0.1 * tau)).abs();
            assert!(off <= model.off && model.off < 1e-8, "{off:e} against {:e}", model.off);
        }
    }

    #[test]
    fn what_is_no_number_stays_none() {
        let none = TaylorModel::one() / TaylorModel::over_range(-1.0, 1.0);
        for lost in [none, none * TaylorModel::zero(), none - none, none.half(), none.circle().cos, none.sqrt()] {
            assert!(lost.sign().is_none() && !lost.size().is_finite(), "{lost:?}");
        }
    }
}
