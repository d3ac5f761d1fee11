//! The dual numbers of `num-dual` over `f64` as scalars, for Jacobians and Hessians.

use crate::{Analytic, Circle, Elementary, Over, Scalar};
use num_dual::{Dual, Dual2, DualNum, DualSVec, DualStruct, HyperDual};

/// The argument above which the derivative of tanh underflows.
const FLAT: f64 = 300.0;

macro_rules! dual_field {
    ($(($type:ty, [$($generics:tt)*])),* $(,)?) => {$(
        impl<$($generics)*> Scalar for $type {
            fn ratio(numerator: i64, denominator: i64) -> Self {
                Self::from(f64::ratio(numerator, denominator))
            }
        }

        impl<$($generics)*> Over<f64> for $type {
            #[inline]
            fn lift(parameter: f64) -> Self {
                Self::from(parameter)
            }
        }

        impl<$($generics)*> Analytic for $type {
            #[inline]
            fn circle(self) -> Circle<Self> {
                let (sin, cos) = DualNum::sin_cos(&self);
                Circle { cos, sin }
            }

            fn sqrt(self) -> Self {
                DualNum::sqrt(&self)
            }

            fn elementary(self, function: Elementary, other: Self) -> Self {
                match function {
                    Elementary::Exp => DualNum::exp(&self),
                    Elementary::Ln => DualNum::ln(&self),
                    // num-dual divides sinh by cosh, which overflow for large arguments
                    Elementary::Tanh if self.re().abs() > FLAT => Self::from(self.re().signum()),
                    Elementary::Tanh => DualNum::tanh(&self),
                    Elementary::Atan2 => DualNum::atan2(&self, other),
                }
            }
        }
    )*};
}

dual_field!(
    (Dual<f64>, []),
    (Dual2<f64>, []),
    (HyperDual<f64>, []),
    (DualSVec<f64, N>, [const N: usize]),
);

#[cfg(test)]
mod tests {
    use crate::{Analytic, DoubleDouble, Elementary};
    use num_dual::Dual64;

    #[test]
    fn tanh_is_flat_where_its_argument_is_large() {
        for a in [299.0, 301.0, 800.0, 1e6, 1e300, -800.0, -1e6] {
            let number = Dual64::from(a).derivative();
            let tanh = number.elementary(Elementary::Tanh, number);
            assert!(tanh.re == a.signum() && tanh.eps.abs() < 1e-12, "{a} {tanh}");
            let exact = DoubleDouble::from(a);
            assert_eq!(exact.elementary(Elementary::Tanh, exact), DoubleDouble::from(a.signum()), "{a}");
        }
    }
}
