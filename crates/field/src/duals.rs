//! num-dual's numbers over `f64` as scalars: the Jacobians and Hessians of the simulation.

use crate::{Analytic, Circle, Elementary, Over, Scalar};
use num_dual::{Dual, Dual2, DualNum, DualSVec, HyperDual};

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
