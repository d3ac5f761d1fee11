//! Eight numbers in memory.

use super::fused::Fused;
use field::DoubleDouble;
use std::fmt::Debug;

/// Eight numbers of a scalar type, ready to be loaded into registers.
pub(crate) trait Stored<S>: Copy + Debug {
    fn of(numbers: [S; 8]) -> Self;

    fn lane(&self, lane: usize) -> S;

    fn set(&mut self, lane: usize, number: S);

    /// The numbers rounded to `f64`.
    #[inline(always)]
    fn rounded(&self) -> [f64; 8]
    where
        S: Fused,
    {
        std::array::from_fn(|lane| self.lane(lane).rounded())
    }
}

impl<S: Copy + Debug> Stored<S> for [S; 8] {
    #[inline(always)]
    fn of(numbers: [S; 8]) -> Self {
        numbers
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> S {
        self[lane % 8]
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, number: S) {
        self[lane % 8] = number;
    }
}

/// Eight double-double numbers: all high parts, then all low parts.
#[derive(Clone, Copy, Debug)]
pub struct Parts {
    pub(super) first: [f64; 8],
    pub(super) rest: [f64; 8],
}

impl Stored<DoubleDouble> for Parts {
    #[inline(always)]
    fn of(numbers: [DoubleDouble; 8]) -> Self {
        Parts { first: numbers.map(DoubleDouble::hi), rest: numbers.map(DoubleDouble::lo) }
    }

    #[inline(always)]
    fn lane(&self, lane: usize) -> DoubleDouble {
        DoubleDouble::from(self.first[lane % 8]) + self.rest[lane % 8]
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, number: DoubleDouble) {
        (self.first[lane % 8], self.rest[lane % 8]) = (number.hi(), number.lo());
    }

    #[inline(always)]
    fn rounded(&self) -> [f64; 8] {
        self.first
    }
}
