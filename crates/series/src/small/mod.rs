//! Small right-hand sides, y' = c + L y + sum_p w_p a_p b_p with few quantities. Most scenes have one. An order of
//! their series needs so few operations that latency dominates its cost.
//!
//! The kernels need a processor with permutations of eight numbers (AVX-512). Without it, [stages](super::stages) take
//! half the time of these kernels.

mod direct;
mod factors;
mod kernel;
mod law;
mod linearisation;
mod permutation;
mod reduce;
mod round;
mod solving;
mod starts;
mod wide;
mod wide_sums;

pub(super) use factors::MOST_ORDER;
pub(super) use law::Law;
#[cfg(target_arch = "x86_64")]
pub(super) use permutation::{Permute, Shuffle};

use super::fused::Fused;
use field::DoubleDouble;
use kernel::{Expand, Kernel};
use permutation::{in_permuting, permutes};

/// Kernels by the number of groups of eight quantities and of eight products.
#[derive(Clone, Debug)]
pub enum Small<S: Fused> {
    OneOne(Box<Kernel<S, 1, 1>>),
    OneTwo(Box<Kernel<S, 1, 2>>),
    OneThree(Box<Kernel<S, 1, 3>>),
    TwoOne(Box<Kernel<S, 2, 1>>),
    TwoTwo(Box<Kernel<S, 2, 2>>),
    TwoThree(Box<Kernel<S, 2, 3>>),
    ThreeTwo(Box<Kernel<S, 3, 2>>),
    ThreeThree(Box<Kernel<S, 3, 3>>),
}

/// Evaluates an expression on the kernel of any size.
macro_rules! for_kernel {
    ($small:expr, $kernel:ident => $what:expr) => {
        match $small {
            Small::OneOne($kernel) => $what,
            Small::OneTwo($kernel) => $what,
            Small::OneThree($kernel) => $what,
            Small::TwoOne($kernel) => $what,
            Small::TwoTwo($kernel) => $what,
            Small::TwoThree($kernel) => $what,
            Small::ThreeTwo($kernel) => $what,
            Small::ThreeThree($kernel) => $what,
        }
    };
}

/// An implementation of small right-hand sides.
pub(super) trait SmallSeries<S>: Clone + std::fmt::Debug {
    /// The buffers, without coefficients; `None` where it is unavailable on this processor or for this law.
    fn new(law: &Law) -> Option<Self>;

    /// Sets the coefficients.
    fn set(&mut self, values: &[S]);

    /// Expands the solution whose first coefficients are in the first row of the series; each order has a row of whole
    /// groups of eight. In a finer type the coefficients above the order `fine` have at least the digits of `f64`.
    fn expand(&mut self, series: &mut [S], fine: usize);
}

/// One implementation for each scalar type: generic code would be compiled again in every dependent crate.
macro_rules! small_series {
    ($field:ty) => {
        impl SmallSeries<$field> for Small<$field> {
            fn new(law: &Law) -> Option<Self> {
                permutes().then(|| match (law.quantities().div_ceil(8), law.products.len().div_ceil(8)) {
                    (0 | 1, 0 | 1) => Small::OneOne(Box::new(Kernel::new(law))),
                    (0 | 1, 2) => Small::OneTwo(Box::new(Kernel::new(law))),
                    (0 | 1, _) => Small::OneThree(Box::new(Kernel::new(law))),
                    (2, 0 | 1) => Small::TwoOne(Box::new(Kernel::new(law))),
                    (2, 2) => Small::TwoTwo(Box::new(Kernel::new(law))),
                    (2, _) => Small::TwoThree(Box::new(Kernel::new(law))),
                    (_, 0..=2) => Small::ThreeTwo(Box::new(Kernel::new(law))),
                    _ => Small::ThreeThree(Box::new(Kernel::new(law))),
                })
            }

            fn set(&mut self, values: &[$field]) {
                for_kernel!(self, kernel => kernel.set(values));
            }

            fn expand(&mut self, series: &mut [$field], fine: usize) {
                for_kernel!(self, kernel => in_permuting(Expand { kernel, series, fine }));
            }
        }
    };
}

small_series!(f64);
small_series!(DoubleDouble);

/// The implementation for scalar types without kernels: none.
#[derive(Clone, Debug)]
pub enum Never {}

impl<S> SmallSeries<S> for Never {
    fn new(_: &Law) -> Option<Self> {
        None
    }

    fn set(&mut self, _: &[S]) {
        match *self {}
    }

    fn expand(&mut self, _: &mut [S], _: usize) {
        match *self {}
    }
}
