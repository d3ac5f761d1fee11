//! Registers of eight numbers with permutations by one instruction (AVX-512).

use crate::fused::Fused;
use crate::pick::Pick;
#[cfg(target_arch = "x86_64")]
use {crate::fused::widest, crate::permuting::Permuting, std::marker::PhantomData};

/// The operations of small right-hand sides on registers of eight numbers.
pub(crate) trait Permute<S: Fused>: Pick<S> {
    /// Eight numbers selected from two registers.
    fn shuffle(self, from: [Self::Eight; 2], shuffle: &Shuffle) -> Self::Eight;

    /// One of eight numbers, in all places.
    fn spread(self, from: Self::Eight, number: usize) -> Self::Eight;

    /// The number of b where the bit is set, otherwise that of a.
    fn blend(self, bits: u8, a: Self::Eight, b: Self::Eight) -> Self::Eight;

    fn plus(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;

    fn product(self, a: Self::Eight, b: Self::Eight) -> Self::Eight;
}

/// For each of eight places a number from 0 to 15 that selects from two registers; aligned to a cache line.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct Shuffle(pub [u64; 8]);

/// Work that is compiled for processors with such permutations only.
pub(crate) trait Permuted<S: Fused> {
    fn run<P: Permute<S> + Permute<f64>>(self, pick: P);
}

/// Whether this processor has such permutations.
pub(crate) fn permutes() -> bool {
    #[cfg(target_arch = "x86_64")]
    return matches!(widest(), pulp::Arch::V4(_));
    #[cfg(not(target_arch = "x86_64"))]
    return false;
}

/// Runs the work if the processor [permutes]; otherwise does nothing.
#[cfg(target_arch = "x86_64")]
#[inline]
pub(crate) fn in_permuting<S: Fused>(task: impl Permuted<S>)
where
    Permuting: Permute<S>,
{
    if let pulp::Arch::V4(widest) = widest() {
        pulp::Simd::vectorize(widest, ByPermuting(task, Permuting(widest), PhantomData));
    }
}

#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn in_permuting<S: Fused>(_: impl Permuted<S>) {}

#[cfg(target_arch = "x86_64")]
struct ByPermuting<T, S>(T, Permuting, PhantomData<S>);

#[cfg(target_arch = "x86_64")]
impl<S: Fused, T: Permuted<S>> pulp::WithSimd for ByPermuting<T, S>
where
    Permuting: Permute<S>,
{
    type Output = ();

    #[inline(always)]
    fn with_simd<I: pulp::Simd>(self, _: I) {
        self.0.run(self.1);
    }
}
