//! Eight numbers in memory, between orders.

use crate::fused::Fused;
use crate::pick::Pick;
use crate::stored::Stored;

/// Eight numbers; eight `f64` are a cache line.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct Wide<S: Fused>(pub S::Stored);

impl<S: Fused> Wide<S> {
    pub fn zero() -> Self {
        Wide(S::Stored::of([S::zero(); 8]))
    }

    /// self + times other.
    #[inline(always)]
    pub fn plus<P: Pick<S>>(&self, pick: P, other: &Self, times: S) -> Self {
        Wide(pick.store(pick.plus_product(pick.load(&self.0), pick.load(&other.0), pick.all(times))))
    }
}
