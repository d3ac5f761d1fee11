//! Small right-hand sides, y' = c + L y + sum_p w_p a_p b_p with few quantities: what most scenes come to, and where an order
//! of the series is so little work that waiting is most of it.

mod direct;
mod factors;
mod law;
mod linearised;
mod reduce;
mod round;
mod starts;
mod wide_sums;

pub(super) use factors::MOST_ORDER;
pub(super) use law::Law;

use super::fused::Fused;
use direct::Direct;
use field::DoubleDouble;
use linearised::Linearised;

/// A law, with the quantities in B groups of eight and the products in G.
#[derive(Clone, Debug)]
pub enum Kernel<S: Fused, const B: usize, const G: usize> {
    Direct(Box<Direct<S, B, G>>),
    Linearised(Box<Linearised<S, B, G>>),
}

impl<S: Fused, const B: usize, const G: usize> Kernel<S, B, G> {
    fn new(law: &Law) -> Self {
        match law.solved[..] {
            [] => Kernel::Direct(Box::new(Direct::new(law))),
            _ => Kernel::Linearised(Box::new(Linearised::new(law))),
        }
    }
}

/// Groups of eight quantities, and of eight products.
#[derive(Clone, Debug)]
pub enum Small<S: Fused> {
    OneOne(Kernel<S, 1, 1>),
    OneTwo(Kernel<S, 1, 2>),
    OneThree(Kernel<S, 1, 3>),
    TwoOne(Kernel<S, 2, 1>),
    TwoTwo(Kernel<S, 2, 2>),
    TwoThree(Kernel<S, 2, 3>),
    ThreeTwo(Kernel<S, 3, 2>),
    ThreeThree(Kernel<S, 3, 3>),
}

/// The same for each size.
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
    /// Room for one, without its coefficients; `None` where there is no such way.
    fn new(law: &Law) -> Option<Self>;

    /// Takes the values of the coefficients.
    fn set(&mut self, values: &[S]);

    /// Expands the solution whose first coefficients stand at the head of the series, which has a row of whole groups of
    /// eight for each order. Of a finer field those after the order `fine` have the digits of `f64`, or more.
    fn expand(&mut self, series: &mut [S], fine: usize);
}

/// For each field by itself: what is generic would be compiled anew in every crate that expands something.
macro_rules! small_series {
    ($field:ty) => {
        impl SmallSeries<$field> for Small<$field> {
            fn new(law: &Law) -> Option<Self> {
                Some(match (law.quantities().div_ceil(8), law.products.len().div_ceil(8)) {
                    (0 | 1, 0 | 1) => Small::OneOne(Kernel::new(law)),
                    (0 | 1, 2) => Small::OneTwo(Kernel::new(law)),
                    (0 | 1, _) => Small::OneThree(Kernel::new(law)),
                    (2, 0 | 1) => Small::TwoOne(Kernel::new(law)),
                    (2, 2) => Small::TwoTwo(Kernel::new(law)),
                    (2, _) => Small::TwoThree(Kernel::new(law)),
                    (_, 0..=2) => Small::ThreeTwo(Kernel::new(law)),
                    _ => Small::ThreeThree(Kernel::new(law)),
                })
            }

            fn set(&mut self, values: &[$field]) {
                for_kernel!(self, kernel => match kernel {
                    Kernel::Direct(law) => law.set(values),
                    Kernel::Linearised(law) => law.set(values),
                });
            }

            fn expand(&mut self, series: &mut [$field], fine: usize) {
                for_kernel!(self, kernel => match kernel {
                    Kernel::Direct(law) => <$field>::run(direct::Expand { law, series, fine }, 8),
                    Kernel::Linearised(law) => <$field>::run(linearised::Expand { law, series, fine }, 8),
                });
            }
        }
    };
}

small_series!(f64);
small_series!(DoubleDouble);

/// Of fields that have no way of their own.
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
