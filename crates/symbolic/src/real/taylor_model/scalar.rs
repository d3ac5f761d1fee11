//! Taylor models as a field: laws run over them as they do over numbers.
//!
//! A law has no way to say that a denominator may vanish. What is not known to be a number then has no bound, nothing that comes of
//! it has one, and it has no sign.

use super::TaylorModel;
use crate::real::Ordered;
use field::{Analytic, Base, Circle, Over, Scalar};
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

impl TaylorModel {
    fn none() -> Self {
        Self::constant(0.0).wider(f64::NAN)
    }
}

impl Add for TaylorModel {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        self.plus(&b)
    }
}

impl Sub for TaylorModel {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self.minus(&b)
    }
}

impl Mul for TaylorModel {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        self.times(&b)
    }
}

impl Div for TaylorModel {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        self.over(&b).unwrap_or_else(Self::none)
    }
}

/// In a field every remainder is zero (nalgebra and num-traits ask for the operator).
impl Rem for TaylorModel {
    type Output = Self;
    fn rem(self, b: Self) -> Self {
        if b.sign().is_some_and(|sign| sign != 0) { Self::zero() } else { Self::none() }
    }
}

impl Neg for TaylorModel {
    type Output = Self;
    fn neg(self) -> Self {
        TaylorModel { coefficients: self.coefficients.map(|c| -c), off: self.off }
    }
}

macro_rules! assign {
    ($($op:ident $method:ident $sign:tt),*) => {$(
        impl $op for TaylorModel {
            fn $method(&mut self, b: Self) {
                *self = *self $sign b;
            }
        }
    )*};
}
assign!(AddAssign add_assign +, SubAssign sub_assign -, MulAssign mul_assign *, DivAssign div_assign /, RemAssign rem_assign %);

impl Zero for TaylorModel {
    fn zero() -> Self {
        Self::constant(0.0)
    }

    fn is_zero(&self) -> bool {
        TaylorModel::is_zero(self)
    }
}

impl One for TaylorModel {
    fn one() -> Self {
        Self::constant(1.0)
    }
}

impl Scalar for TaylorModel {
    fn ratio(numerator: i64, denominator: i64) -> Self {
        let unit = Self::one();
        unit.integer(numerator) / unit.integer(denominator)
    }

    fn half(self) -> Self {
        // exact but for what is too small for floats
        let halved = TaylorModel { coefficients: self.coefficients.map(|c| 0.5 * c), off: 0.5 * self.off };
        if self.is_zero() { self } else { halved.wider(f64::MIN_POSITIVE) }
    }
}

impl Base for TaylorModel {}

impl Over<TaylorModel> for TaylorModel {
    fn lift(parameter: TaylorModel) -> Self {
        parameter
    }
}

impl Over<f64> for TaylorModel {
    fn lift(parameter: f64) -> Self {
        if parameter.is_finite() { Self::constant(parameter) } else { Self::none() }
    }
}

impl Analytic for TaylorModel {
    fn circle(self) -> Circle<Self> {
        let [cos, sin] = self.cos_sin().unwrap_or_else(|| [Self::none(); 2]);
        Circle { cos, sin }
    }

    fn sqrt(self) -> Self {
        if self.is_zero() { self } else { self.square_root().unwrap_or_else(Self::none) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same law over floats and over models, at points of the range.
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
