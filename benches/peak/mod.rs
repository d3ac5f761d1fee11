//! The peak floating-point rate of one core of this processor.

use pulp::{Arch, Simd, WithSimd};
use std::hint::black_box;
use std::time::Instant;

const REPEATS: usize = 9;
const CALLS: u32 = 200_000;

/// Additions and multiplications per nanosecond, measured on independent chains of operations.
pub fn flops_per_nanosecond() -> f64 {
    struct Chains;
    impl WithSimd for Chains {
        type Output = f64;

        #[inline(always)]
        fn with_simd<S: Simd>(self, simd: S) -> f64 {
            const CHAINS: usize = 16;
            let (factor, term) = (simd.splat_f64s(black_box(0.999)), simd.splat_f64s(black_box(1e-3)));
            let mut sums = [simd.splat_f64s(black_box(1.0)); CHAINS];
            let start = Instant::now();
            for _ in 0..CALLS {
                for sum in &mut sums {
                    *sum = simd.mul_add_f64s(factor, *sum, term);
                }
            }
            let time = start.elapsed().as_secs_f64() * 1e9;
            black_box(sums.map(|sum| simd.reduce_sum_f64s(sum)));
            2.0 * (CHAINS * S::F64_LANES) as f64 * f64::from(CALLS) / time
        }
    }
    (0..REPEATS).map(|_| Arch::new().dispatch(Chains)).fold(0.0, f64::max)
}
