//! Rounding from a finer field to `f64`.

use crate::fused::Fused;
use crate::pick::Pick;
use crate::small::permutation::Permute;
use crate::small::wide::Wide;
use crate::stored::Stored;

/// Rounds numbers in memory.
#[inline(always)]
pub(super) fn round<S: Fused, const N: usize>(own: &mut [[Wide<f64>; N]], finer: &[[Wide<S>; N]]) {
    for (own, finer) in own.as_flattened_mut().iter_mut().zip(finer.as_flattened()) {
        own.0 = finer.0.rounded();
    }
}

/// Rounds numbers in registers.
#[inline(always)]
pub(super) fn rounded<S: Fused, P: Permute<S> + Permute<f64>, const N: usize>(
    pick: P,
    finer: &[<P as Pick<S>>::Eight; N],
) -> [<P as Pick<f64>>::Eight; N] {
    let mut rounded = [Pick::<f64>::all(pick, 0.0); N];
    for (own, finer) in rounded.iter_mut().zip(finer) {
        *own = Pick::<f64>::load(pick, &Pick::<S>::store(pick, *finer).rounded());
    }
    rounded
}
