//! Small right-hand sides, y' = c + L y + sum_p w_p a_p b_p with few quantities. Most scenes have such a one, and an order of
//! its series is so little work that latency is most of its cost.
//!
//! The kernels need a processor that permutes eight numbers by one instruction. Without it, [stages](super::stages) take
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

/// Groups of eight quantities, and of eight products.
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

/// Runs an expression on the kernel of whichever size.
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

/// A way of expanding small right-hand sides.
pub(super) trait SmallSeries<S>: Clone + std::fmt::Debug {
    /// Room for one, without its coefficients; `None` where there is no such way on this processor.
    fn new(law: &Law) -> Option<Self>;

    /// Takes the values of the coefficients.
    fn set(&mut self, values: &[S]);

    /// Expands the solution whose first coefficients stand at the head of the series, which has a row of whole groups of
    /// eight for each order. In a finer field the coefficients after the order `fine` have the digits of `f64`, or more.
    fn expand(&mut self, series: &mut [S], fine: usize);
}

/// One implementation for each field: generic code would be compiled anew in every crate that expands something.
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

/// The small series of fields without kernels: none.
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
